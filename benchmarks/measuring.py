"""What every benchmark needs: the machine in words, CPU time of a call, orders of convergence."""

import os
import platform
import sys
import time
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path

import numpy as np


def machine() -> dict[str, str | int]:
    """The machine and the software that a dataset was measured with, as its attributes."""
    return {
        "cpu_model": _cpu_model(),
        "cores": os.cpu_count() or 0,
        "load_average": f"{os.getloadavg()[0]:.1f}",
        "python_version": sys.version.split()[0],
        **{f"{name}_version": version(name) for name in ("numpy", "scipy", "numba", "softlub")},
        "blas_threads": os.environ.get("OPENBLAS_NUM_THREADS", "not set"),
    }


def _cpu_model() -> str:
    """Model name and the numbers that tell apart models of one name, where the system says."""
    information = Path("/proc/cpuinfo")
    if not information.exists():
        return platform.processor() or platform.machine()
    entries = dict(
        map(str.strip, line.split(":", 1)) for line in information.read_text().splitlines() if ":" in line
    )
    model = entries.get("model name", platform.machine())
    numbers = [f"{name} {entries[name]}" for name in ("cpu family", "model") if name in entries]
    return f"{model} ({', '.join(numbers)})" if numbers else model


def cpu_seconds(work: Callable[[], object], repeats: int, warm_up: bool = True) -> float:
    """CPU time of the quickest of several calls, after one that warms up caches and compiled code [s]."""
    if warm_up:
        work()
    times = []
    for _ in range(repeats):
        began = time.process_time()
        work()
        times.append(time.process_time() - began)
    return min(times)


def least_squares_order(resolution: Sequence[float], error: Sequence[float]) -> float:
    """Order q of error ~ resolution^-q, by least squares over all grids."""
    return float(-np.polyfit(np.log(resolution), np.log(error), 1)[0])


def least_squares_rate(order: Sequence[float], error: Sequence[float]) -> float:
    """Factor by which the error falls with every order of the elements, by least squares."""
    return float(np.exp(-np.polyfit(order, np.log(error), 1)[0]))
