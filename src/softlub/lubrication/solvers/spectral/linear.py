"""Dense LU factorisation with partial pivoting, kept so that one factor serves several right-hand sides.

At some hundred unknowns a compiled loop that updates by blocks of eight columns is as fast as LAPACK.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from softlub.lubrication.solvers.spectral.basis import FloatArray

BLOCK = 8


@njit(cache=True, fastmath={"contract", "reassoc", "nsz"})
def factorise(a: FloatArray, pivots: NDArray[np.int64]) -> bool:
    """Overwrite a square matrix by its factors, rows exchanged as `pivots` says; False if it is singular."""
    n = a.shape[0]
    for start in range(0, n, BLOCK):
        stop = min(start + BLOCK, n)
        for k in range(start, stop):
            best = k
            for i in range(k + 1, n):
                if abs(a[i, k]) > abs(a[best, k]):
                    best = i
            pivots[k] = best
            if not abs(a[best, k]) > 0.0:
                return False
            if best != k:
                for j in range(n):
                    a[k, j], a[best, j] = a[best, j], a[k, j]
            inverse = 1.0 / a[k, k]
            for i in range(k + 1, n):
                factor = a[i, k] * inverse
                a[i, k] = factor
                for j in range(k + 1, stop):
                    a[i, j] -= factor * a[k, j]
        for k in range(start, stop):
            for i in range(k + 1, stop):
                factor = a[i, k]
                for j in range(stop, n):
                    a[i, j] -= factor * a[k, j]
        if stop < n:
            _update(a, start, stop)
    return True


@njit(cache=True, fastmath={"contract", "reassoc", "nsz"})
def _update(a: FloatArray, start: int, stop: int) -> None:
    """Subtract from the trailing block what the columns start … stop - 1 (BLOCK of them) have eliminated."""
    u0, u1, u2, u3 = a[start, stop:], a[start + 1, stop:], a[start + 2, stop:], a[start + 3, stop:]
    u4, u5, u6, u7 = a[start + 4, stop:], a[start + 5, stop:], a[start + 6, stop:], a[start + 7, stop:]
    for i in range(stop, a.shape[0]):
        f = a[i, start:stop]
        f0, f1, f2, f3, f4, f5, f6, f7 = f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]
        row = a[i, stop:]
        for j in range(row.size):
            row[j] -= (
                f0 * u0[j]
                + f1 * u1[j]
                + f2 * u2[j]
                + f3 * u3[j]
                + f4 * u4[j]
                + f5 * u5[j]
                + f6 * u6[j]
                + f7 * u7[j]
            )


@njit(cache=True, fastmath={"contract", "reassoc", "nsz"})
def substitute(factors: FloatArray, pivots: NDArray[np.int64], values: FloatArray) -> None:
    """Overwrite a right-hand side by the solution."""
    n = values.size
    for k in range(n):
        other = pivots[k]
        if other != k:
            values[k], values[other] = values[other], values[k]
    for i in range(n):
        row = factors[i]
        total = 0.0
        for j in range(i):
            total += row[j] * values[j]
        values[i] -= total
    for i in range(n - 1, -1, -1):
        row = factors[i]
        total = 0.0
        for j in range(i + 1, n):
            total += row[j] * values[j]
        values[i] = (values[i] - total) / row[i]
