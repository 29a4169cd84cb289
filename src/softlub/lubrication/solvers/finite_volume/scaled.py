"""The contact in Hertz units: x by a, pressure by p0, gap by a²/R; the speed is λ, the load is π/2."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.pressure_table import PressureTable, evaluate
from softlub.protocols import Compliance, FloatArray

LOAD = 0.5 * np.pi
"""∫ P dX of every contact."""
HERTZ_BODY = HalfSpaceCylinder(radius=1.0, modulus=2.0)
"""The half-space in Hertz units: w = -(1/π) ∫ P ln|X - S| dS, gap X²/2."""


@dataclass(frozen=True, eq=False)
class ScaledContact:
    """What all speeds of a contact share.

    Parameters
    ----------
    space : Compliance
        Elasticity on the nodes X, in Hertz units.
    table : PressureTable
        The law, P_s over H.
    mass_conserving : bool
        The film's cavitation condition.
    roughness : float
        h_rms R/a².
    """

    space: Compliance
    table: PressureTable
    mass_conserving: bool
    roughness: float

    @property
    def apex(self) -> int:
        """Node where the undeformed gap is least; of two the right one."""
        return self.space.positions.size - 1 - int(np.argmin(self.space.base_gap[::-1]))

    def gap(self, pressure: FloatArray, approach: float) -> FloatArray:
        """H = H_c + H_0 + C P, shape (n,); H_0 is X²/2 on the half-space."""
        return approach + self.space.base_gap + self.space.deflection(pressure)

    def solid(self, gap: FloatArray) -> tuple[FloatArray, FloatArray]:
        """P_s and dP_s/dH at the gaps, shape (n,) each."""
        return evaluate(self.table, gap)


def scale(problem: Problem, space: Compliance) -> ScaledContact:
    """Take a problem to Hertz units on given nodes; its speed stays out."""
    hertz = problem.hertz
    table = problem.law.table
    coefficients = table.coefficients.copy()
    if coefficients.size:
        coefficients[:, 0] -= np.log(hertz.peak_pressure)
    return ScaledContact(
        space=space,
        table=PressureTable(table.first - np.log(hertz.gap_scale), table.step, coefficients),
        mass_conserving=problem.lubricant.cavitation == "mass_conserving",
        roughness=problem.rms_roughness / hertz.gap_scale,
    )
