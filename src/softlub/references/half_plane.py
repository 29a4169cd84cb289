"""Displacement of a half-plane's surface under strips of normal and tangential traction, in plane strain.

K. L. Johnson, Contact Mechanics (1985), equations 2.23 to 2.25 and section 2.4. In two dimensions the displacement is
known up to a constant that a rigid motion makes up for: the datum d below is the distance from a line load at which the
displacement along that load is 0.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def surface_displacement(
    ends: FloatArray,
    pressure: FloatArray,
    shear: FloatArray,
    young_modulus: float,
    poisson_ratio: float,
    datum: float,
    positions: FloatArray,
) -> FloatArray:
    """Displacement along the surface and into the body.

    Parameters
    ----------
    ends : ndarray, shape (n + 1,)
        Ends of neighbouring strips, ascending [m].
    pressure, shear : ndarray, shape (n,)
        Traction on each strip, into the body and along +x [Pa].
    young_modulus : float
        E [Pa].
    poisson_ratio : float
        ν.
    datum : float
        d [m].
    positions : ndarray, shape (m,)
        Where it is wanted [m].

    Returns
    -------
    ndarray, shape (m, 2)
        Along +x and into the body [m].
    """
    logarithm, balance = _integrals(positions[:, None] - ends[None, :], datum)
    opposing = 2 * (1 - poisson_ratio**2) / (np.pi * young_modulus) * logarithm
    coupling = (1 - 2 * poisson_ratio) * (1 + poisson_ratio) / (2 * young_modulus) * balance
    along = -opposing @ shear - coupling @ pressure
    inward = -opposing @ pressure + coupling @ shear
    return np.stack([along, inward], axis=1)


def _integrals(distance: FloatArray, datum: float) -> tuple[FloatArray, FloatArray]:
    """∫ ln(|x - s|/d) ds and ∫ sgn(x - s) ds over each strip, from the distances x - s of its ends."""
    away = np.abs(distance)
    # t ln|t| goes to 0 with t.
    primitive = distance * (np.log(np.where(away > 0, away, datum) / datum) - 1)
    return -np.diff(primitive, axis=1), -np.diff(away, axis=1)
