"""The true residuals of an iterate: how far it is from solving each equation, whatever the step that led to it.

The source stops on the relaxed change of a field between two sweeps, which a small relaxation factor makes as small as
one likes. Here each equation is asked in turn, the others held fixed:

- fluid: max |P_f - R(H)| / p0, R(H) the solution of the Reynolds equation with its complementarity for the
  iterate's own gap. The distance, not the row: rows of a thin film stay small under large smooth errors;
- elasticity: max |H_c + X²/2 + C (P_f + P_s) - H| / H, node by node;
- law: max |P_s - p_s(H)| / p0;
- load: |∫ (P_f + P_s) dX - π/2| / (π/2).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from softlub.lubrication.solvers.finite_volume.scaled import LOAD
from softlub.lubrication.solvers.modules.contact import EvenContact, Fields


class Residuals(NamedTuple):
    """Scaled residual of each equation."""

    fluid: float
    elasticity: float
    law: float
    load: float

    @property
    def largest(self) -> float:
        """The residual that counts; infinite where one of them is not a number."""
        worst = float(np.max(self))
        return worst if np.isfinite(worst) else float("inf")


def true_residuals(contact: EvenContact, fields: Fields) -> Residuals:
    """Residuals of an iterate.

    Parameters
    ----------
    contact : EvenContact
        The law of its problem is asked; without asperities P_s has to be zero.
    fields : Fields

    Returns
    -------
    Residuals
    """
    total = fields.fluid + fields.solid
    exact_fluid = contact.reynolds_pressure(fields.gap, fields.fluid)
    exact_gap = contact.scaled.gap(total, fields.approach)
    exact_solid = contact.scaled.solid(fields.gap)[0]
    return Residuals(
        fluid=float(np.max(np.abs(fields.fluid - exact_fluid))),
        elasticity=float(np.max(np.abs(exact_gap - fields.gap) / fields.gap)),
        law=float(np.max(np.abs(fields.solid - exact_solid))),
        load=abs(contact.force(total) / LOAD - 1),
    )
