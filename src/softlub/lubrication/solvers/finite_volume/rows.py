"""The equations of all nodes, scaled, with what their derivatives are built from.

At each node the fluid pressure and the net outflow are complementary: min(P_f, c r) = 0 with

    r_i = q_{i+½} - (flux into i),   c_i = 1/(ψ_{i-½} + ψ_{i+½}).

Under the Reynolds condition the flux into node i is q_{i-½} of the full film. Under mass conservation (Jakobsson,
Floberg, Olsson) a cavitated node hands on what flowed into it: the flux into node i is that through the last
face upstream whose left node was pressurised; r_i = λ θ_i H_i, θ the void fraction, then holds wherever P_f = 0, and
the two conditions differ only where a film forms again.

The kink of min(a, b) can be rounded as Fischer and Burmeister do, ½(a + b - √(a² + b² + 2ε²)), for steps from which the
sharp form would run in circles.
"""

from __future__ import annotations

from typing import NamedTuple

import numba
import numpy as np
from numpy.typing import NDArray

from softlub.protocols import FloatArray


class Rows(NamedTuple):
    """Residuals of the nodes' equations, and weights that make up their derivatives.

    Row i is derived as pressure_weight_i dP_f,i + flux_weight_i (dq_{i+½} - dq_{inflow_i}).
    """

    residual: FloatArray
    """Shape (n,), in units of the pressure scale."""
    pressure_weight: FloatArray
    """Shape (n,)."""
    flux_weight: FloatArray
    """Shape (n,)."""
    inflow: NDArray[np.int64]
    """Index of the face through which the node's inflow is counted, shape (n,)."""


@numba.njit(cache=True, error_model="numpy")
def complementarity_rows(
    fluid: FloatArray, flux: FloatArray, conductance: FloatArray, mass_conserving: bool, rounding: float
) -> tuple[FloatArray, FloatArray, FloatArray, NDArray[np.int64]]:
    """Members of `Rows`; the two end nodes hold P_f = 0.

    Parameters
    ----------
    fluid : ndarray, shape (n,)
        P_f.
    flux, conductance : ndarray, shape (n - 1,)
        q and ψ at the faces.
    mass_conserving : bool
        The lubricant's cavitation condition.
    rounding : float
        ε of the rounded kink; 0 for the sharp one.
    """
    count = fluid.size
    residual = fluid.copy()
    pressure_weight = np.ones(count)
    flux_weight = np.zeros(count)
    inflow = np.arange(-1, count - 1)
    for i in range(1, count - 1):
        if mass_conserving and i > 1 and flux_weight[i - 1] == 0.0:
            inflow[i] = inflow[i - 1]
        scale = 1 / (conductance[i - 1] + conductance[i])
        outflow = scale * (flux[i] - flux[inflow[i]])
        if rounding > 0:
            length = np.sqrt(fluid[i] ** 2 + outflow**2 + 2 * rounding**2)
            residual[i] = 0.5 * (fluid[i] + outflow - length)
            pressure_weight[i] = 0.5 * (1 - fluid[i] / length)
            flux_weight[i] = 0.5 * (1 - outflow / length) * scale
        elif outflow < fluid[i]:
            residual[i] = outflow
            pressure_weight[i] = 0.0
            flux_weight[i] = scale
    return residual, pressure_weight, flux_weight, inflow
