"""A flat rigid punch on an elastic half-plane: the pressure that deflects evenly (Johnson 1985, section 2.8)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def pressure(position: FloatArray, half_width: float, load: float) -> FloatArray:
    """W/(π √(a² - x²)) [Pa] for |x| < a [m], W in N/m."""
    return load / (np.pi * np.sqrt(half_width**2 - position**2))


def deflection(position: FloatArray, half_width: float, load: float, modulus: float) -> FloatArray:
    """Of the kernel -(2/(πE*)) ∫ p ln|x - s| ds, less its value in contact [m].

    Parameters
    ----------
    position : ndarray
        x [m].
    half_width : float
        a [m].
    load : float
        W [N/m].
    modulus : float
        Plane-strain modulus E* [Pa].

    Returns
    -------
    ndarray
        Zero for |x| <= a, -(2W/(πE*)) arcosh(|x|/a) outside.
    """
    return -2 * load / (np.pi * modulus) * np.arccosh(np.maximum(np.abs(position) / half_width, 1.0))
