"""What a contact of given size needs in memory, and the refusal of what will not fit."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

BYTES_PER_POINT_PERIODIC = 80
"""Topography, scaled heights, five arrays and a spectrum in single, two and a spectrum in double precision."""
BYTES_PER_POINT_FREE = 340
"""The same where transforms run on the grid padded to four times as many points, with a table of influences."""
BASE_BYTES = 250e6
"""Interpreter, libraries and compiled loops."""


def estimated_bytes(shape: tuple[int, int], periodic: bool) -> float:
    """Memory that `solve` needs for a grid, in bytes.

    Parameters
    ----------
    shape : tuple of int
    periodic : bool

    Returns
    -------
    float
    """
    per_point = BYTES_PER_POINT_PERIODIC if periodic else BYTES_PER_POINT_FREE
    return BASE_BYTES + per_point * float(shape[0]) * float(shape[1])


def available_bytes() -> float:
    """Memory that this process may still take: what the machine has left, and what its control group allows."""
    limits = [float(os.sysconf("SC_PHYS_PAGES")) * float(os.sysconf("SC_PAGE_SIZE"))]
    meminfo = Path("/proc/meminfo")
    if meminfo.exists():
        for line in meminfo.read_text().splitlines():
            if line.startswith("MemAvailable:"):
                limits.append(float(line.split()[1]) * 1024)
    group = Path("/sys/fs/cgroup")
    with suppress(OSError, ValueError):  # no control group, or "max"
        limits.append(
            float((group / "memory.max").read_text()) - float((group / "memory.current").read_text())
        )
    return min(limits)


def refuse_what_will_not_fit(shape: tuple[int, int], periodic: bool) -> None:
    """Raise before work starts where a grid needs more memory than there is.

    Raises
    ------
    MemoryError
        With the estimate.
    """
    needed, available = estimated_bytes(shape, periodic), available_bytes()
    if needed > available:
        raise MemoryError(
            f"contact on {shape[0]} x {shape[1]} points needs about {needed / 1e9:.1f} GB, "
            f"{available / 1e9:.1f} GB are free: take fewer points or a machine with more memory"
        )
