"""A pressure–separation law as a table that compiled solvers evaluate.

Every contact law hands its pressure to the solvers in this one form: ln p as a piecewise cubic of ln u on evenly
spaced knots. Below the first knot the pressure goes on linearly in u (a finite stiffness in deep contact),
above the last one it decays exponentially in u (the tail of every rough contact), both with continuous slope.
A table without intervals is the law of a smooth surface: no asperity pressure anywhere.
"""

from __future__ import annotations

from typing import NamedTuple

import numba
import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]


class PressureTable(NamedTuple):
    """Piecewise cubic of ln(p / Pa) over ln(u / m).

    Attributes
    ----------
    first : float
        ln u of the first knot.
    step : float
        Distance of the knots in ln u.
    coefficients : ndarray, shape (intervals, 4)
        ln p = c0 + c1 t + c2 t² + c3 t³ with t in [0, 1] over each interval; no interval at all: p = 0.
    """

    first: float
    step: float
    coefficients: FloatArray


EMPTY_TABLE = PressureTable(0.0, 1.0, np.zeros((0, 4)))


def tabulate(separation: FloatArray, pressure: FloatArray, slope: FloatArray) -> PressureTable:
    """Cubic Hermite table through given pressures and their derivatives.

    Parameters
    ----------
    separation : ndarray, shape (n,)
        Positive, evenly spaced in its logarithm [m].
    pressure : ndarray, shape (n,)
        Positive [Pa].
    slope : ndarray, shape (n,)
        dp/du [Pa/m].

    Returns
    -------
    PressureTable

    Raises
    ------
    ValueError
        If the knots are not evenly spaced in ln u, or a pressure is not positive and finite.
    """
    log_separation = np.log(separation)
    steps = np.diff(log_separation)
    if not np.allclose(steps, steps[0], rtol=1e-8):
        raise ValueError("the separations of a pressure table must be evenly spaced in their logarithm")
    if not (np.all(np.isfinite(pressure)) and np.all(pressure > 0)):
        raise ValueError("the pressures of a pressure table must be positive and finite")
    step = float(steps.mean())
    value = np.log(pressure)
    tangent = slope * separation / pressure * step
    rise = np.diff(value)
    coefficients = np.stack(
        [
            value[:-1],
            tangent[:-1],
            3 * rise - 2 * tangent[:-1] - tangent[1:],
            tangent[:-1] + tangent[1:] - 2 * rise,
        ],
        axis=1,
    )
    return PressureTable(float(log_separation[0]), step, np.ascontiguousarray(coefficients))


@numba.njit(cache=True, error_model="numpy")
def pressure_and_slope(
    first: float, step: float, coefficients: FloatArray, separation: float
) -> tuple[float, float]:
    """Asperity pressure [Pa] and dp/du [Pa/m] at one separation [m], for compiled callers."""
    # Single entries, never rows: a view of a row costs more than the logarithm and the exponential together.
    intervals = coefficients.shape[0]
    if intervals == 0:
        return 0.0, 0.0
    position = (np.log(separation) - first) / step if separation > 0.0 else -1.0
    if position <= 0.0:
        lowest = np.exp(first)
        pressure = np.exp(coefficients[0, 0])
        slope = pressure * coefficients[0, 1] / (step * lowest)
        return pressure + slope * (separation - lowest), slope
    k = intervals - 1 if position >= intervals else int(position)
    c0, c1, c2, c3 = coefficients[k, 0], coefficients[k, 1], coefficients[k, 2], coefficients[k, 3]
    if position >= intervals:
        highest = np.exp(first + step * intervals)
        rate = (c1 + 2 * c2 + 3 * c3) / (step * highest)
        pressure = np.exp(c0 + c1 + c2 + c3 + rate * (separation - highest))
        return pressure, pressure * rate
    t = position - k
    pressure = np.exp(c0 + t * (c1 + t * (c2 + t * c3)))
    return pressure, pressure * (c1 + t * (2 * c2 + t * 3 * c3)) / (step * separation)


@numba.njit(cache=True)
def _evaluate(
    first: float, step: float, coefficients: FloatArray, separation: FloatArray
) -> tuple[FloatArray, FloatArray]:
    pressure = np.empty_like(separation)
    slope = np.empty_like(separation)
    for i in range(separation.size):
        pressure[i], slope[i] = pressure_and_slope(first, step, coefficients, separation[i])
    return pressure, slope


def evaluate(table: PressureTable, separation: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Asperity pressure [Pa] and its derivative dp/du [Pa/m] at given separations.

    Parameters
    ----------
    table : PressureTable
    separation : array_like
        Mean separation [m]; any sign, any shape.

    Returns
    -------
    pressure, slope : ndarray
        Of the shape of `separation`.
    """
    u = np.asarray(separation, dtype=float)
    pressure, slope = _evaluate(*table, np.ascontiguousarray(u.ravel()))
    return pressure.reshape(u.shape), slope.reshape(u.shape)
