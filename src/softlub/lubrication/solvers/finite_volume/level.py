"""One grid of the solver: its contact, its Newton method, and the way from a coarser grid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softlub.lubrication.half_space import HalfSpaceFFT
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.dense import Elimination
from softlub.lubrication.solvers.finite_volume.equations import State
from softlub.lubrication.solvers.finite_volume.grid import Grid
from softlub.lubrication.solvers.finite_volume.newton import Iterate, StepSolver, solve_speed
from softlub.lubrication.solvers.finite_volume.scaled import ScaledContact, scale
from softlub.lubrication.solvers.finite_volume.transform import Transforms
from softlub.protocols import FloatArray


@dataclass(frozen=True, eq=False)
class Level:
    """A contact on one grid and how its equations are solved."""

    contact: ScaledContact
    step_solver: StepSolver
    tolerance: float
    most_steps: int

    def correct(self, speed_number: float, start: State) -> Iterate:
        """Newton's method at λ."""
        return solve_speed(
            self.contact, speed_number, start, self.step_solver, self.tolerance, self.most_steps
        )


def make_level(problem: Problem, grid: Grid, nodes: int, tolerance: float, most_steps: int) -> Level:
    """The level of a number of nodes."""
    space = grid.space(problem, nodes)
    step_solver = Transforms(space) if isinstance(space, HalfSpaceFFT) else Elimination(space.matrix())
    return Level(scale(problem, space), step_solver, tolerance, most_steps)


def refine(values: FloatArray) -> FloatArray:
    """Values on 2n - 1 nodes from those on every second one, by cubics in the grid's even parameter."""
    fine = np.empty(2 * values.size - 1)
    fine[::2] = values
    fine[1::2] = 0.5 * (values[1:] + values[:-1])
    fine[3:-3:2] += (values[1:-2] + values[2:-1] - values[:-3] - values[3:]) / 16
    return fine


def state_of(level: Level, problem: Problem, solution: LubricatedContact) -> State:
    """A start on this level from a solution of whatever solver, grid, load and modulus.

    The total pressure is interpolated and scaled to the load; the rigid approach follows from the central gap.
    """
    hertz, space = problem.hertz, level.contact.space
    places = space.positions * hertz.half_width
    total = np.interp(
        places, solution.positions, solution.fluid_pressure + solution.solid_pressure, left=0.0, right=0.0
    )
    pressure = total * (0.5 * np.pi / float(space.widths @ total))
    apex = level.contact.apex
    opening = solution.separation_central / hertz.gap_scale
    front = float(np.searchsorted(places, solution.rupture)) - 1
    return State(pressure, opening - float((space.base_gap + space.deflection(pressure))[apex]), front)
