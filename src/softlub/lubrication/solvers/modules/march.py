"""One point from a start or from cold, and the march upward in speed, for any of the modules."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.modules.contact import EvenContact, Fields
from softlub.lubrication.solvers.modules.iteration import Budget
from softlub.lubrication.solvers.modules.outcome import outcome
from softlub.lubrication.solvers.modules.residuals import true_residuals
from softlub.lubrication.solvers.modules.starts import Begin, from_solution

LARGEST_RATIO = 2.0
"""Largest ratio of two speeds on the way from a start."""
SMALLEST_RATIO = 1.1
"""Ratio of speeds below which the way is given up and the goal is tried at once."""
WAY_TOLERANCE = 1e-2
"""True residual that is good enough for a speed on the way."""
WAY_SWEEPS = 500
"""Sweeps that a speed on the way may take."""


class Module(Protocol):
    """What one of the source's modules brings."""

    @property
    def nodes(self) -> int:
        """Number of nodes of the even grid."""
        ...

    @property
    def tolerance(self) -> float:
        """True residual of a converged point."""
        ...

    @property
    def max_sweeps(self) -> int:
        """Sweeps that a point may take."""
        ...

    @property
    def seconds(self) -> float:
        """CPU time that a point may take [s]."""
        ...

    @property
    def name(self) -> str:
        """Name of the solver in its results."""
        ...

    def contact(self, problem: Problem) -> EvenContact:
        """The problem as the module sees it."""
        ...

    def begin(self, contact: EvenContact, budget: Budget) -> Begin:
        """Where to begin without a start; sweeps that it takes are counted."""
        ...

    def settle(self, contact: EvenContact, start: Fields, tolerance: float, budget: Budget) -> Fields:
        """Iterate at one speed until the true residual is at most the tolerance or the budget is spent."""
        ...


def solve_point(module: Module, problem: Problem, start: LubricatedContact | None) -> LubricatedContact:
    """One point, from a solution nearby or from the module's own start.

    Parameters
    ----------
    module : Module
    problem : Problem
    start : LubricatedContact, optional

    Returns
    -------
    LubricatedContact
        Sweeps and seconds are those of the whole way.
    """
    contact = module.contact(problem)
    budget = Budget(module.max_sweeps, module.seconds)
    # A diverging iterate may overflow; its residual then is infinite, and that is what flags it.
    with np.errstate(over="ignore", invalid="ignore", divide="ignore", under="ignore"):
        if start is None:
            begin = module.begin(contact, budget)
        else:
            # The start's viscosity is not known here; taken for the problem's own, it only sets the steps.
            begin = Begin(
                contact.speed_number * start.speed / problem.speed, from_solution(contact, start), True
            )
        fields = follow(module, contact, begin, budget)
        fields = module.settle(contact, fields, module.tolerance, budget)
        residual = true_residuals(contact, fields).largest
        return outcome(contact, fields, residual, module.tolerance, budget, module.name)


def follow(module: Module, contact: EvenContact, begin: Begin, budget: Budget) -> Fields:
    """Fields to settle the goal from, by way of speeds between that are settled loosely; a failing step is halved."""
    goal, ratio = contact.speed_number, LARGEST_RATIO
    place, fields, is_settled = begin
    while place != goal and not (is_settled and 1 / ratio <= goal / place <= ratio) and not budget.is_spent:
        target = _next_place(place, goal, ratio) if is_settled else place
        between = contact.at(contact.problem.speed * target / goal)
        share = Budget(
            min(WAY_SWEEPS, budget.max_sweeps - budget.sweeps), budget.seconds - budget.used_seconds
        )
        tried = module.settle(between, fields, WAY_TOLERANCE, share)
        budget.sweeps += share.sweeps
        if true_residuals(between, tried).largest <= WAY_TOLERANCE:
            place, fields, is_settled = target, tried, True
            continue
        if not is_settled:
            break
        ratio **= 0.5
        if ratio < SMALLEST_RATIO:
            break
    return fields


def _next_place(place: float, goal: float, ratio: float) -> float:
    return place * ratio if goal > place else place / ratio


def march_upward(module: Module, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
    """All speeds in ascending order, each from the last good one.

    Parameters
    ----------
    module : Module
    problem : Problem
        Its own speed is not used.
    speeds : sequence of float
        v [m/s], in any order.

    Returns
    -------
    list of LubricatedContact
        In the order of `speeds`.

    Raises
    ------
    ValueError
        If a speed is not positive and finite.
    """
    wanted = np.asarray(speeds, dtype=float)
    if not np.all(np.isfinite(wanted) & (wanted > 0)):
        raise ValueError(f"speeds must be positive and finite, not {wanted}")
    results: dict[float, LubricatedContact] = {}
    good: LubricatedContact | None = None
    for speed in np.unique(wanted):
        result = solve_point(module, problem.at(speed=float(speed)), good)
        results[float(speed)] = result
        good = result if result.converged else good
    return [results[float(speed)] for speed in wanted]
