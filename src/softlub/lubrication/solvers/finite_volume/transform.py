"""One Newton step on an even grid: products by fast transforms, GMRES, a banded near field to precondition it.

The near field is the Jacobian with the influence cut off beyond some nodes. The kernel is shifted so that it reaches
zero there: a constant added to the kernel multiplies ∫ dP dX, which the load fixes, and is made up for by the
rigid approach.
"""

from __future__ import annotations

from dataclasses import dataclass

import numba
import numpy as np
from scipy.linalg import lapack

from softlub.lubrication.half_space import HalfSpaceFFT
from softlub.lubrication.solvers.finite_volume.equations import Linearisation
from softlub.lubrication.solvers.finite_volume.krylov import Operator, gmres
from softlub.lubrication.solvers.finite_volume.scaled import ScaledContact
from softlub.protocols import FloatArray


@dataclass(frozen=True, eq=False)
class Transforms:
    """Step by preconditioned GMRES.

    Parameters
    ----------
    space : HalfSpaceFFT
        The scaled half-space.
    reach : int
        Nodes over which the near field extends.
    tolerance : float
        Of the linear residual, relative to the equations' residual.
    most : int
        Largest number of products.
    """

    space: HalfSpaceFFT
    reach: int = 16
    tolerance: float = 1e-6
    most: int = 200

    def __call__(self, contact: ScaledContact, equations: Linearisation) -> tuple[FloatArray, float]:
        """Changes of P and H_c."""
        last = equations.unknowns
        right = -np.append(equations.rows.residual[1:last], equations.load)
        change, _ = gmres(
            self._jacobian(equations, last),
            self._near_field(equations, last),
            right,
            self.tolerance,
            self.most,
        )
        pressure_change = np.zeros_like(equations.gap)
        pressure_change[1:last] = change[:-1]
        return pressure_change, float(change[-1])

    def _jacobian(self, equations: Linearisation, last: int) -> Operator:
        """Product of the Jacobian with changes of the pressures of nodes 1…last-1 and of the rigid approach."""
        rows, by_gap, widths = equations.rows, equations.by_gap, self.space.widths[1:last]
        weight = rows.flux_weight[1:last]
        pressure = np.zeros_like(equations.gap)

        def product(change: FloatArray) -> FloatArray:
            pressure[1:last] = change[:-1]
            gap = self.space.deflection(pressure) + change[-1]
            fluid = pressure - equations.law_slope * gap
            flux = by_gap[:, 0] * gap[:-1] + by_gap[:, 1] * gap[1:] - equations.conductance * np.diff(fluid)
            outflow = flux[1:last] - flux[rows.inflow[1:last]]
            nodal = np.where(weight > 0, weight * outflow, fluid[1:last])
            return np.append(nodal, widths @ change[:-1])

        return product

    def _near_field(self, equations: Linearisation, last: int) -> Operator:
        """Solution with the banded near field, bordered by the rigid approach and the load."""
        reach = min(self.reach, self.space.positions.size - 1)
        kernel = self.space.kernel[: reach + 1] - self.space.kernel[reach]
        rows, size = equations.rows, last - 1
        band, border = assemble_band(
            kernel,
            equations.law_slope,
            equations.conductance,
            equations.by_gap,
            rows.flux_weight,
            size,
        )
        factors, pivots, _ = lapack.dgbtrf(band, reach + 1, reach + 1, overwrite_ab=True)
        widths = self.space.widths[1:last]
        lifted, _ = lapack.dgbtrs(factors, reach + 1, reach + 1, border, pivots)
        share = float(widths @ lifted)

        def solve(vector: FloatArray) -> FloatArray:
            pressure, _ = lapack.dgbtrs(factors, reach + 1, reach + 1, vector[:-1], pivots)
            approach = (float(widths @ pressure) - vector[-1]) / share
            return np.append(pressure - approach * lifted, approach)

        return solve


@numba.njit(cache=True, error_model="numpy")
def assemble_band(
    kernel: FloatArray,
    law_slope: FloatArray,
    conductance: FloatArray,
    by_gap: FloatArray,
    flux_weight: FloatArray,
    size: int,
) -> tuple[FloatArray, FloatArray]:
    """Jacobian of nodes 1…size with the influence cut off, in LAPACK's band storage, and its column of H_c.

    Inflow is that of a full film: a void handed on from far upstream is left to GMRES.
    """
    reach = kernel.size - 1
    width = reach + 1
    padded = np.zeros(2 * reach + 7)
    padded[3 : 2 * reach + 4] = np.concatenate((kernel[:0:-1], kernel))
    middle = reach + 3
    band = np.zeros((3 * width + 1, size))
    border = np.empty(size)
    for k in range(size):
        node = k + 1
        weight, slope = flux_weight[node], law_slope[node]
        share = 0.0 if weight > 0 else 1.0
        behind, ahead = conductance[node - 1], conductance[node]
        to_left = -weight * (by_gap[node - 1, 0] - behind * law_slope[node - 1])
        to_right = weight * (by_gap[node, 1] + ahead * law_slope[node + 1])
        own = weight * (by_gap[node, 0] - by_gap[node - 1, 1] - (ahead + behind) * slope) - share * slope
        border[k] = to_left + own + to_right
        for j in range(max(0, k - width), min(size, k + width + 1)):
            offset = middle + k - j
            value = to_left * padded[offset - 1] + own * padded[offset] + to_right * padded[offset + 1]
            if j == k:
                value += weight * (ahead + behind) + share
            elif j == k + 1:
                value -= weight * ahead
            elif j == k - 1:
                value -= weight * behind
            band[2 * width + k - j, j] = value
    return band, border
