"""Monotone interpolation with continuous slope: a cubic spline whose slopes never let it overshoot."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline, CubicSpline

FloatArray = NDArray[np.float64]


def monotone_spline(position: FloatArray, value: FloatArray) -> CubicHermiteSpline:
    """Cubic through strictly monotone points.

    Its slopes are those of the spline with continuous curvature, which is of fourth order where the points are
    smooth, bounded as far as monotony asks for (Fritsch and Carlson 1980: no slope above three times that of either
    neighbouring chord, none of the other sign).

    Parameters
    ----------
    position : ndarray, shape (n,)
        Ascending, n >= 2.
    value : ndarray, shape (n,)
        Strictly rising or strictly falling.

    Returns
    -------
    CubicHermiteSpline

    Raises
    ------
    ValueError
        If the positions do not ascend, or the values do not strictly rise or fall.
    """
    chords = np.diff(value) / np.diff(position)
    if not (np.all(np.diff(position) > 0) and (np.all(chords > 0) or np.all(chords < 0))):
        raise ValueError("points are not strictly monotone")
    slopes = np.full(value.size, chords[0])
    if value.size > 2:
        natural = "not-a-knot" if value.size > 3 else "natural"
        slopes = CubicSpline(position, value, bc_type=natural)(position, 1)
    sign = np.sign(chords[0])
    steepest = np.minimum(np.abs(np.append(chords[0], chords)), np.abs(np.append(chords, chords[-1])))
    return CubicHermiteSpline(position, value, sign * np.clip(sign * slopes, 0.0, 3 * steepest))
