"""The equations at a state of the unknowns, with what their derivatives are made of."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from softlub.lubrication.solvers.finite_volume.fluxes import face_fluxes
from softlub.lubrication.solvers.finite_volume.rows import Rows, complementarity_rows
from softlub.lubrication.solvers.finite_volume.scaled import LOAD, ScaledContact
from softlub.protocols import FloatArray

NEGLIGIBLE_SLOPE = 1e-13
"""Cavitated nodes beyond the last whose asperities are stiffer than this follow the gap instead of being unknowns."""


class State(NamedTuple):
    """The unknowns of one speed in Hertz units."""

    pressure: FloatArray
    """Total pressure P, shape (n,)."""
    approach: float
    """H_c."""
    front: float
    """Index of the last pressurised node; where states are interpolated, anything between nodes."""


class Linearisation(NamedTuple):
    """Residuals of all equations at a state, and what their derivatives are made of."""

    gap: FloatArray
    solid: FloatArray
    fluid: FloatArray
    law_slope: FloatArray
    flux: FloatArray
    conductance: FloatArray
    by_gap: FloatArray
    rows: Rows
    load: float
    """∫ P dX - π/2."""

    @property
    def residual(self) -> float:
        """Largest residual in units of the Hertz pressure."""
        return max(float(np.max(np.abs(self.rows.residual))), abs(self.load))

    @property
    def round_off(self) -> float:
        """What the round-off of the gaps alone leaves of the residual: they are sums of terms of order one."""
        by_gap = np.abs(self.by_gap).sum(axis=1)
        sensitivity = np.max(self.rows.flux_weight[1:-1] * (by_gap[:-1] + by_gap[1:]))
        return 2e-15 * float(sensitivity + np.max(np.abs(self.law_slope)))

    @property
    def unknowns(self) -> int:
        """Nodes 1 … unknowns-1 are solved for; the rest of the outlet carries no pressure worth the name."""
        live = np.flatnonzero((self.rows.flux_weight != 0) | (np.abs(self.law_slope) > NEGLIGIBLE_SLOPE))
        return min(int(live[-1]) + 2 if live.size else 2, self.gap.size - 1)


def linearise(contact: ScaledContact, speed_number: float, state: State, gap: FloatArray) -> Linearisation:
    """Evaluate all equations at a state whose gap is given."""
    solid, law_slope = contact.solid(gap)
    fluid = state.pressure - solid
    flux, conductance, by_gap = face_fluxes(contact.space.positions, gap, fluid, speed_number)
    rows = Rows(*complementarity_rows(fluid, flux, conductance, contact.mass_conserving))
    load = float(contact.space.widths @ state.pressure) - LOAD
    return Linearisation(gap, solid, fluid, law_slope, flux, conductance, by_gap, rows, load)
