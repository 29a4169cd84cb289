"""The source's mixed elastohydrodynamic module (section 3.4.3, figure 3-8)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.bml import BML
from softlub.lubrication.solvers.finite_volume.scaled import LOAD
from softlub.lubrication.solvers.modules.contact import LARGEST_PRESSURE, EvenContact, Fields, even_contact
from softlub.lubrication.solvers.modules.fredholm import MEMORY as FREDHOLM_MEMORY
from softlub.lubrication.solvers.modules.fredholm import fredholm_gap
from softlub.lubrication.solvers.modules.iteration import Budget, iterate
from softlub.lubrication.solvers.modules.march import WAY_TOLERANCE, follow, march_upward, solve_point
from softlub.lubrication.solvers.modules.relaxation import MIXED_FACTORS, MixedFactors
from softlub.lubrication.solvers.modules.residuals import true_residuals
from softlub.lubrication.solvers.modules.reynolds_sweep import gauss_seidel_sweep, newton_raphson_sweep
from softlub.lubrication.solvers.modules.starts import Begin, fast_start, mixed_speed_number
from softlub.protocols import FloatArray

CHECK_EVERY = 5
"""Sweeps between two looks at the true residual."""
HEAD_START = 2.0
"""Without a start, the boundary-mixed module prepares a speed lower by at least this."""
FREDHOLM_TOLERANCE = 1e-2
"""Tolerance of the Fredholm solver over that of the module."""


@dataclass(frozen=True)
class MEHL:
    """Mixed module: one Reynolds sweep at a time, the approach by the load, gap and asperities by a Fredholm equation.

    One sweep: p_f by one Reynolds equation sweep (RES), relaxed by α_f; the central separation updater (CSU) moves H_c
    by -α_c times the load's deficit (3-26); the Fredholm solver (FS) gives u and p_s for these (3-28 to 3-30).

    The source moves H_c only while the load is not approaching W (3-27 with its sign put right). That rule makes the
    sweep a discontinuous map, which no acceleration survives: it holds where the relaxation is plain (memory 0);
    otherwise H_c moves at every sweep and Anderson's method keeps the load from overshooting.

    Parameters
    ----------
    reynolds_sweep : {"gauss_seidel", "newton_raphson"}
        How p_f is updated: node by node, or by one step with the kernel's near field in three zones.
    nodes : int
        Number of nodes of the even grid.
    relaxation : MixedFactors, optional
        α_f, α_c, α_fs; those of the schedule in `modules.relaxation` where left out.
    memory : int
        Anderson's memory (`modules.anderson`), in the sweeps; 0 leaves the source's plain relaxation throughout.
    tolerance : float
        True residual (`modules.residuals`) of a converged point.
    max_sweeps : int
        Sweeps after which a point is given up.
    seconds : float
        CPU time after which a point is given up [s].
    """

    reynolds_sweep: Literal["gauss_seidel", "newton_raphson"] = "gauss_seidel"
    nodes: int = 1025
    relaxation: MixedFactors | None = None
    memory: int = 80
    tolerance: float = 1e-4
    max_sweeps: int = 20_000
    seconds: float = 30.0

    @property
    def name(self) -> str:
        """Name of the solver in its results."""
        return "mehl"

    def solve(self, problem: Problem, start: LubricatedContact | None = None) -> LubricatedContact:
        """Solve one point.

        Parameters
        ----------
        problem : Problem
        start : LubricatedContact, optional
            A solution nearby, of any solver. Where left out: for rough surfaces the boundary-mixed module at a lower
            speed, itself begun from the dry Hertz contact, and a march upward; for smooth ones a full film.

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
        """The problem on the even grid."""
        return even_contact(problem, self.nodes)

    def begin(self, contact: EvenContact, budget: Budget) -> Begin:
        """The boundary-mixed module at a lower speed, as in the source; a full film where only the fluid can carry."""
        if contact.scaled.table.coefficients.shape[0] == 0:
            return fast_start(contact)
        speed_number = min(contact.speed_number / HEAD_START, mixed_speed_number(contact))
        slower = contact.at(contact.problem.speed * speed_number / contact.speed_number)
        boundary = BML(self.nodes)
        fields = follow(boundary, slower, boundary.begin(slower, budget), budget)
        return Begin(speed_number, boundary.settle(slower, fields, WAY_TOLERANCE, budget), True)

    def settle(self, contact: EvenContact, start: Fields, tolerance: float, budget: Budget) -> Fields:
        """Iterate at one speed."""

        def measure(fields: Fields, _: object) -> float:
            budget.history.append(true_residuals(contact, fields).largest)
            return budget.history[-1]

        return iterate(
            self.relaxation_sweep(contact, tolerance),
            start,
            ("fluid", "gap", "approach"),
            self.memory,
            measure,
            tolerance,
            budget,
            CHECK_EVERY,
        )[0]

    def relaxation_sweep(self, contact: EvenContact, tolerance: float) -> Callable[[Fields], Fields]:
        """One sweep as a function of the fields; with plain relaxation it remembers the last load (3-27)."""
        factors = self.relaxation or MIXED_FACTORS[self.reynolds_sweep]
        inner_memory = FREDHOLM_MEMORY if self.memory else 0
        last_force: list[float] = []

        def relax(fields: Fields) -> Fields:
            swept = self._reynolds(contact, fields)
            fluid = fields.fluid + factors.fluid * (swept - fields.fluid)
            force = contact.force(fluid + contact.scaled.solid(fields.gap)[0])
            deficit = LOAD - force
            approaching = bool(last_force) and (force - last_force[-1]) * deficit > 0
            last_force[:] = [force]
            held = approaching and self.memory == 0
            approach = fields.approach if held else fields.approach - factors.approach * deficit
            gap, solid, _ = fredholm_gap(
                contact,
                fluid,
                approach,
                fields.gap,
                factors.fredholm,
                FREDHOLM_TOLERANCE * tolerance,
                inner_memory,
            )
            return Fields(fluid, solid, gap, approach)

        return relax

    def _reynolds(self, contact: EvenContact, fields: Fields) -> FloatArray:
        """RES: P_f after one sweep, cut like the Reynolds equation's own solution."""
        nodes, speed_number = contact.nodes, contact.speed_number
        if self.reynolds_sweep == "gauss_seidel":
            swept = gauss_seidel_sweep(nodes, fields.gap, fields.fluid, speed_number)
        else:
            swept = newton_raphson_sweep(nodes, fields.gap, fields.fluid, speed_number, contact.kernel)
        return np.minimum(swept, LARGEST_PRESSURE)
