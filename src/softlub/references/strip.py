"""A pressure wave on an elastic layer that is bonded to a rigid base, in plane strain.

A layer of thickness t under p cos(qx), its surface free of shear and its base fixed, is pressed in by C(q) p cos(qx),

    C(q) = 2 (1 - ν²)/(E q) · [(3 - 4ν) sinh 2qt - 2qt] / [5 + 2 (qt)² - 4ν (3 - 2ν) + (3 - 4ν) cosh 2qt],

which is the half-plane's 2/(E* q) for qt → ∞ and that of uniaxial strain for qt → 0 (G. Carbone, L. Mangialardi,
J. Mech. Phys. Solids 56 (2008) 684).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def response(
    wavevector: FloatArray, thickness: float, young_modulus: float, poisson_ratio: float
) -> FloatArray:
    """Indentation per pressure C(q) of the layer's surface.

    Parameters
    ----------
    wavevector : ndarray
        q above 0, q t below 300 [1/m].
    thickness : float
        t [m].
    young_modulus : float
        E [Pa].
    poisson_ratio : float
        ν up to 0.5.

    Returns
    -------
    ndarray
        C [m/Pa], of the shape of `wavevector`.
    """
    nu = poisson_ratio
    depth = np.asarray(wavevector) * thickness
    opening = (3 - 4 * nu) * np.sinh(2 * depth) - 2 * depth
    holding = 5 + 2 * depth**2 - 4 * nu * (3 - 2 * nu) + (3 - 4 * nu) * np.cosh(2 * depth)
    return 2 * (1 - nu**2) / (young_modulus * np.asarray(wavevector)) * opening / holding
