"""CPU time at equal measured errors: our solver and the source's algorithm beside other projects' solvers, in one run.

The grids are jobs of their own (`peers_size`), so is the sweep (`peers_sweep`); here they are joined and drawn. What is
compared how stands in `contact_errors`, `contact_solvers` and `peer_solvers`.
"""

from collections.abc import Sequence

import numpy as np
import peers_drawing
import xarray as xr

from softlub.figures.panel import DataFigure

SHARED = ("timed", "largest_area_error", "largest_gap_error")


def measure(parts: Sequence[xr.Dataset]) -> xr.Dataset:
    """All grids over `points`, and the sweep."""
    sizes = sorted((part for part in parts if "points" in part.attrs), key=lambda part: part.attrs["points"])
    (sweep,) = [part for part in parts if "sweep_points" in part.attrs]
    points = [part.attrs["points"] for part in sizes]
    grids = xr.concat(
        [part.drop_attrs() for part in sizes],
        xr.DataArray(points, dims="points", name="points"),
        join="outer",
    )
    names = list(dict.fromkeys(name for part in sizes for name in part["solver"].values.tolist()))
    joined = grids.sel(solver=names).merge(sweep.drop_attrs(), join="left")
    for name in ("first_call_seconds", "load_average_after"):
        joined[name] = ("points", np.array([float(part.attrs[name]) for part in sizes]))
    return joined.assign_attrs(
        {name: sizes[0].attrs[name] for name in SHARED}
        | {
            "title": "Rough contact: CPU time against measured errors, beside other projects' solvers",
            "sweep_points": sweep.attrs["sweep_points"],
            "sweep_load_average_after": sweep.attrs["load_average_after"],
        }
    )


def draw(dataset: xr.Dataset) -> DataFigure:
    """Gap error over CPU time."""
    return peers_drawing.work_precision(dataset, "gap_error")
