"""CPU time at equal measured errors: our solver and the source's algorithm beside other projects' solvers, in one run.

The grids are jobs of their own (`peers_size`), so is the sweep (`peers_sweep`); here they are joined and drawn. What is
compared how stands in `contact_errors`, `contact_solvers` and `peer_solvers`.
"""

from collections.abc import Sequence

import numpy as np
import peers_drawing
import xarray as xr

from softlub.figures.panel import DataFigure

MEANINGS = {
    "tolerance": "tolerance, each solver's own",
    "cpu_time": "CPU time of a load",
    "convolutions": "pairs of transforms of the whole grid, those of coarser grids by their share of points",
    "area_error": "absolute error of A/A0",
    "gap_error": "root mean square error of the gap over h_rms",
    "first_call_seconds": "CPU time of the process's first solve: compiled code and plans included",
    "load_average_after": "load average of the machine after a grid was measured",
}


def measure(parts: Sequence[xr.Dataset]) -> xr.Dataset:
    """All grids over `points`, and the sweep."""
    sizes = sorted((part for part in parts if "points" in part.attrs), key=lambda part: part.attrs["points"])
    (sweep,) = [part for part in parts if "sweep_points" in part.attrs]
    points = [int(part.attrs["points"]) for part in sizes]
    grids = xr.concat(
        [part.drop_attrs() for part in sizes],
        xr.DataArray(points, dims="points", name="points"),
        join="outer",
    )
    names = list(dict.fromkeys(name for part in sizes for name in part["solver"].values.tolist()))
    joined = grids.sel(solver=names).merge(sweep.drop_attrs(), join="left")
    for name in ("first_call_seconds", "load_average_after"):
        joined[name] = ("points", np.array([float(part.attrs[name]) for part in sizes]))
    for name, variable in joined.data_vars.items():
        meaning = MEANINGS[str(name).removeprefix("sweep_")]
        variable.attrs = {"units": "s" if meaning.startswith("CPU time") else "1", "long_name": meaning}
    return joined.assign_attrs(
        {name: float(sizes[0].attrs[name]) for name in ("largest_area_error", "largest_gap_error")}
        | {
            "timed": sizes[0].attrs["timed"],
            "title": "Rough contact: CPU time against measured errors, beside other projects' solvers",
            "sweep_points": int(sweep.attrs["sweep_points"]),
            "sweep_load_average_after": sweep.attrs["load_average_after"],
        }
    )


def draw(dataset: xr.Dataset) -> DataFigure:
    """Gap error over CPU time."""
    return peers_drawing.work_precision(dataset, "gap_error")
