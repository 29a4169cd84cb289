"""The logarithmic kernel of the elastic half-space on spectral elements, without quadrature error.

∫ ln|t - τ| P_k(τ) dτ over [-1, 1] = 2 (Q_{k+1}(t) - Q_{k-1}(t)) / (2k + 1), with Q the Legendre functions of the second
kind (principal values inside the element), by parts from (2k + 1) P_k = (P_{k+1} - P_{k-1})'.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from softlub.lubrication.solvers.spectral.basis import FloatArray

# Up to t with (t + √(t² - 1))^(p + 1) = e^NEAR_GROWTH the forward recurrence loses at most the square of that.
NEAR_GROWTH = 4.6
# The downward recurrence starts so far above the last order that what it neglects is e^-38.
DECAY = 19.0
# Targets beyond it need few steps and are done apart from the nearer ones.
FAR = 2.0


@njit(cache=True)
def near_moments(t: float, moments: FloatArray, functions: FloatArray) -> None:
    """Fill `moments` with ∫ ln|t - τ| P_k(τ) dτ, k = 0 … p, for small │t│; `functions` is scratch, length p + 2."""
    if abs(t) == 1.0:
        # The logarithm of Q_0 meets a zero factor in every difference that is used: it is left out.
        functions[0] = 0.0
        moments[0] = 2 * np.log(2.0) - 2.0
    else:
        outer, inner = np.log(abs(1.0 + t)), np.log(abs(1.0 - t))
        functions[0] = 0.5 * (outer - inner)
        moments[0] = (1.0 + t) * outer + (1.0 - t) * inner - 2.0
    functions[1] = t * functions[0] - 1.0
    for k in range(1, moments.size):
        functions[k + 1] = ((2 * k + 1) * t * functions[k] - k * functions[k - 1]) / (k + 1)
        moments[k] = 2 * (functions[k + 1] - functions[k - 1]) / (2 * k + 1)


@njit(cache=True, fastmath={"contract"})
def far_moments(
    t: FloatArray, count: int, moments: FloatArray, ratio: FloatArray, functions: FloatArray
) -> None:
    """The same for the first `count` of many │t│ > 1 at once, `moments` of shape (p + 1, m).

    Downward recurrence of the ratios Q_k/Q_{k-1}, which neither overflows nor loses digits; `ratio` (m) and
    `functions` (p + 2, m) are scratch.
    """
    order = moments.shape[0] - 1
    nearest = np.inf
    for i in range(count):
        nearest = min(nearest, abs(t[i]))
        ratio[i] = 0.0
    growth = np.log(nearest + np.sqrt(nearest * nearest - 1.0))
    for k in range(order + 2 + int(DECAY / growth) + 1, 0, -1):
        for i in range(count):
            ratio[i] = k / ((2 * k + 1) * t[i] - (k + 1) * ratio[i])
        if k <= order + 1:
            for i in range(count):
                functions[k, i] = ratio[i]
    for i in range(count):
        distance = abs(t[i])
        first = np.log1p(2.0 / (distance - 1.0))
        functions[0, i] = 0.5 * first if t[i] > 0 else -0.5 * first
        functions[1, i] *= functions[0, i]
        moments[0, i] = 2 * np.log(distance - 1.0) + first + 2 * functions[1, i]
    for k in range(1, order + 1):
        scale = 2.0 / (2 * k + 1)
        for i in range(count):
            functions[k + 1, i] *= functions[k, i]
            moments[k, i] = scale * (functions[k + 1, i] - functions[k - 1, i])


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
    root = np.exp(NEAR_GROWTH / (order + 1))
    near = 0.5 * (root + 1.0 / root)
    size = targets.size
    kernel = np.zeros((size, (breaks.size - 1) * order + 1))
    rows, local, ratio = np.empty(size, np.int64), np.empty(size), np.empty(size)
    moments, functions = np.empty((order + 1, size)), np.empty((order + 2, size))
    single, scratch = np.empty(order + 1), np.empty(order + 2)
    for e in range(breaks.size - 1):
        block = kernel[:, e * order : (e + 1) * order + 1]
        half = 0.5 * (breaks[e + 1] - breaks[e])
        for group in range(3):
            count = 0
            for i in range(size):
                # Exactly 1 on the break, where the logarithm is left out.
                t = 1.0 if targets[i] == breaks[e + 1] else (targets[i] - breaks[e]) / half - 1.0
                if group == (0 if abs(t) <= near else (1 if abs(t) <= max(FAR, near) else 2)):
                    rows[count], local[count] = i, t
                    count += 1
            if count == 0:
                continue
            if group == 0:
                for i in range(count):
                    near_moments(local[i], single, scratch)
                    for k in range(order + 1):
                        moments[k, i] = single[k]
            else:
                far_moments(local, count, moments, ratio, functions)
            _add_rows(block, rows, count, moments, half, legendre_weights)
    return kernel


@njit(cache=True, fastmath={"contract"})
def _add_rows(
    block: FloatArray,
    rows: NDArray[np.int64],
    count: int,
    moments: FloatArray,
    half: float,
    legendre_weights: FloatArray,
) -> None:
    """Turn moments of Legendre polynomials into entries of the kernel."""
    scale = 2 * np.log(half)
    for i in range(count):
        row = block[rows[i]]
        for k in range(moments.shape[0]):
            factor = half * (moments[k, i] + (scale if k == 0 else 0.0))
            for j in range(row.size):
                row[j] += factor * legendre_weights[k, j]
