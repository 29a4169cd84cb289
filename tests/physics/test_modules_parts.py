"""The pieces that the modules are made of, each against an independent solution."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import optimize

from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.finite_volume.scaled import LOAD
from softlub.lubrication.solvers.mehl import MEHL
from softlub.lubrication.solvers.modules.anderson import Anderson
from softlub.lubrication.solvers.modules.contact import EvenContact, Fields, even_contact
from softlub.lubrication.solvers.modules.fredholm import MOST_STEPS, fredholm_gap
from softlub.lubrication.solvers.modules.inverse_law import gap_at_pressure
from softlub.lubrication.solvers.modules.relaxation import MixedFactors, boundary_factors
from softlub.lubrication.solvers.modules.residuals import true_residuals
from softlub.lubrication.solvers.modules.reynolds_sweep import (
    gauss_seidel_sweep,
    newton_raphson_sweep,
    solve_five_bands,
)
from softlub.lubrication.solvers.modules.starts import dry_start
from softlub.pressure_table import EMPTY_TABLE, evaluate
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1.33e7
LAW = PerssonLaw(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9), MODULUS)
PROBLEM = Problem(HalfSpaceCylinder(0.01, MODULUS), LAW, Lubricant(0.1), 100.0, 0.1, 1e-6, 1e-3)


@pytest.fixture
def contact() -> EvenContact:
    return even_contact(PROBLEM, 65)


def rigid_gap(contact: EvenContact) -> np.ndarray:
    return 0.8 + 0.5 * contact.nodes**2


def test_gauss_seidel_sweeps_reach_the_film_of_a_given_gap(contact: EvenContact) -> None:
    gap = rigid_gap(contact)
    fluid = np.zeros_like(gap)
    for _ in range(8000):
        fluid = gauss_seidel_sweep(contact.nodes, gap, fluid, contact.speed_number)
    np.testing.assert_allclose(fluid, contact.reynolds_pressure(gap, fluid), atol=1e-9 * fluid.max())
    assert np.any(fluid[contact.nodes > 0] == 0)


def test_newton_raphson_without_a_kernel_solves_a_given_gap_in_few_sweeps(contact: EvenContact) -> None:
    gap = rigid_gap(contact)
    fluid = np.zeros_like(gap)
    for _ in range(60):
        fluid = newton_raphson_sweep(contact.nodes, gap, fluid, contact.speed_number, np.zeros_like(gap))
    np.testing.assert_allclose(fluid, contact.reynolds_pressure(gap, fluid), atol=1e-9 * fluid.max())


def test_a_singular_newton_raphson_step_leaves_the_pressure(contact: EvenContact) -> None:
    fluid = np.maximum(0.0, 1 - contact.nodes**2)
    closed = np.full_like(fluid, 1e-200)
    swept = newton_raphson_sweep(contact.nodes, closed, fluid, contact.speed_number, contact.kernel)
    assert np.all(np.isfinite(swept))


def test_five_bands_against_a_dense_solution() -> None:
    random = np.random.default_rng(3)
    bands = random.uniform(-1, 1, (30, 5))
    bands[:, 2] += 5
    dense = sum(np.diag(bands[max(0, -k) : 30 - max(0, k), 2 + k], k) for k in range(-2, 3))
    right = random.normal(size=30)
    expected = np.linalg.solve(dense, right)
    np.testing.assert_allclose(solve_five_bands(bands.copy(), right.copy()), expected, rtol=1e-12)


@pytest.mark.parametrize("separation", [1e-11, 1e-9, 1e-7, 1e-6, 5e-6, 5e-5])
def test_law_is_inverted(separation: float) -> None:
    pressure = float(evaluate(LAW.table, separation)[0])
    assert gap_at_pressure(LAW.table, pressure) == pytest.approx(separation, rel=1e-9)


def test_law_of_a_smooth_surface_is_not_inverted() -> None:
    with pytest.raises(ValueError, match="smooth"):
        gap_at_pressure(EMPTY_TABLE, 1.0)


def test_anderson_solves_a_linear_map_that_diverges_by_itself() -> None:
    random = np.random.default_rng(5)
    matrix = 3 * random.normal(size=(8, 8))
    offset = random.normal(size=8)
    accelerator = Anderson(8, 8)
    state = np.zeros(8)
    for _ in range(20):
        state = accelerator.next(state, matrix @ state + offset - state)
    np.testing.assert_allclose(state, np.linalg.solve(np.eye(8) - matrix, offset), rtol=1e-6)


def test_anderson_without_memory_is_the_plain_iteration() -> None:
    accelerator = Anderson(0, 2)
    state, change = np.array([1.0, 2.0]), np.array([0.5, -0.5])
    np.testing.assert_array_equal(accelerator.next(state, change), state + change)


def test_fredholm_solver_against_a_general_root_finder(contact: EvenContact) -> None:
    start = dry_start(contact)
    fluid = 0.2 * start.solid
    given = contact.scaled.gap(fluid, start.approach)
    space = contact.scaled.space

    def equation(logarithm: np.ndarray) -> np.ndarray:
        gap = np.exp(logarithm)
        return (given + space.deflection(contact.scaled.solid(gap)[0])) / gap - 1

    gap, steps = start.gap, MOST_STEPS
    for _ in range(20):
        if steps == MOST_STEPS:
            gap, solid, steps = fredholm_gap(contact, fluid, start.approach, gap, 0.5, 1e-8)
    assert 0 < steps < MOST_STEPS
    expected = optimize.root(equation, np.log(start.gap), tol=1e-12)
    assert expected.success
    np.testing.assert_allclose(gap, np.exp(expected.x), rtol=1e-6)
    np.testing.assert_array_equal(solid, contact.scaled.solid(gap)[0])


def test_each_residual_sees_its_own_equation(contact: EvenContact) -> None:
    slow = contact.at(1e-12)
    gap = dry_start(slow).gap
    solid = slow.scaled.solid(gap)[0]
    fluid = slow.reynolds_pressure(gap, np.zeros_like(gap))
    approach = 0.3
    before = true_residuals(slow, Fields(fluid, solid, gap, approach))
    mismatch = np.max(np.abs(slow.scaled.gap(fluid + solid, approach) - gap) / gap)
    assert before.fluid == 0
    assert before.law == 0
    assert before.elasticity == pytest.approx(mismatch)
    assert before.load == pytest.approx(abs(slow.force(fluid + solid) / LOAD - 1))
    after = true_residuals(slow, Fields(fluid + 0.01, solid - 0.02, gap, approach))
    assert after.fluid == pytest.approx(0.01)
    assert after.law == pytest.approx(0.02)


def test_a_residual_that_is_no_number_is_infinite(contact: EvenContact) -> None:
    start = dry_start(contact)
    broken = start._replace(solid=np.full_like(start.solid, np.nan))
    assert true_residuals(contact, broken).largest == np.inf


def test_relaxation_factors_keep_to_the_source() -> None:
    for speed_number in np.geomspace(1e-6, 1e3, 30):
        factors = boundary_factors(speed_number)
        assert 0.001 <= factors.fluid < factors.gap <= 0.1
        assert factors.gap < factors.solid <= 1


def test_approach_is_held_while_the_load_approaches_with_plain_relaxation() -> None:
    """Equation 3-27 with its sign put right: from the second sweep on, a load that rises towards W moves nothing."""
    contact = even_contact(replace(PROBLEM, law=NoContact(), speed=10.0), 65)
    empty = np.zeros_like(contact.nodes)
    light = Fields(empty, empty, 20 + 0.5 * contact.nodes**2, 20.0)
    plain = MEHL(nodes=65, memory=0, relaxation=MixedFactors(0.5, 1e-3, 0.5))
    relax = plain.relaxation_sweep(contact, 1e-4)
    first = relax(light)
    assert first.approach < light.approach
    second = relax(first)
    assert contact.force(first.fluid) < contact.force(second.fluid) < LOAD
    assert second.approach == first.approach
    accelerated = replace(plain, memory=5).relaxation_sweep(contact, 1e-4)
    accelerated(light)
    assert accelerated(first).approach < first.approach
