"""One Newton step by elimination with the dense influence matrix."""

from __future__ import annotations

from dataclasses import dataclass

import numba
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lapack

from softlub.lubrication.solvers.finite_volume.equations import Linearisation
from softlub.lubrication.solvers.finite_volume.scaled import ScaledContact
from softlub.protocols import FloatArray


@numba.njit(cache=True, error_model="numpy")
def assemble(
    influence: FloatArray,
    widths: FloatArray,
    law_slope: FloatArray,
    conductance: FloatArray,
    by_gap: FloatArray,
    flux_weight: FloatArray,
    inflow: NDArray[np.int64],
    first: int,
    last: int,
) -> FloatArray:
    """Jacobian of the nodes' rows and of the load by the pressures of nodes first…last-1 and the rigid approach.

    With dH = C dP + dH_c, dP_f = dP - S' dH and dq = ψ (dP_f,l - dP_f,r) + (∂q/∂H_l) dH_l + (∂q/∂H_r) dH_r each row is
    a combination of few rows of C.

    Returns
    -------
    ndarray, shape (m + 1, m + 1), m = last - first
    """
    size = last - first
    by_unknown = np.zeros((size + 1, size + 1))
    for k in range(size + 1):
        face = first - 1 + k
        left = by_gap[face, 0] - conductance[face] * law_slope[face]
        right = by_gap[face, 1] + conductance[face] * law_slope[face + 1]
        by_unknown[k, :size] = left * influence[face, first:last] + right * influence[face + 1, first:last]
        by_unknown[k, size] = left + right
        if k > 0:
            by_unknown[k, k - 1] += conductance[face]
        if k < size:
            by_unknown[k, k] -= conductance[face]
    jacobian = np.empty((size + 1, size + 1))
    for k in range(size):
        node = first + k
        if flux_weight[node] == 0.0:
            jacobian[k, :size] = -law_slope[node] * influence[node, first:last]
            jacobian[k, size] = -law_slope[node]
            jacobian[k, k] += 1.0
            continue
        source = inflow[node] - first + 1
        jacobian[k] = flux_weight[node] * (by_unknown[k + 1] - by_unknown[source])
    jacobian[size, :size] = widths[first:last]
    jacobian[size, size] = 0.0
    return jacobian


@dataclass(frozen=True, eq=False)
class Elimination:
    """Step by LU factors of the dense Jacobian."""

    influence: FloatArray
    """Matrix of the scaled half-space, shape (n, n)."""

    def __call__(self, contact: ScaledContact, equations: Linearisation) -> tuple[FloatArray, float]:
        """Changes of P and H_c."""
        rows, last = equations.rows, equations.unknowns
        jacobian = assemble(
            self.influence,
            contact.space.widths,
            equations.law_slope,
            equations.conductance,
            equations.by_gap,
            rows.flux_weight,
            rows.inflow,
            1,
            last,
        )
        right = -np.append(rows.residual[1:last], equations.load)
        factors, pivots, failed = lapack.dgetrf(jacobian.T, overwrite_a=True)
        change, _ = lapack.dgetrs(factors, pivots, right, trans=1)
        pressure_change = np.zeros_like(equations.gap)
        pressure_change[1:last] = change[:-1] if not failed else np.nan
        return pressure_change, float(change[-1])
