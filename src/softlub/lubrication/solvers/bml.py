"""The source's boundary-mixed lubrication module (section 3.4.2, figure 3-7)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.scaled import LOAD
from softlub.lubrication.solvers.modules.contact import EvenContact, Fields, even_contact
from softlub.lubrication.solvers.modules.inverse_law import gap_at_pressure
from softlub.lubrication.solvers.modules.iteration import SMALLEST_GAP, Budget, iterate
from softlub.lubrication.solvers.modules.march import march_upward, solve_point
from softlub.lubrication.solvers.modules.relaxation import BoundaryFactors, boundary_factors
from softlub.lubrication.solvers.modules.residuals import true_residuals
from softlub.lubrication.solvers.modules.starts import Begin, slow_start

LARGEST_RENORMALISATION = 5.0
"""k1 and 1/k1 are kept below this: early iterates may have more fluid pressure than load."""
SMALLEST_CLOSING = 0.5
"""No sweep takes more than this part of the gap away."""
CHECK_EVERY = 5
"""Sweeps between two looks at the true residual."""


@dataclass(frozen=True)
class BML:
    """Boundary-mixed module: the asperities carry the load, the fluid takes part of it from them.

    One sweep: Reynolds equation for the given gap, p_f relaxed by α_f (3-21); p_s scaled by k1 to the load (3-22);
    u(0) from the law's inverse at k1 p_s(0) (3-23, for any law); u by elasticity, relaxed by α_u; p_s by the law,
    relaxed by α_s.

    Parameters
    ----------
    nodes : int
        Number of nodes of the even grid.
    relaxation : BoundaryFactors, optional
        α_f, α_u, α_s; those of the schedule in `modules.relaxation` where left out.
    memory : int
        Anderson's memory (`modules.anderson`); 0 leaves the source's plain relaxation.
    tolerance : float
        True residual (`modules.residuals`) of a converged point.
    max_sweeps : int
        Sweeps after which a point is given up.
    seconds : float
        CPU time after which a point is given up [s].
    """

    nodes: int = 1025
    relaxation: BoundaryFactors | None = None
    memory: int = 20
    tolerance: float = 1e-4
    max_sweeps: int = 20_000
    seconds: float = 30.0

    @property
    def name(self) -> str:
        """Name of the solver in its results."""
        return "bml"

    def solve(self, problem: Problem, start: LubricatedContact | None = None) -> LubricatedContact:
        """Solve one point.

        Parameters
        ----------
        problem : Problem
        start : LubricatedContact, optional
            A solution nearby, of any solver; the dry Hertz contact and a march upward in speed where left out.

        Returns
        -------
        LubricatedContact
            The last iterate, flagged where its true residual is above the tolerance.

        Raises
        ------
        ValueError
            If the surface is smooth, or the film is to conserve mass.
        """
        return solve_point(self, problem, start)

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        """Solve at every speed, marching upward; results in the order of `speeds` (see `march_upward`)."""
        return march_upward(self, problem, speeds)

    def contact(self, problem: Problem) -> EvenContact:
        """The problem on the even grid.

        Raises
        ------
        ValueError
            If its law bears no pressure.
        """
        if problem.law.table.coefficients.shape[0] == 0:
            raise ValueError(
                "the boundary-mixed module takes the film from the asperity pressure and cannot treat a smooth "
                "surface; use mehl or ehl"
            )
        return even_contact(problem, self.nodes)

    def begin(self, contact: EvenContact, budget: Budget) -> Begin:
        """The dry contact, at a speed where it is a good start."""
        return slow_start(contact)

    def settle(self, contact: EvenContact, start: Fields, tolerance: float, budget: Budget) -> Fields:
        """Iterate at one speed."""

        def measure(fields: Fields, _: object) -> float:
            budget.history.append(true_residuals(contact, fields).largest)
            return budget.history[-1]

        return iterate(
            lambda fields: self.relax(contact, fields),
            start,
            ("fluid", "solid", "gap"),
            self.memory,
            measure,
            tolerance,
            budget,
            CHECK_EVERY,
        )[0]

    def relax(self, contact: EvenContact, fields: Fields) -> Fields:
        """One sweep."""
        factors = self.relaxation or boundary_factors(contact.speed_number)
        exact_fluid = contact.reynolds_pressure(fields.gap, fields.fluid)
        fluid = fields.fluid + factors.fluid * (exact_fluid - fields.fluid)
        scaled_solid = fields.solid * _renormalisation(contact, fluid, fields.solid)
        deflected = contact.scaled.gap(fluid + scaled_solid, 0.0)
        centre = contact.centre
        opening = gap_at_pressure(
            contact.scaled.table, max(float(scaled_solid[centre]), np.finfo(float).tiny)
        )
        approach = opening - float(deflected[centre])
        gap = fields.gap + factors.gap * (deflected + approach - fields.gap)
        gap = np.maximum(gap, np.maximum(SMALLEST_CLOSING * fields.gap, SMALLEST_GAP))
        solid = fields.solid + factors.solid * (contact.scaled.solid(gap)[0] - fields.solid)
        return Fields(fluid, solid, gap, approach)


def _renormalisation(contact: EvenContact, fluid: np.ndarray, solid: np.ndarray) -> float:
    """k1 = (W - ∫p_f)/∫p_s (equation 3-22)."""
    wanted, carried = LOAD - contact.force(fluid), contact.force(solid)
    least, most = carried / LARGEST_RENORMALISATION, carried * LARGEST_RENORMALISATION
    return float(np.clip(wanted, least, most)) / carried if carried > 0 else 1.0
