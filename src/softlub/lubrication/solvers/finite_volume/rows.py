"""The equations of all nodes, scaled, with what their derivatives are built from.

At each node the fluid pressure and the net outflow are complementary: min(P_f, c r) = 0 with

    r_i = q_{i+½} - (flux into i),   c_i = 1/(ψ_{i-½} + ψ_{i+½}).

Under the Reynolds condition the flux into node i is q_{i-½} of the full film. Under mass conservation (Jakobsson,
Floberg, Olsson) a cavitated node hands on what flowed into it: the flux into node i is that through the last
face upstream whose left node was pressurised; r_i = λ θ_i H_i, θ the void fraction, then holds wherever P_f = 0, and
the two conditions differ only where a film forms again.

Rounding the kink of min(a, b) off, as Fischer and Burmeister do, was tried and left out: with the help of `front` no
step that runs in circles has been seen near a solution.
"""

from __future__ import annotations

from typing import NamedTuple

import numba
import numpy as np
from numpy.typing import NDArray

from softlub.protocols import FloatArray


class Rows(NamedTuple):
    """Residuals of the nodes' equations, and what their derivatives are made of."""

    residual: FloatArray
    """min(P_f, c r), shape (n,)."""
    flux_weight: FloatArray
    """c where the row is c r = c (q_{i+½} - q_inflow), 0 where it is P_f, shape (n,)."""
    inflow: NDArray[np.int64]
    """Index of the face through which the node's inflow is counted, shape (n,)."""


@numba.njit(cache=True, error_model="numpy")
def complementarity_rows(
    fluid: FloatArray, flux: FloatArray, conductance: FloatArray, mass_conserving: bool
) -> tuple[FloatArray, FloatArray, NDArray[np.int64]]:
    """Members of `Rows`; the two end nodes hold P_f.

    Parameters
    ----------
    fluid : ndarray, shape (n,)
        P_f.
    flux, conductance : ndarray, shape (n - 1,)
        q and ψ at the faces.
    mass_conserving : bool
        The lubricant's cavitation condition.
    """
    count = fluid.size
    residual = fluid.copy()
    flux_weight = np.zeros(count)
    inflow = np.arange(-1, count - 1)
    for i in range(1, count - 1):
        if mass_conserving and i > 1 and flux_weight[i - 1] == 0.0:
            inflow[i] = inflow[i - 1]
        scale = 1 / (conductance[i - 1] + conductance[i])
        outflow = scale * (flux[i] - flux[inflow[i]])
        if outflow < fluid[i]:
            residual[i] = outflow
            flux_weight[i] = scale
    return residual, flux_weight, inflow
