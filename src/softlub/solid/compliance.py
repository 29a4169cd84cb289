"""The influence matrix of a body from its reduced stiffness, for the lubrication solver (equations 6-1 to 6-7).

A pressure p_j acts along the surface's normal on half the way to either neighbour. With the chord (Δx_j, Δy_j)
between the two midpoints that force is p_j (-Δy_j, Δx_j), so the gap opens by

    w_i = Σ_j C_ij p_j,   C_ij = Δx_j [K_r⁻¹]_iy,jy - Δy_j [K_r⁻¹]_iy,jx,

which is the source's EK_ij = Δs_j (…cos θ_j + …sin θ_j) with the inverse that its equation leaves out. The load
is Σ p_j Δx_j. About a loaded base state the gap is u = H_c + gap0 + C (p - p0), p0 the base state's normal forces over
Δx: friction that the base state carries goes on acting, so it should be that of the lubricated contact.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from softlub.protocols import FloatArray
from softlub.solid.reduced_stiffness import ReducedStiffness


@dataclass(frozen=True, eq=False)
class MeshedCompliance:
    """Gap over pressure of a body of finite elements on the nodes of its contact edge.

    It is a `softlub.protocols.Compliance`.

    Parameters
    ----------
    positions, widths : ndarray, shape (k,)
        x of the edge nodes in the base state and their tributary widths Δx [m].
    base_gap : ndarray, shape (k,)
        gap0 - C p0, the gap that the linear body has without pressure at zero rigid approach [m].
    influence : ndarray, shape (k, k)
        C [m/Pa].
    """

    positions: FloatArray
    widths: FloatArray
    base_gap: FloatArray
    influence: FloatArray

    @classmethod
    def of(cls, reduced: ReducedStiffness) -> MeshedCompliance:
        """Invert a reduced stiffness.

        Parameters
        ----------
        reduced : ReducedStiffness

        Raises
        ------
        ValueError
            If the edge overhangs in the base state, so that there is no gap over x.
        """
        if np.any(np.diff(reduced.positions) <= 0):
            at = int(np.argmin(np.diff(reduced.positions)))
            raise ValueError(
                f"the contact edge overhangs in the base state at its node {at} (x = {reduced.positions[at]:.4g} m): "
                "a film needs one gap at every x; make the contact edge narrower or the load smaller"
            )
        widths, rises = _chords(reduced.positions), _chords(reduced.base_gap)
        count = widths.size
        forces = np.zeros((count, 2, count))
        nodes = np.arange(count)
        forces[nodes, 0, nodes] = -rises
        forces[nodes, 1, nodes] = widths
        influence = reduced.response(forces.reshape(2 * count, count))[1::2]
        base_pressure = reduced.base_force[:, 1] / widths
        return cls(reduced.positions, widths, reduced.base_gap - influence @ base_pressure, influence)

    def deflection(self, pressure: ArrayLike) -> FloatArray:
        """Opening of the gap [m] under nodal pressures [Pa], shape (k,)."""
        return self.influence @ np.asarray(pressure, dtype=float)

    def matrix(self) -> FloatArray:
        """Derivative of `deflection` by the pressures [m/Pa], shape (k, k); not a copy."""
        return self.influence


def _chords(values: FloatArray) -> FloatArray:
    """Differences between the midpoints on either side of each node; the ends have one side."""
    halves = 0.5 * np.diff(values)
    return np.append(halves, 0.0) + np.append(0.0, halves)
