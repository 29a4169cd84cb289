"""Newton's method for one speed: total pressure and rigid approach together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from softlub.lubrication.solvers.finite_volume.equations import Linearisation, State, linearise
from softlub.lubrication.solvers.finite_volume.front import Creep, last_pressurised, with_front
from softlub.lubrication.solvers.finite_volume.scaled import ScaledContact
from softlub.protocols import FloatArray

LARGEST_CLOSING = 0.8
"""Largest relative fall of the separation at any node in one step."""
DIVERGED = 1e4
"""A residual from which there is no way back, in units of the Hertz pressure."""
ROUND_OFF_LIMIT = 1e-5
"""No residual above this is put down to round-off."""
TRUSTED_FRONT = 3
"""Nodes by which the complementarity's front may differ from the start's and be used in the first step."""


@dataclass(frozen=True, eq=False)
class Iterate:
    """Where Newton's method ended."""

    state: State
    equations: Linearisation
    converged: bool
    iterations: int
    history: tuple[float, ...]


class StepSolver(Protocol):
    """Solver of the linearised equations."""

    def __call__(self, contact: ScaledContact, equations: Linearisation) -> tuple[FloatArray, float]:
        """Changes of P, shape (n,), and of H_c; not finite where the equations are singular."""
        ...


def solve_speed(
    contact: ScaledContact,
    speed_number: float,
    start: State,
    step_solver: StepSolver,
    tolerance: float,
    most_steps: int,
) -> Iterate:
    """Solve the equations of one speed from a start that is near.

    Parameters
    ----------
    contact : ScaledContact
    speed_number : float
        λ.
    start : State
    step_solver : StepSolver
    tolerance : float
        Largest residual of a solution, in units of the Hertz pressure.
    most_steps : int
        Steps after which to give up.

    Returns
    -------
    Iterate
        Converged or not; nothing is raised.
    """
    state, gap = _admissible(contact, start)
    history: list[float] = []
    creep = Creep()
    while True:
        equations = linearise(contact, speed_number, state, gap)
        history.append(equations.residual)
        converged = _is_solved(equations, tolerance)
        if converged or len(history) > most_steps or not history[-1] < DIVERGED:
            state = state._replace(front=last_pressurised(equations))
            return Iterate(state, equations, converged, len(history) - 1, tuple(history))
        if len(history) > 1:
            equations = creep.overtake(equations)
        elif abs(last_pressurised(equations) - state.front) > TRUSTED_FRONT:
            equations = with_front(equations, round(state.front))
        state, gap = _step(contact, equations, state, step_solver)


def _is_solved(equations: Linearisation, tolerance: float) -> bool:
    """Whether the residual is below the tolerance, or so small that round-off explains it."""
    residual = equations.residual
    return residual <= tolerance or (residual <= ROUND_OFF_LIMIT and residual <= equations.round_off)


def _admissible(contact: ScaledContact, start: State) -> tuple[State, FloatArray]:
    """The start with its body lifted until no gap is closed."""
    gap = contact.gap(start.pressure, start.approach)
    lift = max(0.0, 1e-3 * float(np.median(np.abs(gap))) - float(gap.min())) if gap.min() <= 0 else 0.0
    return start._replace(approach=start.approach + lift), gap + lift


def _step(
    contact: ScaledContact, equations: Linearisation, state: State, step_solver: StepSolver
) -> tuple[State, FloatArray]:
    """One damped step: no separation falls by more than `LARGEST_CLOSING`."""
    pressure_change, approach_change = step_solver(contact, equations)
    closing = -(contact.space.deflection(pressure_change) + approach_change) / equations.gap
    share = min(1.0, LARGEST_CLOSING / max(float(np.max(closing)), LARGEST_CLOSING))
    pressure = state.pressure + share * pressure_change
    approach = state.approach + share * approach_change
    gap = contact.gap(pressure, approach)
    passive = slice(equations.unknowns, None)
    pressure[passive] = contact.solid(gap[passive])[0]
    pressure[0] = contact.solid(gap[:1])[0][0]
    return State(pressure, approach, state.front), gap
