"""Newton's method for one speed: total pressure and rigid approach together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np

from softlub.lubrication.solvers.finite_volume.fluxes import face_fluxes
from softlub.lubrication.solvers.finite_volume.rows import Rows, complementarity_rows
from softlub.lubrication.solvers.finite_volume.scaled import LOAD, ScaledContact
from softlub.protocols import FloatArray

LARGEST_CLOSING = 0.8
"""Largest relative fall of the separation at any node in one step."""
NEGLIGIBLE_SLOPE = 1e-13
"""Cavitated nodes beyond the last whose asperities are stiffer than this follow the gap instead of being unknowns."""
FIRST_ROUNDING = 1e-3
"""ε of the first rounded step after a two-cycle."""


class State(NamedTuple):
    """The unknowns of one speed in Hertz units."""

    pressure: FloatArray
    """Total pressure P, shape (n,)."""
    approach: float
    """H_c."""


class Linearisation(NamedTuple):
    """Residuals of all equations at a state, and what their derivatives are made of."""

    gap: FloatArray
    solid: FloatArray
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
    def unknowns(self) -> int:
        """Nodes 1 … unknowns-1 are solved for; the rest of the outlet carries no pressure worth the name."""
        live = np.flatnonzero((self.rows.flux_weight != 0) | (np.abs(self.law_slope) > NEGLIGIBLE_SLOPE))
        return min(int(live[-1]) + 2 if live.size else 2, self.gap.size - 1)


def linearise(
    contact: ScaledContact, speed_number: float, state: State, gap: FloatArray, rounding: float
) -> Linearisation:
    """Evaluate all equations at a state whose gap is given."""
    solid, law_slope = contact.solid(gap)
    fluid = state.pressure - solid
    flux, conductance, by_gap = face_fluxes(contact.space.positions, gap, fluid, speed_number)
    rows = Rows(*complementarity_rows(fluid, flux, conductance, contact.mass_conserving, rounding))
    load = float(contact.space.widths @ state.pressure) - LOAD
    return Linearisation(gap, solid, law_slope, flux, conductance, by_gap, rows, load)


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
    rounding = 0.0
    while True:
        equations = linearise(contact, speed_number, state, gap, rounding)
        if rounding == 0.0:
            history.append(equations.residual)
        converged = history[-1] <= tolerance and rounding == 0.0
        if converged or len(history) > most_steps or not np.isfinite(equations.residual):
            return Iterate(state, equations, converged, len(history) - 1, tuple(history))
        if rounding == 0.0 and _runs_in_circles(history):
            rounding = FIRST_ROUNDING
            continue
        state, gap = _step(contact, equations, state, step_solver)
        rounding = 0.0


def _admissible(contact: ScaledContact, start: State) -> tuple[State, FloatArray]:
    """The start with its body lifted until no gap is closed."""
    gap = contact.gap(start.pressure, start.approach)
    lift = max(0.0, 1e-3 * float(np.median(np.abs(gap))) - float(gap.min())) if gap.min() <= 0 else 0.0
    return State(start.pressure, start.approach + lift), gap + lift


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
    return State(pressure, approach), gap


def _runs_in_circles(history: list[float]) -> bool:
    """Whether the residual repeats with a period of two steps."""
    return len(history) > 4 and all(abs(history[-k] - history[-k - 2]) <= 1e-3 * history[-k] for k in (1, 2))
