"""The surfaces that the source's tables 4-1 to 4-5 print, and their likes in a dataset."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

from softlub.datasets.contact_curves import inputs, surfaces

ROUNDING = 5e-3
"""Relative difference up to which an input is the printed one: tables print three digits."""


class PrintedSurface(NamedTuple):
    """A row of a table; lengths [m].

    Attributes
    ----------
    row : str
        Its id among the claims, ``"table_4_2_row_1"``.
    longest, rolloff, shortest : float
        Wavelengths λ_L, λ_r and λ_s, the latter as it must be where it is misprinted.
    hurst, size : float
    points : int
        Of one period: the printed number less one, since the source counts both edges.
    rms_roughness, rms_slope : float
        As printed.
    printed_shortest : float
        λ_s as printed, where that is another.
    """

    row: str
    longest: float
    rolloff: float
    shortest: float
    hurst: float
    size: float
    points: int
    rms_roughness: float
    rms_slope: float
    printed_shortest: float | None = None


def _row(name: str, *values: float, printed_shortest: float | None = None) -> PrintedSurface:
    longest, shortest, hurst, size, points, roughness, slope = values
    return PrintedSurface(
        f"table_{name}", longest, 1e-4, shortest, hurst, size, int(points), roughness, slope, printed_shortest
    )


PRINTED = (
    _row("4_1_row_1", 2e-4, 7.81e-7, 0.8, 4e-4, 1024, 9.58e-7, 0.2066),
    _row("4_2_row_1", 2e-4, 7.81e-7, 0.8, 4e-4, 1024, 9.58e-7, 0.2066),
    _row("4_2_row_2", 2e-4, 7.81e-7, 0.8, 4e-4, 2048, 9.64e-7, 0.2071),
    _row("4_2_row_3", 2e-4, 7.81e-7, 0.8, 4e-4, 4096, 9.63e-7, 0.2079),
    _row("4_2_row_4", 2e-4, 7.81e-7, 0.8, 4e-4, 8192, 9.70e-7, 0.2085),
    _row("4_3_row_1", 1e-4, 7.81e-7, 0.8, 2e-4, 512, 1.01e-6, 0.2120),
    _row("4_3_row_2", 2e-4, 7.81e-7, 0.8, 4e-4, 1024, 9.58e-7, 0.2066),
    _row("4_3_row_3", 4e-4, 7.81e-7, 0.8, 8e-4, 2048, 9.63e-6, 0.2069),
    _row("4_3_row_4", 8e-4, 7.81e-7, 0.8, 1.6e-3, 4096, 1.02e-6, 0.2139),
    _row("4_4_row_1", 4e-4, 6.25e-6, 0.8, 8e-4, 256, 9.57e-7, 0.1165, printed_shortest=6.25e-7),
    _row("4_4_row_2", 4e-4, 3.13e-6, 0.8, 8e-4, 512, 9.67e-7, 0.1445, printed_shortest=3.13e-7),
    _row("4_4_row_3", 4e-4, 1.56e-6, 0.8, 8e-4, 1024, 9.57e-7, 0.1738, printed_shortest=1.56e-7),
    _row("4_4_row_4", 4e-4, 7.81e-7, 0.8, 8e-4, 2048, 9.62e-7, 0.2069),
    _row("4_4_row_5", 4e-4, 3.90e-7, 0.8, 8e-4, 4096, 9.54e-7, 0.2444),
    _row("4_5_row_1", 4e-4, 7.81e-7, 0.1, 8e-4, 2048, 9.83e-7, 1.5406),
    _row("4_5_row_2", 4e-4, 7.81e-7, 0.3, 8e-4, 2048, 9.99e-7, 0.9660),
    _row("4_5_row_3", 4e-4, 7.81e-7, 0.5, 8e-4, 2048, 1.02e-6, 0.5881),
    _row("4_5_row_4", 4e-4, 7.81e-7, 0.8, 8e-4, 2048, 9.62e-7, 0.2069),
)  # fmt: skip


def rows(table: str) -> tuple[PrintedSurface, ...]:
    """The rows of one table.

    Parameters
    ----------
    table : str
        ``"table_4_2"``.

    Returns
    -------
    tuple of PrintedSurface
    """
    return tuple(printed for printed in PRINTED if printed.row.startswith(f"{table}_row"))


def find(dataset: xr.Dataset, printed: PrintedSurface) -> xr.Dataset | None:
    """The surface of a dataset that has a row's inputs.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of surfaces or of rough contact.
    printed : PrintedSurface

    Returns
    -------
    xarray.Dataset or None
        None where that surface was not run.
    """
    wanted = {
        "hurst": printed.hurst,
        "rolloff": 2 * np.pi / printed.rolloff,
        "cutoff": 2 * np.pi / printed.shortest,
        "long_cutoff": 2 * np.pi / printed.longest,
        "size": printed.size,
        "points": printed.points,
    }
    for surface in surfaces(dataset):
        known = inputs(surface)
        if all(abs(known.get(name, np.inf) / value - 1) <= ROUNDING for name, value in wanted.items()):
            return surface
    return None
