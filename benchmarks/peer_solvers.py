"""One peer on one surface, run by `contact_solvers` with the interpreter of the peers' own environment.

`python peer_solvers.py NAME FOLDER` reads heights.npy (period 1, E* = 1) and job.json (sequences of pressures,
tolerance) from the folder and writes cpu_time.npy, convolutions.npy and pressure.npy. It must not import softlub: the
environment does not have it.

`timed` is the one clock of every solver, ours included. A sequence of loads begins with a solver that has seen no load
yet; making it (the peers' models, operators and meshes) is not timed, what the first solve sets up is.
"""

import json
import os
import re
import resource
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

ITERATIONS = 20000
CALLS, ENOUGH = 3, 1.0
"""A sequence is solved again until it was solved so often or has taken so much CPU time in all [s]."""
FLOAT_FLOOR = 2e-6
"""Tolerance down to which ASPHER takes single precision alone, its own limit."""


class Found(NamedTuple):
    """A pressure map, and the convolutions that it took: pairs of transforms of the whole grid, NaN where unknown."""

    pressure: np.ndarray
    convolutions: float


Solve = Callable[[float], Found]
Begin = Callable[[], Solve]


def aspher(heights: np.ndarray, tolerance: float) -> Solve:
    """Nested grids from 64 points a side, in single precision as far as that carries; every load from cold.

    Its preconditioner transforms once more an iteration where it is not a stencil; that is not counted.
    """
    import aspher as package

    points = heights.shape[0]
    gap = np.ascontiguousarray((heights.max() - heights).ravel())
    precision = "float" if tolerance >= FLOAT_FLOOR else "float_then_double"

    def solve(pressure: float) -> Found:
        found = package.solve_nested(
            grid_size=points,
            gap=gap,
            p_nominal=pressure,
            coarsest=64,
            backend="periodic",
            precision=precision,
            tol=tolerance,
            max_iter=ITERATIONS,
        )
        stages = [(int(stage["name"].split(":")[1]), stage["matvec_count"]) for stage in found.stage_stats]
        convolutions = sum(count * (side / points) ** 2 for side, count in stages)
        return Found(np.asarray(found.pressure).reshape(heights.shape), convolutions)

    return solve


def tamaas(heights: np.ndarray, tolerance: float) -> Solve:
    """Polonsky and Keer's conjugate gradients; the model keeps the last load's tractions to begin with."""
    import tamaas as package

    model = package.Model(package.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
    model.E, model.nu = 1.0, 0.0
    solver = package.PolonskyKeerRey(model, heights, tolerance)
    solver.max_iter = ITERATIONS
    solver.dump_freq = 10 * ITERATIONS  # it tells the first iteration and the last

    def solve(pressure: float) -> Found:
        package.set_log_level(package.LogLevel.info)
        with _told() as told:
            solver.solve(pressure)
        iterations = [int(number) for number in re.findall(r"^\s*(\d+)\s", "".join(told), re.MULTILINE)]
        convolutions = 2 * max(iterations) + 1 if iterations else np.nan  # of the pressure, of the direction
        return Found(np.array(model.traction).reshape(heights.shape), convolutions)

    return solve


@contextmanager
def _told() -> Iterator[list[str]]:
    """Collect what a library writes to the process's error stream; complete once the context is left."""
    told: list[str] = []
    with tempfile.TemporaryFile("w+") as file:
        kept = os.dup(2)
        os.dup2(file.fileno(), 2)
        try:
            yield told
        finally:
            os.dup2(kept, 2)
            os.close(kept)
            file.seek(0)
            told.append(file.read())


def contact_mechanics(heights: np.ndarray, tolerance: float) -> Solve:
    """Polonsky and Keer's conjugate gradients in numpy; a load begins with the last one's forces, scaled.

    The tolerance is that of the penetration, over h_rms. The others (relative change of the approach, tension) stay
    at their defaults or are off: they are in units that say nothing here.
    """
    from ContactMechanics import PeriodicFFTElasticHalfSpace
    from ContactMechanics.Optimization import constrained_conjugate_gradients
    from SurfaceTopography import Topography

    surface = Topography(heights, physical_sizes=(1.0, 1.0), periodic=True)
    substrate = PeriodicFFTElasticHalfSpace(heights.shape, 1.0, (1.0, 1.0))
    options: dict[str, Any] = {"pentol": tolerance * heights.std(), "forcetol": np.inf, "maxiter": ITERATIONS}
    last: list[np.ndarray] = []

    def solve(pressure: float) -> Found:
        start = -last[-1] * (pressure / last[-1].sum()) if last else None
        found = constrained_conjugate_gradients(
            substrate, surface, external_force=pressure, initial_forces=start, **options
        )
        last[:] = [np.asarray(found.jac)]
        return Found(last[-1] * heights.size, found.nfev)

    return solve


PEERS = {"aspher": aspher, "tamaas": tamaas, "contact_mechanics": contact_mechanics}


def timed(begin: Begin, pressures: Sequence[float]) -> tuple[np.ndarray, list[Found]]:
    """Solve a sequence of loads; median of the CPU times [s] of every load, and what the last call found."""
    taken: list[list[float]] = []
    found: list[Found] = []
    while len(taken) < CALLS and np.sum(taken) < ENOUGH:
        solve, seconds = begin(), []
        found.clear()
        for pressure in pressures:
            began = _cpu_time()
            found.append(solve(pressure))
            seconds.append(_cpu_time() - began)
        taken.append(seconds)
    return np.median(taken, axis=0), found


def _cpu_time() -> float:
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def main(name: str, folder: Path) -> None:
    """Solve every sequence of the job."""
    heights = np.load(folder / "heights.npy")
    job = json.loads((folder / "job.json").read_text())
    answers = [timed(lambda: PEERS[name](heights, job["tolerance"]), part) for part in job["sequences"]]
    found = [one for _, several in answers for one in several]
    np.save(folder / "cpu_time.npy", np.concatenate([seconds for seconds, _ in answers]))
    np.save(folder / "convolutions.npy", [one.convolutions for one in found])
    np.save(folder / "pressure.npy", [one.pressure for one in found])


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
