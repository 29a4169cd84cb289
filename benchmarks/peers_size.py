"""One grid of the comparison with other projects: ladders of tolerances at single loads, every load from cold.

The time is user and system time of the solves alone, one thread. Ours includes its set-up but for the planning of
transforms, which the first call of a process pays; that call is timed apart.
"""

import os
import time
from collections.abc import Mapping

import numpy as np
import xarray as xr
from contact_errors import LARGEST_AREA_ERROR, LARGEST_GAP_ERROR, Reference, meets, quickest, surface
from contact_solvers import Solver, all_solvers

from softlub.contact import solve
from softlub.surfaces import Topography

LOADS = (1.0, 0.2, 0.05, 0.01, 1e-3)
"""p/(E*h'rms); h'rms = 1 and E* = 1 here."""
FEW_LOADS, ALL_LOADS_TO = (1.0, 0.05, 1e-3), 2048
"""On grids of more points a side."""
ONE_LOAD = 0.05
KINDS = ("tolerance", "cpu_time", "convolutions", "area_error", "gap_error")

References = Mapping[float, Reference]


def measure(points: int, python: str) -> xr.Dataset:
    """Every solver on one grid."""
    return compare(all_solvers(python), surface(points))


def compare(solvers: Mapping[str, Solver], topography: Topography) -> xr.Dataset:
    """Runs of the solvers over `solver`, `load` and `step` of the ladder; NaN where a solver was not run."""
    points = topography.heights.shape[0]
    began = time.process_time()
    solve(topography, 1.0, ONE_LOAD)
    first_call = time.process_time() - began
    loads = LOADS if points <= ALL_LOADS_TO else FEW_LOADS
    references = {load: Reference.at(topography, load) for load in loads}
    runs: dict[str, np.ndarray] = {}
    for name, solver in solvers.items():
        if solver.follows is None:
            runs[name] = climb(solver, topography, references)
        else:
            leader = table({name: runs[solver.follows]})
            runs[name] = follow(solver, topography, references, leader)
    return table(runs).assign_attrs(
        title=f"Rough contact beside other projects' solvers, {points} x {points} points",
        timed="one thread, solves alone, every load from cold; median of three calls, of fewer above 1 s",
        points=points,
        first_call_seconds=first_call,
        load_average_after=f"{os.getloadavg()[0]:.1f}",
        largest_area_error=LARGEST_AREA_ERROR,
        largest_gap_error=LARGEST_GAP_ERROR,
    )


def climb(solver: Solver, topography: Topography, references: References) -> np.ndarray:
    """A solver's runs, shape (kinds, loads, rungs): the whole ladder, or from `settled` until the limits are kept."""
    points = topography.heights.shape[0]
    whole = points <= solver.ladder_to
    left = _loads(solver, points, references)
    runs = np.full((len(KINDS), len(LOADS), len(solver.tolerances)), np.nan)
    for step in range(0 if whole else solver.settled, len(solver.tolerances)):
        if left:
            rows = [LOADS.index(load) for load in left]
            runs[:, rows, step] = costs(solver, topography, references, left, solver.tolerances[step])
            kept = meets(runs[3, rows, step], runs[4, rows, step])
            left = [load for load, done in zip(left, kept, strict=True) if whole or not done]
    return runs


def follow(solver: Solver, topography: Topography, references: References, leader: xr.Dataset) -> np.ndarray:
    """One run a load at the tolerance that suits the solver it follows, shape (kinds, loads, 1)."""
    chosen = quickest(leader)["tolerance"].fillna(solver.tolerances[-1])
    runs = np.full((len(KINDS), len(LOADS), 1), np.nan)
    for load in _loads(solver, topography.heights.shape[0], references):
        tolerance = float(chosen.sel(load=load).squeeze())
        runs[:, [LOADS.index(load)], 0] = costs(solver, topography, references, [load], tolerance)
    return runs


def costs(
    solver: Solver, topography: Topography, references: References, loads: list[float], tolerance: float
) -> np.ndarray:
    """What loads cost by themselves, and how far off the answers are, shape (kinds, loads)."""
    answer = solver.run(topography, [[load] for load in loads], tolerance)
    errors = [
        references[load].errors(pressure) for load, pressure in zip(loads, answer.pressure, strict=True)
    ]
    tolerances = np.full(len(loads), tolerance)
    return np.vstack([tolerances, answer.seconds, answer.convolutions, np.transpose(errors)])


def _loads(solver: Solver, points: int, references: References) -> list[float]:
    """Loads that a solver is given on a grid."""
    if points <= solver.loads_to:
        return list(references)
    return [ONE_LOAD] if points <= solver.largest else []


def table(runs: Mapping[str, np.ndarray]) -> xr.Dataset:
    """The runs of all solvers as one dataset."""
    steps = max(found.shape[2] for found in runs.values())
    whole = np.full((len(KINDS), len(runs), len(LOADS), steps), np.nan)
    for row, found in enumerate(runs.values()):
        whole[:, row, :, : found.shape[2]] = found
    return xr.Dataset(
        {kind: (("solver", "load", "step"), whole[n]) for n, kind in enumerate(KINDS)},
        coords={"solver": list(runs), "load": list(LOADS)},
    )
