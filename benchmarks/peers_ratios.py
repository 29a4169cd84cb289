"""CPU time at equal errors, other projects' over ours: the quickest run of each that keeps both limits."""

from collections.abc import Sequence

import numpy as np
import peers_drawing
import xarray as xr
from contact_errors import meets, quickest
from contact_solvers import OURS

from softlub.figures.panel import DataFigure


def measure(parts: Sequence[xr.Dataset]) -> xr.Dataset:
    """Quickest runs over `solver`, `points` and `load`, those of the sweep over `solver`, and ratios to ours."""
    (joined,) = parts
    found = quickest(joined).merge(sweeps(joined))
    for name in ("cpu_time", "sweep_cpu_time"):
        found[f"{name}_ratio"] = found[name] / found[name].sel(solver=OURS)
    found["run"] = joined["cpu_time"].notnull().any("step")
    return found.assign_attrs(
        title="Rough contact: CPU time at equal measured errors",
        sweep_points=int(joined.attrs["sweep_points"]),
    )


def sweeps(joined: xr.Dataset) -> xr.Dataset:
    """A sweep's CPU time [s] and convolutions in all, and its largest errors.

    Of the runs that keep both limits at every load the quickest; where there is none, the last, whose errors tell.
    """
    totals = joined[["sweep_cpu_time", "sweep_convolutions"]].sum("sweep_load", skipna=False)
    errors = joined[["sweep_area_error", "sweep_gap_error"]].max("sweep_load", skipna=False)
    every = totals.merge(errors).assign(sweep_tolerance=joined["sweep_tolerance"])
    within = meets(every["sweep_area_error"], every["sweep_gap_error"])
    seconds = every["sweep_cpu_time"]
    last = seconds.notnull().cumsum("sweep_step").argmax("sweep_step")
    step = xr.where(within.any("sweep_step"), seconds.where(within).fillna(np.inf).argmin("sweep_step"), last)
    return every.isel(sweep_step=step).assign(sweep_within_limits=within.any("sweep_step"))


def draw(dataset: xr.Dataset) -> DataFigure:
    """CPU time and convolutions over the load and over the grid."""
    return peers_drawing.equal_errors(dataset)
