"""The sweep of the comparison with other projects: 20 loads on 512² points, falling from near full contact.

Ours, tamaas and ContactMechanics begin every load with the last one's pressure, ours with what the last two foretell;
ASPHER begins on coarser grids at every load, as its nested solver does, Polonsky–Keer from a uniform pressure. Each
climbs its ladder of tolerances until area and gap keep their limits at every one of the loads.
"""

import os
from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr
from contact_errors import LARGEST_AREA_ERROR, LARGEST_GAP_ERROR, Reference, meets, surface
from contact_solvers import Solver, all_solvers

POINTS = 512
SWEEP = np.geomspace(1.0, 1e-3, 20)
"""p/(E*h'rms), falling; h'rms = 1 and E* = 1 here."""
KINDS = ("cpu_time", "convolutions", "area_error", "gap_error")


def measure(python: str) -> xr.Dataset:
    """Every solver that is timed over the sweep."""
    solvers = {name: solver for name, solver in all_solvers(python).items() if solver.sweeps}
    return compare(solvers, POINTS, SWEEP)


def compare(solvers: Mapping[str, Solver], points: int, loads: Sequence[float] | np.ndarray) -> xr.Dataset:
    """Runs of the solvers over `solver`, `sweep_step` of the ladder and `sweep_load`; NaN where none was needed."""
    topography = surface(points)
    references = [Reference.at(topography, load) for load in loads]
    steps = max(len(solver.tolerances) for solver in solvers.values())
    tolerance = np.full((len(solvers), steps), np.nan)
    runs = np.full((len(KINDS), len(solvers), steps, len(loads)), np.nan)
    for row, solver in enumerate(solvers.values()):
        for step in range(solver.settled, len(solver.tolerances)):
            tolerance[row, step] = solver.tolerances[step]
            answer = solver.run(topography, [list(loads)], tolerance[row, step])
            errors = [
                reference.errors(pressure)
                for reference, pressure in zip(references, answer.pressure, strict=True)
            ]
            runs[:, row, step] = answer.seconds, answer.convolutions, *np.transpose(errors)
            if meets(runs[2, row, step], runs[3, row, step]).all():
                break
    return xr.Dataset(
        {
            "sweep_tolerance": (("solver", "sweep_step"), tolerance),
            **{
                f"sweep_{kind}": (("solver", "sweep_step", "sweep_load"), runs[n])
                for n, kind in enumerate(KINDS)
            },
        },
        coords={"solver": list(solvers), "sweep_load": np.asarray(loads)},
        attrs={
            "title": f"Rough contact beside other projects' solvers, sweep on {points} x {points} points",
            "timed": "one thread, solves alone; median of up to three sweeps where one takes less than 1 s",
            "sweep_points": points,
            "load_average_after": f"{os.getloadavg()[0]:.1f}",
            "largest_area_error": LARGEST_AREA_ERROR,
            "largest_gap_error": LARGEST_GAP_ERROR,
        },
    )
