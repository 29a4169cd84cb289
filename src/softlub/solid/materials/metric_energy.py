"""The energy ½ J^(-2/3) M : C of a symmetric tensor M, with its stress and elasticity.

With q = M : C, G = F^(-T) and s = J^(-2/3):

    P_iJ   = s (F_iA M_AJ - q/3 G_iJ)
    A_iJkL = s (δ_ik M_JL - 2/3 (F_iA M_AJ G_kL + G_iJ F_kA M_AL) + q (2/9 G_iJ G_kL + 1/3 G_iL G_kJ))

Points are worked through in blocks that stay in the cache, component by component.
"""

from __future__ import annotations

import numba
import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

BLOCK = 128
"""Points a block: its 40 rows of numbers fill the first-level cache."""
_NONE = np.zeros((9, 0))


def metric_stress(deformation: FloatArray, modulus: float, metric: FloatArray | None = None) -> FloatArray:
    """Stress ∂W/∂F of W = ½ J^(-2/3) (modulus I + metric) : C.

    Parameters
    ----------
    deformation : ndarray, shape (3, 3, ...)
        Deformation gradients F with J > 0.
    modulus : float
        Isotropic part of M [Pa].
    metric : ndarray, shape (3, 3, ...), optional
        The rest of M [Pa], symmetric.

    Returns
    -------
    ndarray, shape (3, 3, ...)
        In Pa; NaN where J is not above 0.
    """
    stress = np.empty(deformation.shape)
    _stress(_rows(deformation), modulus, _metric_rows(metric), stress.reshape(9, -1))
    return stress


def metric_elasticity(
    deformation: FloatArray, modulus: float, metric: FloatArray | None = None
) -> FloatArray:
    """Elasticity ∂²W/∂F∂F, shape (3, 3, 3, 3, ...) [Pa]; parameters as in `metric_stress`."""
    elasticity = np.empty((3, 3, *deformation.shape))
    _elasticity(_rows(deformation), modulus, _metric_rows(metric), elasticity.reshape(9, 9, -1))
    return elasticity


def _rows(tensors: FloatArray) -> FloatArray:
    return np.ascontiguousarray(tensors, dtype=np.float64).reshape(9, -1)


def _metric_rows(metric: FloatArray | None) -> FloatArray:
    return _NONE if metric is None else _rows(metric)


@numba.njit(cache=True, error_model="numpy")
def _prepare(
    deformation: FloatArray,
    modulus: float,
    metric: FloatArray,
    start: int,
    count: int,
    product: FloatArray,
    inverse: FloatArray,
    scale: FloatArray,
    invariant: FloatArray,
) -> None:
    """F M, F^(-T), J^(-2/3) and M : C of a block of points."""
    f = deformation[:, start : start + count]
    for b in range(count):
        inverse[0, b] = f[4, b] * f[8, b] - f[5, b] * f[7, b]
        inverse[1, b] = f[5, b] * f[6, b] - f[3, b] * f[8, b]
        inverse[2, b] = f[3, b] * f[7, b] - f[4, b] * f[6, b]
        inverse[3, b] = f[2, b] * f[7, b] - f[1, b] * f[8, b]
        inverse[4, b] = f[0, b] * f[8, b] - f[2, b] * f[6, b]
        inverse[5, b] = f[1, b] * f[6, b] - f[0, b] * f[7, b]
        inverse[6, b] = f[1, b] * f[5, b] - f[2, b] * f[4, b]
        inverse[7, b] = f[2, b] * f[3, b] - f[0, b] * f[5, b]
        inverse[8, b] = f[0, b] * f[4, b] - f[1, b] * f[3, b]
    for b in range(count):
        volume = f[0, b] * inverse[0, b] + f[1, b] * inverse[1, b] + f[2, b] * inverse[2, b]
        scale[b] = volume ** (-2.0 / 3.0)
        invariant[b] = 1.0 / volume
    for k in range(9):
        for b in range(count):
            inverse[k, b] *= invariant[b]
            product[k, b] = modulus * f[k, b]
    if metric.shape[1] > 0:
        m = metric[:, start : start + count]
        for i in range(3):
            for j in range(3):
                for b in range(count):
                    product[3 * i + j, b] += (
                        f[3 * i, b] * m[j, b] + f[3 * i + 1, b] * m[3 + j, b] + f[3 * i + 2, b] * m[6 + j, b]
                    )
    invariant[:count] = 0.0
    for k in range(9):
        for b in range(count):
            invariant[b] += f[k, b] * product[k, b]


@numba.njit(cache=True, error_model="numpy")
def _stress(deformation: FloatArray, modulus: float, metric: FloatArray, stress: FloatArray) -> None:
    points = deformation.shape[1]
    product, inverse = np.empty((9, BLOCK)), np.empty((9, BLOCK))
    scale, invariant = np.empty(BLOCK), np.empty(BLOCK)
    for start in range(0, points, BLOCK):
        count = min(BLOCK, points - start)
        _prepare(deformation, modulus, metric, start, count, product, inverse, scale, invariant)
        for k in range(9):
            for b in range(count):
                stress[k, start + b] = scale[b] * (product[k, b] - invariant[b] / 3.0 * inverse[k, b])


@numba.njit(cache=True, error_model="numpy")
def _elasticity(deformation: FloatArray, modulus: float, metric: FloatArray, elasticity: FloatArray) -> None:
    points = deformation.shape[1]
    product, inverse = np.empty((9, BLOCK)), np.empty((9, BLOCK))
    scale, invariant, value = np.empty(BLOCK), np.empty(BLOCK), np.empty(BLOCK)
    for start in range(0, points, BLOCK):
        count = min(BLOCK, points - start)
        _prepare(deformation, modulus, metric, start, count, product, inverse, scale, invariant)
        for left in range(9):
            for right in range(left, 9):
                # G_iL G_kJ of the components iJ and kL.
                il, kj = 3 * (left // 3) + right % 3, 3 * (right // 3) + left % 3
                for b in range(count):
                    mixed = product[left, b] * inverse[right, b] + inverse[left, b] * product[right, b]
                    pure = inverse[left, b] * inverse[right, b] * (2.0 / 9.0)
                    pure += inverse[il, b] * inverse[kj, b] / 3.0
                    value[b] = invariant[b] * pure - mixed * (2.0 / 3.0)
                if left // 3 == right // 3:
                    row = 3 * (left % 3) + right % 3
                    isotropic = modulus if left == right else 0.0
                    for b in range(count):
                        value[b] += isotropic
                    if metric.shape[1] > 0:
                        for b in range(count):
                            value[b] += metric[row, start + b]
                for b in range(count):
                    value[b] *= scale[b]
                    elasticity[left, right, start + b] = value[b]
                    elasticity[right, left, start + b] = value[b]
