"""The source's elastohydrodynamic module (section 3.4.1, figure 3-6)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.scaled import LOAD
from softlub.lubrication.solvers.modules.contact import EvenContact, Fields, even_contact
from softlub.lubrication.solvers.modules.iteration import SMALLEST_GAP, Budget, iterate
from softlub.lubrication.solvers.modules.march import march_upward, solve_point
from softlub.lubrication.solvers.modules.relaxation import FilmFactors, film_factors
from softlub.lubrication.solvers.modules.residuals import true_residuals
from softlub.lubrication.solvers.modules.starts import Begin, fast_start
from softlub.pressure_table import EMPTY_TABLE, PressureTable
from softlub.protocols import FloatArray

ROUND_TOLERANCE = 0.1
"""What a round at one approach has to reach: this part of the tolerance (less where that turns out not to do), or …"""
ROUND_SHARE = 1e-2
"""… this part of the error of the load, where that is larger."""
LARGEST_CLOSING = 0.7
"""No sweep, and no round, takes more than this part of the smallest gap away."""
LARGEST_OPENING = 5.0
"""No round lifts the body by more than this many smallest gaps."""


@dataclass(frozen=True)
class NoAsperities:
    """The law that this module sees, whatever the surface."""

    @property
    def table(self) -> PressureTable:
        """No pressure at any separation."""
        return EMPTY_TABLE

    @property
    def separation_range(self) -> tuple[float, float]:
        """It holds everywhere."""
        return 0.0, float("inf")

    def area_ratio(self, pressure: FloatArray) -> FloatArray:
        """No contact."""
        return np.zeros_like(pressure)


@dataclass(frozen=True)
class EHL:
    """Full-film module: the fluid carries all of the load.

    It knows no asperity law: **the law of the problem is ignored**, p_s is zero, and the solution is that of smooth
    surfaces. Nested loops: innermost the Reynolds equation for the given gap, relaxed by α_l, around it the gap by
    elasticity until both stand still, outside the approach by the load (3-19, 3-20). The Reynolds equation, linear
    but for the cavitation, is eliminated at once where the source sweeps; α_c holds for the first correction of the
    approach, later ones take the slope of the last two rounds for it.

    Parameters
    ----------
    nodes : int
        Number of nodes of the even grid.
    relaxation : FilmFactors, optional
        α_l and α_c; those of the schedule in `modules.relaxation` where left out.
    memory : int
        Anderson's memory (`modules.anderson`), in the loop of gap and pressure; 0 leaves plain relaxation.
    tolerance : float
        True residual (`modules.residuals`) of a converged point.
    max_sweeps : int
        Sweeps of the loop of gap and pressure after which a point is given up.
    seconds : float
        CPU time after which a point is given up [s].
    """

    nodes: int = 1025
    relaxation: FilmFactors | None = None
    memory: int = 20
    tolerance: float = 1e-4
    max_sweeps: int = 20_000
    seconds: float = 30.0

    @property
    def name(self) -> str:
        """Name of the solver in its results."""
        return "ehl"

    def solve(self, problem: Problem, start: LubricatedContact | None = None) -> LubricatedContact:
        """Solve one point.

        Parameters
        ----------
        problem : Problem
        start : LubricatedContact, optional
            A solution nearby, of any solver; Hertz's pressure over the soft film, and a march upward, where
            left out.

        Returns
        -------
        LubricatedContact
            The last iterate, flagged where its true residual is above the tolerance.

        Raises
        ------
        ValueError
            If the film is to conserve mass.
        """
        return solve_point(self, problem, start)

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        """Solve at every speed, marching upward; results in the order of `speeds` (see `march_upward`)."""
        return march_upward(self, problem, speeds)

    def contact(self, problem: Problem) -> EvenContact:
        """The problem without its law on the even grid."""
        return even_contact(replace(problem, law=NoAsperities()), self.nodes)

    def begin(self, contact: EvenContact, budget: Budget) -> Begin:
        """A full film."""
        return fast_start(contact)

    def factors(self, contact: EvenContact) -> FilmFactors:
        """Relaxation factors in force."""
        return self.relaxation or film_factors(contact.speed_number)

    def settle(self, contact: EvenContact, start: Fields, tolerance: float, budget: Budget) -> Fields:
        """The outer loop: rounds at one approach each, until pressure, gap and load agree."""
        fluid = start.fluid + start.solid
        fields = Fields(fluid, np.zeros_like(fluid), start.gap, start.approach)
        last: tuple[float, float] | None = None
        wanted = ROUND_TOLERANCE * tolerance
        while True:
            fields = self._round(contact, fields, wanted, budget)
            residuals = true_residuals(contact, fields)
            budget.history.append(residuals.largest)
            if residuals.largest <= tolerance or budget.is_spent:
                return fields
            if residuals.load <= tolerance:
                wanted *= ROUND_TOLERANCE
            force = contact.force(fields.fluid)
            slope = -self.factors(contact).approach
            if last is not None and (fields.approach - last[0]) * (force - last[1]) < 0:
                slope = (fields.approach - last[0]) / (force - last[1])
            last = (fields.approach, force)
            smallest = float(np.min(fields.gap))
            move = np.clip(slope * (LOAD - force), -LARGEST_CLOSING * smallest, LARGEST_OPENING * smallest)
            fields = fields._replace(approach=fields.approach + float(move))

    def _round(self, contact: EvenContact, start: Fields, wanted: float, budget: Budget) -> Fields:
        """The intermediate loop: gap and pressure at one approach, until their changes are as small as wanted."""
        fluid_factor = self.factors(contact).fluid

        def measure(fields: Fields, change: FloatArray) -> float:
            error = abs(contact.force(fields.fluid) / LOAD - 1)
            return float(np.max(np.abs(change))) / (fluid_factor * max(wanted, ROUND_SHARE * error))

        return iterate(
            lambda fields: self.relax(contact, fields),
            start,
            ("fluid", "gap"),
            self.memory,
            measure,
            1.0,
            budget,
        )[0]

    def relax(self, contact: EvenContact, fields: Fields) -> Fields:
        """One sweep: the relaxed pressure for the given gap, and the gap of that pressure."""
        exact = contact.reynolds_pressure(fields.gap, fields.fluid)
        fluid = fields.fluid + self.factors(contact).fluid * (exact - fields.fluid)
        gap = contact.scaled.gap(fluid, fields.approach)
        gap = np.maximum(gap, np.maximum((1 - LARGEST_CLOSING) * fields.gap, SMALLEST_GAP))
        return fields._replace(fluid=fluid, gap=gap)
