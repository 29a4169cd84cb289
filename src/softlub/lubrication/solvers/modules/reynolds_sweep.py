"""The Reynolds equation sweep of the mixed module: one pass over the nodes, not a solution (source 3.4.3, step 2).

Both sweeps correct the residual of the finite volumes' rows, L_i = q_{i-½} - q_{i+½} (equation 3-24 with its signs put
right, in the flux form of `finite_volume.fluxes`), by one step and clip the pressure at zero (Reynolds condition).
"""

from __future__ import annotations

import numba
import numpy as np

from softlub.lubrication.solvers.finite_volume.fluxes import face_fluxes
from softlub.protocols import FloatArray

HIGH_PRESSURE = 0.1
"""Zone C1 is where P_f exceeds this part of its maximum: our rule, the source prints none."""


@numba.njit(cache=True, error_model="numpy")
def gauss_seidel_sweep(
    nodes: FloatArray, gap: FloatArray, fluid: FloatArray, speed_number: float
) -> FloatArray:
    """P_f after one pass along the flow, each node balanced with its already updated left neighbour (equation 3-8).

    Parameters
    ----------
    nodes, gap, fluid : ndarray, shape (n,)
        X, H and P_f.
    speed_number : float
        λ.

    Returns
    -------
    ndarray, shape (n,)
    """
    updated = fluid.copy()
    couette, conductance, _ = face_fluxes(nodes, gap, np.zeros_like(gap), speed_number)
    for i in range(1, nodes.size - 1):
        left, right = conductance[i - 1], conductance[i]
        balanced = (left * updated[i - 1] + right * updated[i + 1] + couette[i - 1] - couette[i]) / (
            left + right
        )
        updated[i] = max(balanced, 0.0)
    return updated


@numba.njit(cache=True, error_model="numpy")
def newton_raphson_sweep(
    nodes: FloatArray, gap: FloatArray, fluid: FloatArray, speed_number: float, kernel: FloatArray
) -> FloatArray:
    """P_f after one Newton–Raphson step of all rows with the kernel's near field (equation 3-25).

    The derivative of row i by P_c has the pressure flow of the neighbours, mobilities held, and what the Couette flow
    gains as P_c opens the gap, -(λ/2) (C_{i+1,c} - C_{i-1,c}). Zones: C1 (high pressure) keeps five
    bands, C2 (low pressure) the three of the pressure flow, C3 (rows that would go below zero) the diagonal, P_f = 0.

    Parameters
    ----------
    nodes, gap, fluid : ndarray, shape (n,)
        X, H and P_f.
    speed_number : float
        λ.
    kernel : ndarray, shape (n,)
        Influence C over the distance in nodes.

    Returns
    -------
    ndarray, shape (n,)
        `fluid` itself where the step is singular.
    """
    count = nodes.size
    flux, conductance, _ = face_fluxes(nodes, gap, fluid, speed_number)
    near = -0.5 * speed_number * (kernel[2] - kernel[0])
    far = -0.5 * speed_number * (kernel[3] - kernel[1])
    threshold = HIGH_PRESSURE * np.max(fluid)
    bands = np.zeros((count, 5))
    right = np.zeros(count)
    bands[:, 2] = 1.0
    for i in range(1, count - 1):
        diagonal = conductance[i - 1] + conductance[i]
        balance = flux[i - 1] - flux[i]
        if fluid[i] + balance / diagonal <= 0:
            right[i] = -fluid[i]
            continue
        right[i] = -balance
        bands[i, 1], bands[i, 2], bands[i, 3] = conductance[i - 1], -diagonal, conductance[i]
        if fluid[i] > threshold and 1 < i < count - 2:
            bands[i, 0] += far
            bands[i, 1] += near
            bands[i, 3] -= near
            bands[i, 4] -= far
    change = solve_five_bands(bands, right)
    if not np.all(np.isfinite(change)):
        return fluid.copy()
    return np.maximum(fluid + change, 0.0)


@numba.njit(cache=True, error_model="numpy")
def solve_five_bands(bands: FloatArray, right: FloatArray) -> FloatArray:
    """Solution of a five-banded system by elimination without pivots; both arguments are overwritten.

    Parameters
    ----------
    bands : ndarray, shape (n, 5)
        Row i holds columns i-2 … i+2.
    right : ndarray, shape (n,)

    Returns
    -------
    ndarray, shape (n,)
    """
    count = right.size
    for i in range(count):
        for below in range(1, min(3, count - i)):
            factor = bands[i + below, 2 - below] / bands[i, 2]
            if factor == 0.0:
                continue
            for k in range(1, 3):
                bands[i + below, 2 - below + k] -= factor * bands[i, 2 + k]
            right[i + below] -= factor * right[i]
    solution = np.zeros(count)
    for i in range(count - 1, -1, -1):
        value = right[i]
        for k in range(1, min(3, count - i)):
            value -= bands[i, 2 + k] * solution[i + k]
        solution[i] = value / bands[i, 2]
    return solution
