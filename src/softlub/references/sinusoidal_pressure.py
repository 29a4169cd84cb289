"""A pressure wave on an elastic half-plane deflects it by a wave: p cos(qx) gives (2p/(E* q)) cos(qx)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def deflection(position: FloatArray, amplitude: float, wavevector: float, modulus: float) -> FloatArray:
    """Deflection [m] of an unbounded wave (Johnson 1985, section 13.2).

    Parameters
    ----------
    position : ndarray
        x [m].
    amplitude : float
        Of the pressure [Pa].
    wavevector : float
        q [1/m].
    modulus : float
        Plane-strain modulus E* [Pa].
    """
    return 2 * amplitude / (modulus * wavevector) * np.cos(wavevector * position)
