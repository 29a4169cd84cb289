"""The contact in Hertz units: x by a, pressure by p0, gap by a²/R; the speed is λ, the load is π/2."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softlub.lubrication.half_space import HalfSpace, HalfSpaceFFT
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.pressure_table import PressureTable, evaluate
from softlub.protocols import FloatArray

LOAD = 0.5 * np.pi
"""∫ P dX of every contact."""
HERTZ_BODY = HalfSpaceCylinder(radius=1.0, modulus=2.0)
"""The half-space in Hertz units: w = -(1/π) ∫ P ln|X - S| dS, gap X²/2."""


@dataclass(frozen=True, eq=False)
class ScaledContact:
    """What all speeds of a contact share.

    Parameters
    ----------
    space : HalfSpace or HalfSpaceFFT
        Elasticity on the nodes X, made of `HERTZ_BODY`.
    table : PressureTable
        The law, P_s over H.
    mass_conserving : bool
        The film's cavitation condition.
    roughness : float
        h_rms R/a².
    """

    space: HalfSpace | HalfSpaceFFT
    table: PressureTable
    mass_conserving: bool
    roughness: float

    def gap(self, pressure: FloatArray, approach: float) -> FloatArray:
        """H = H_c + X²/2 + C P, shape (n,)."""
        return approach + self.space.base_gap + self.space.deflection(pressure)

    def solid(self, gap: FloatArray) -> tuple[FloatArray, FloatArray]:
        """P_s and dP_s/dH at the gaps, shape (n,) each."""
        return evaluate(self.table, gap)


def scale(problem: Problem, space: HalfSpace | HalfSpaceFFT) -> ScaledContact:
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
