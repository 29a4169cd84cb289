"""The logarithmic kernel of the elastic half-space on spectral elements, without quadrature error.

∫ ln|t - τ| P_k(τ) dτ over [-1, 1] = 2 (Q_{k+1}(t) - Q_{k-1}(t)) / (2k + 1), with Q the Legendre functions of the second
kind (principal values inside the element), by parts from (2k + 1) P_k = (P_{k+1} - P_{k-1})'.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import FloatArray

# Forward recurrence multiplies errors by (t + √(t² - 1))^(2k) outside the element, so it stops here.
FORWARD_LIMIT = 1.02


@njit(cache=True)
def log_moments(position: float, moments: FloatArray, functions: FloatArray) -> None:
    """Fill `moments` with ∫ ln|t - τ| P_k(τ) dτ, k = 0 … p; `functions` is scratch of length p + 2."""
    order = moments.size - 1
    t = abs(position)
    if t == 1.0:
        # The logarithm of Q_0 meets a zero factor in every difference that is used: it is left out.
        functions[0] = 0.0
        moments[0] = 2 * np.log(2.0) - 2.0
        _forward(t, functions)
    elif t <= FORWARD_LIMIT:
        outer, near = np.log(1.0 + t), np.log(abs(1.0 - t))
        functions[0] = 0.5 * (outer - near)
        moments[0] = (1.0 + t) * outer + (1.0 - t) * near - 2.0
        _forward(t, functions)
    else:
        _decaying_functions(t, functions)
        moments[0] = np.log(t * t - 1.0) + 2 * functions[1]
    sign = 1.0 if position >= 0 else -1.0
    for k in range(1, order + 1):
        moments[k] = 2 * (functions[k + 1] - functions[k - 1]) / (2 * k + 1)
        if k % 2 == 1:
            moments[k] *= sign


@njit(cache=True)
def _forward(t: float, functions: FloatArray) -> None:
    """Fill Q_1 … Q_{p+1} from Q_0 by the forward recurrence."""
    functions[1] = t * functions[0] - 1.0
    for k in range(1, functions.size - 1):
        functions[k + 1] = ((2 * k + 1) * t * functions[k] - k * functions[k - 1]) / (k + 1)


@njit(cache=True)
def _decaying_functions(t: float, functions: FloatArray) -> None:
    """Fill Q_0 … Q_{p+1} at t > 1 by Miller's downward recurrence."""
    last = functions.size - 1
    growth = np.log(t + np.sqrt(t * t - 1.0))
    top = min(last, int(38.0 / growth) + 1)  # beyond it they are below round-off
    for k in range(top + 1, last + 1):
        functions[k] = 0.0
    above, here = 0.0, 1e-280
    for k in range(top + int(19.0 / growth) + 2, 0, -1):
        if k <= top:
            functions[k] = here
        above, here = here, ((2 * k + 1) * t * here - (k + 1) * above) / k
    scale = 0.5 * np.log1p(2.0 / (t - 1.0)) / here
    functions[0] = here * scale
    for k in range(1, top + 1):
        functions[k] *= scale


@njit(cache=True)
def log_kernel(targets: FloatArray, breaks: FloatArray, legendre_weights: FloatArray) -> FloatArray:
    """Matrix of ∫ ln|y_i - y| ℓ_j(y) dy over all elements.

    Parameters
    ----------
    targets : ndarray, shape (m,)
        Positions y_i, anywhere.
    breaks : ndarray, shape (e + 1,)
        Ends of the elements.
    legendre_weights : ndarray, shape (p + 1, p + 1)
        Of the basis.

    Returns
    -------
    ndarray, shape (m, e p + 1)
        Neighbouring elements share their common node.
    """
    order = legendre_weights.shape[0] - 1
    elements = breaks.size - 1
    kernel = np.zeros((targets.size, elements * order + 1))
    moments = np.empty(order + 1)
    functions = np.empty(order + 2)
    for i in range(targets.size):
        for e in range(elements):
            half = 0.5 * (breaks[e + 1] - breaks[e])
            local = (targets[i] - breaks[e]) / half - 1.0
            if targets[i] == breaks[e + 1]:  # exactly: the logarithm is left out there
                local = 1.0
            log_moments(local, moments, functions)
            moments[0] += 2 * np.log(half)
            row = kernel[i, e * order : (e + 1) * order + 1]
            for k in range(order + 1):
                factor = half * moments[k]
                for j in range(order + 1):
                    row[j] += factor * legendre_weights[k, j]
    return kernel
