"""Real contact area in Persson's theory."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf


def persson_area_ratio(
    pressure: NDArray[np.float64], modulus: float, rms_slope: float
) -> NDArray[np.float64]:
    """A/A0 = erf(√2 p/(E* h'_rms)), the same as erf((√π/2) χ p/E*) with χ = √(8/π)/h'_rms.

    Parameters
    ----------
    pressure : ndarray
        Nominal (asperity) pressure p [Pa].
    modulus : float
        Plane-strain modulus E* [Pa].
    rms_slope : float
        Root mean square slope h'_rms of the two-dimensional surface.

    Returns
    -------
    ndarray
        Of the shape of `pressure`; equations 4-13 and 4-14 (3-32 and 3-33 to first order).
    """
    return erf(np.sqrt(2) * pressure / (modulus * rms_slope))
