"""The two ways of solving a Newton step, and what extrapolation gains."""

from dataclasses import replace

import numpy as np
import pytest
from test_finite_volume import PROBLEM, observed

from softlub.lubrication.half_space import HalfSpace
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.finite_volume.dense import Elimination
from softlub.lubrication.solvers.finite_volume.equations import linearise
from softlub.lubrication.solvers.finite_volume.extrapolation import extrapolated_sweep, richardson
from softlub.lubrication.solvers.finite_volume.grid import EvenGrid
from softlub.lubrication.solvers.finite_volume.krylov import gmres
from softlub.lubrication.solvers.finite_volume.level import make_level, state_of
from softlub.lubrication.solvers.finite_volume.scaled import HERTZ_BODY
from softlub.lubrication.solvers.finite_volume.transform import Transforms

NARROW = replace(PROBLEM, half_domain=1e-3)


def test_gmres_solves_a_system() -> None:
    rng = np.random.default_rng(3)
    matrix = rng.normal(size=(30, 30)) + 8 * np.eye(30)
    right = rng.normal(size=30)
    solution, products = gmres(lambda v: matrix @ v, lambda v: v / 8, right, 1e-12, 40)
    assert solution == pytest.approx(np.linalg.solve(matrix, right), rel=1e-9)
    assert products <= 30
    assert np.all(gmres(lambda v: v, lambda v: v, np.zeros(4), 1e-6, 5)[0] == 0)


@pytest.mark.parametrize("cavitation", ["reynolds", "mass_conserving"])
@pytest.mark.parametrize("speed", [1e-5, 0.03, 1.0])
def test_transforms_and_elimination_take_the_same_step(cavitation: str, speed: float) -> None:
    lubricant = replace(NARROW.lubricant, cavitation=cavitation)
    problem = replace(NARROW, lubricant=lubricant, speed=speed)
    near = FiniteVolume(257, grid="even").solve(problem.at(speed=1.1 * speed))
    level = make_level(problem, EvenGrid(), 257, 1e-10, 15)
    start = state_of(level, problem, near)
    equations = linearise(level.contact, problem.speed_number, start, level.contact.gap(*start[:2]))
    space = level.contact.space
    dense = Elimination(HalfSpace(HERTZ_BODY, space.positions).matrix())(level.contact, equations)
    fast = Transforms(space, tolerance=1e-12)(level.contact, equations)
    assert np.max(np.abs(fast[0] - dense[0])) <= 1e-7 * np.max(np.abs(dense[0]))
    assert fast[1] == pytest.approx(dense[1], rel=1e-7, abs=1e-12)


def test_even_grid_converges_to_the_graded_one() -> None:
    speeds = [1e-3, 0.1]
    even = [observed(c) for c in FiniteVolume(1025, grid="even").sweep(NARROW, speeds)]
    graded = [observed(c) for c in FiniteVolume(513).sweep(NARROW, speeds)]
    assert np.array(even) == pytest.approx(np.array(graded), rel=1e-3)


def friction_coefficient(contact: LubricatedContact) -> float:
    return observed(contact)[0] if contact.converged else np.nan


def test_extrapolation_removes_the_second_order() -> None:
    speeds = np.geomspace(1e-5, 10, 13)
    limit = extrapolated_sweep(FiniteVolume(1025), PROBLEM, speeds, friction_coefficient)
    plain = np.array([friction_coefficient(c) for c in FiniteVolume(257).sweep(PROBLEM, speeds)])
    better = extrapolated_sweep(FiniteVolume(257), PROBLEM, speeds, friction_coefficient)
    assert np.max(np.abs(better - limit)) < 1e-4
    assert np.max(np.abs(better - limit)) < 0.3 * np.max(np.abs(plain - limit))
    h = np.array([0.2, 0.1])
    assert richardson(*(3 + 5 * h**2)) == pytest.approx(3)


def test_extrapolation_below_the_coarsest_grid_of_the_sweep() -> None:
    value = extrapolated_sweep(FiniteVolume(129), PROBLEM, [0.1], friction_coefficient)
    assert value == pytest.approx(0.03698, rel=2e-3)


def test_extrapolation_needs_an_odd_number_of_nodes() -> None:
    with pytest.raises(ValueError, match="odd"):
        extrapolated_sweep(FiniteVolume(128), PROBLEM, [0.1], friction_coefficient)


def test_extrapolation_keeps_failures_apart() -> None:
    values = extrapolated_sweep(FiniteVolume(257, most_steps=1), PROBLEM, [0.1], friction_coefficient)
    assert np.all(np.isnan(values))
