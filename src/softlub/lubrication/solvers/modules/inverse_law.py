"""The law read backwards: the separation at which the asperities bear a given pressure (equation 3-23 for any law)."""

from __future__ import annotations

import numba
import numpy as np

from softlub.pressure_table import FloatArray, PressureTable, pressure_and_slope

DEPTH = 30.0
"""How far below and above the table ln u is searched."""


def gap_at_pressure(table: PressureTable, pressure: float) -> float:
    """Separation at which the asperity pressure has a given value, in the table's units.

    Parameters
    ----------
    table : PressureTable
    pressure : float
        Positive. Above what the law can bear at any positive separation, the smallest one searched is returned.

    Returns
    -------
    float

    Raises
    ------
    ValueError
        If the table is empty: a smooth surface bears nothing at any separation.
    """
    if table.coefficients.shape[0] == 0:
        raise ValueError("a smooth surface has no asperity pressure to be inverted")
    return float(_invert(table.first, table.step, table.coefficients, float(pressure)))


@numba.njit(cache=True, error_model="numpy")
def _invert(first: float, step: float, coefficients: FloatArray, pressure: float) -> float:
    """Newton's method on ln p over ln u, kept within a shrinking bracket by bisection."""
    low, high = first - DEPTH, first + step * coefficients.shape[0] + DEPTH
    position = first + 0.5 * step * coefficients.shape[0]
    for _ in range(100):
        separation = np.exp(position)
        found, slope = pressure_and_slope(first, step, coefficients, separation)
        # Far out the pressure underflows: only the bracket can move then.
        excess = np.log(found / pressure) if found > 0 else -np.inf
        if excess > 0:
            low = position
        else:
            high = position
        following = position - excess * found / (slope * separation) if found > 0 else low
        if not low < following < high:
            following = 0.5 * (low + high)
        if abs(following - position) <= 1e-14 * (1 + abs(position)):
            break
        position = following
    return np.exp(position)
