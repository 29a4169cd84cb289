"""Flux of the lubricant through the faces of the finite volumes, in Hertz units, with its derivatives.

With X = x/a, P = p/p0, H = uR/a² and λ = 6ηvR²/(a³p0) the Reynolds equation reads d/dX(λH - H³ dP_f/dX) = 0. Between
two nodes the separation is taken as linear; the flux q that then carries the pressure difference exactly is

    q = λ 2 H_l H_r/(H_l + H_r) - ψ (P_r - P_l),   ψ = 2 H_l² H_r²/((H_l + H_r) (X_r - X_l)),

from ∫ dX/H² = h/(H_l H_r) and ∫ dX/H³ = h (H_l + H_r)/(2 H_l² H_r²). It is central, of second order, and exact for a
linear slider.
"""

from __future__ import annotations

import numba
import numpy as np

from softlub.protocols import FloatArray


@numba.njit(cache=True, error_model="numpy")
def face_fluxes(
    nodes: FloatArray, gap: FloatArray, fluid: FloatArray, speed_number: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Flux q through every face, the conductance ψ and the derivatives of q by the gaps on both sides.

    Parameters
    ----------
    nodes, gap, fluid : ndarray, shape (n,)
        X, H > 0 and P_f.
    speed_number : float
        λ.

    Returns
    -------
    flux, conductance : ndarray, shape (n - 1,)
        q and ψ; ∂q/∂P_f is ψ on the left of the face and -ψ on its right.
    by_gap : ndarray, shape (n - 1, 2)
        ∂q/∂H on the left and on the right.
    """
    count = nodes.size - 1
    flux = np.empty(count)
    conductance = np.empty(count)
    by_gap = np.empty((count, 2))
    for i in range(count):
        left, right = gap[i], gap[i + 1]
        total = left + right
        mean = 2 * left * right / total
        conductance[i] = mean * left * right / (nodes[i + 1] - nodes[i])
        pressure_flow = conductance[i] * (fluid[i + 1] - fluid[i])
        flux[i] = speed_number * mean - pressure_flow
        by_gap[i, 0] = 2 * speed_number * (right / total) ** 2 - pressure_flow * (2 / left - 1 / total)
        by_gap[i, 1] = 2 * speed_number * (left / total) ** 2 - pressure_flow * (2 / right - 1 / total)
    return flux, conductance, by_gap
