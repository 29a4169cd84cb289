"""One peer on one surface, run by benchmarks/peers.py with the interpreter of the peers' own environment.

`python peer_solvers.py NAME FOLDER` reads heights.npy (period 1, E* = 1) and job.json (pressures, tolerance) from the
folder and writes cpu_time.npy and pressure.npy. It must not import softlub: the environment does not have it.
"""

import json
import resource
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

Solve = Callable[[float], np.ndarray]
ITERATIONS = 20000


def aspher(heights: np.ndarray, tolerance: float) -> Solve:
    """Nested grids down to 64 points a side, identified in single and polished in double precision."""
    import aspher as package

    gap = np.ascontiguousarray((heights.max() - heights).ravel())

    def solve(pressure: float) -> np.ndarray:
        found = package.solve_nested(
            grid_size=heights.shape[0],
            gap=gap,
            p_nominal=pressure,
            coarsest=64,
            backend="periodic",
            precision="float_then_double",
            tol=tolerance,
            max_iter=ITERATIONS,
        )
        if found.status != "converged":
            raise RuntimeError(f"ASPHER at pressure {pressure:g}: {found.status}")
        return np.asarray(found.pressure).reshape(heights.shape)

    return solve


def tamaas(heights: np.ndarray, tolerance: float) -> Solve:
    """Polonsky and Keer's conjugate gradients; the model keeps the last load's tractions to begin with."""
    import tamaas as package

    package.set_log_level(package.LogLevel.error)
    model = package.Model(package.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
    model.E, model.nu = 1.0, 0.0
    solver = package.PolonskyKeerRey(model, heights, tolerance)
    solver.max_iter = ITERATIONS

    def solve(pressure: float) -> np.ndarray:
        solver.solve(pressure)
        return np.array(model.traction).reshape(heights.shape)

    return solve


PEERS = {"aspher": aspher, "tamaas": tamaas}


def _cpu_time() -> float:
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def main(name: str, folder: Path) -> None:
    """Solve every load of the job; only the solves are timed."""
    heights = np.load(folder / "heights.npy")
    job = json.loads((folder / "job.json").read_text())
    solve = PEERS[name](heights, job["tolerance"])
    seconds, found = [], []
    for pressure in job["pressures"]:
        began = _cpu_time()
        found.append(solve(pressure))
        seconds.append(_cpu_time() - began)
    np.save(folder / "cpu_time.npy", seconds)
    np.save(folder / "pressure.npy", found)


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
