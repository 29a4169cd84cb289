"""The source's modules on the system of Table 3-1 against Newton's method on the same even grid."""

from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest

from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.bml import BML
from softlub.lubrication.solvers.ehl import EHL
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.mehl import MEHL
from softlub.lubrication.solvers.modules.relaxation import BoundaryFactors, FilmFactors, MixedFactors
from softlub.lubrication.solvers.modules.starts import from_solution
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1e7 / (1 - 0.4999**2)
SHEAR_STRENGTH = 1e6
NODES = 257
ROUGH = Problem(
    body=HalfSpaceCylinder(radius=0.01, modulus=MODULUS),
    law=PerssonLaw(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9), MODULUS),
    lubricant=Lubricant(viscosity=0.1),
    load=100.0,
    speed=0.1,
    rms_roughness=1e-6,
    half_domain=1e-3,
)
SMOOTH = replace(ROUGH, law=NoContact())
RANGES = {
    "bml": (BML(NODES), ROUGH, (1e-5, 1e-4, 1.5e-3)),
    "mehl_gauss_seidel": (MEHL("gauss_seidel", NODES), ROUGH, (1.5e-3, 0.03, 0.12)),
    "mehl_newton_raphson": (MEHL("newton_raphson", NODES), ROUGH, (1.5e-3, 0.03, 0.12)),
    "ehl": (EHL(NODES), SMOOTH, (0.12, 1.0, 100.0)),
}
"""Module, the problem that it solves, and speeds of its range."""
UNRELAXED = {
    "bml": {"relaxation": BoundaryFactors(1.0, 1.0, 1.0)},
    "mehl_gauss_seidel": {"relaxation": MixedFactors(1.0, 1.0, 1.0)},
    "mehl_newton_raphson": {"relaxation": MixedFactors(1.0, 1.0, 1.0)},
    "ehl": {"relaxation": FilmFactors(1.0, 1.0)},
}


@lru_cache
def newton(problem: Problem, speeds: tuple[float, ...]) -> list[LubricatedContact]:
    contacts = FiniteVolume(NODES, grid="even", tolerance=1e-11).sweep(problem, list(speeds))
    assert all(contact.converged for contact in contacts)
    return contacts


def friction_coefficient(contact: LubricatedContact, problem: Problem) -> float:
    parts = friction(contact, problem.law, problem.lubricant.viscosity)
    return parts.fluid + SHEAR_STRENGTH * parts.real_contact_width / contact.load


@pytest.mark.parametrize("name", RANGES)
def test_newtons_solution_is_a_fixed_point(name: str) -> None:
    module, problem, speeds = RANGES[name]
    module = replace(module, **UNRELAXED[name])
    for speed, solution in zip(speeds, newton(problem, speeds), strict=True):
        contact = module.contact(problem.at(speed=speed))
        before = from_solution(contact, solution)
        relax = module.relaxation_sweep(contact, 1e-8) if isinstance(module, MEHL) else None
        after = relax(before) if relax else module.relax(contact, before)
        assert np.max(np.abs(after.fluid - before.fluid)) <= 1e-6
        assert np.max(np.abs(after.solid - before.solid)) <= 1e-6
        assert np.max(np.abs(after.gap - before.gap)) <= 1e-6 * before.gap.min()


@pytest.mark.parametrize("name", RANGES)
def test_module_converges_to_newtons_solution(name: str) -> None:
    module, problem, speeds = RANGES[name]
    for contact, solution in zip(module.sweep(problem, speeds), newton(problem, speeds), strict=True):
        assert contact.converged
        assert contact.residual <= module.tolerance
        expected = friction_coefficient(solution, problem)
        assert friction_coefficient(contact, problem) == pytest.approx(expected, rel=1e-3)
        assert contact.separation_min == pytest.approx(solution.separation_min, rel=1e-3)
        assert contact.rigid_approach == pytest.approx(solution.rigid_approach, rel=1e-2, abs=1e-8)


@pytest.mark.parametrize(("module", "problem", "speed"), [(BML(), ROUGH, 1e-5), (EHL(), SMOOTH, 0.12)])
def test_converges_from_cold_on_the_grid_of_the_source(
    module: BML | EHL, problem: Problem, speed: float
) -> None:
    contact = module.solve(problem.at(speed=speed))
    assert contact.positions.size == 1025
    assert contact.converged


@pytest.mark.parametrize("reynolds_sweep", ["gauss_seidel", "newton_raphson"])
def test_mixed_module_begins_from_the_boundary_module(reynolds_sweep: str) -> None:
    contact = MEHL(reynolds_sweep, NODES).solve(ROUGH.at(speed=0.03))  # type: ignore[arg-type]
    assert contact.converged


def test_mixed_module_solves_smooth_surfaces() -> None:
    contact = MEHL("newton_raphson", NODES).solve(SMOOTH.at(speed=0.12))
    (solution,) = newton(SMOOTH, (0.12,))
    assert contact.converged
    assert contact.separation_min == pytest.approx(solution.separation_min, rel=1e-3)


def test_full_film_module_ignores_the_law() -> None:
    rough, smooth = (EHL(NODES).solve(problem.at(speed=0.12)) for problem in (ROUGH, SMOOTH))
    assert np.all(rough.solid_pressure == 0)
    np.testing.assert_array_equal(rough.fluid_pressure, smooth.fluid_pressure)


@pytest.mark.parametrize("name", RANGES)
def test_stops_at_the_sweep_limit_with_a_flag(name: str) -> None:
    module, problem, speeds = RANGES[name]
    contact = replace(module, max_sweeps=7).solve(problem.at(speed=speeds[0]))
    assert contact.iterations == 7
    assert not contact.converged
    assert contact.residual > module.tolerance
    assert np.all(np.isfinite(contact.separation))


@pytest.mark.parametrize("name", RANGES)
def test_stops_at_the_time_limit_with_a_flag(name: str) -> None:
    module, problem, speeds = RANGES[name]
    contact = replace(module, seconds=0.0).solve(problem.at(speed=speeds[0]))
    assert not contact.converged
    assert contact.iterations < 100


def test_tiny_steps_are_not_taken_for_convergence() -> None:
    """The source's rule, the relaxed change of a sweep, would stop here at once."""
    (solution,) = newton(ROUGH, (1e-5,))
    wrong = replace(solution, separation=1.02 * solution.separation)
    module = BML(NODES, relaxation=BoundaryFactors(1e-7, 1e-7, 1e-7), memory=0, max_sweeps=50)
    contact = module.solve(ROUGH.at(speed=1e-5), wrong)
    assert not contact.converged
    assert contact.residual > 1e-2


def test_plain_relaxation_reaches_the_same_solution_where_it_converges() -> None:
    problem = ROUGH.at(speed=1e-5)
    plain = BML(NODES, memory=0).solve(problem)
    (solution,) = newton(ROUGH, (1e-5,))
    assert plain.converged
    expected = friction_coefficient(solution, problem)
    assert friction_coefficient(plain, problem) == pytest.approx(expected, rel=1e-3)


def test_results_come_in_the_order_of_the_speeds() -> None:
    speeds = [1e-4, 1e-5, 1e-4]
    assert [contact.speed for contact in BML(129).sweep(ROUGH, speeds)] == speeds


def test_depends_on_speed_and_viscosity_by_their_product() -> None:
    thick = replace(ROUGH, lubricant=Lubricant(viscosity=0.4))
    one, other = BML(129).solve(ROUGH.at(speed=1e-4)), BML(129).solve(thick.at(speed=0.25e-4))
    np.testing.assert_allclose(one.separation, other.separation, rtol=1e-12)


def test_default_domain_reaches_four_hertz_widths() -> None:
    open_domain = replace(ROUGH, half_domain=None)
    contact = EHL(NODES).solve(open_domain.at(speed=0.12))
    assert contact.positions[-1] == pytest.approx(4 * ROUGH.hertz.half_width)


@pytest.mark.parametrize("name", RANGES)
def test_a_hopeless_scene_is_flagged_and_raises_nothing(name: str) -> None:
    """A load under which the asperities of a 50 nm roughness are flat: the gap is far below what the grid carries."""
    module, _, _ = RANGES[name]
    law = PerssonLaw(SelfAffine(rms_roughness=5e-8, hurst=0.8, rolloff=1e4, cutoff=7.8e9), 0.05 * MODULUS)
    body = HalfSpaceCylinder(radius=0.01, modulus=0.05 * MODULUS)
    problem = replace(ROUGH, body=body, law=law, load=1e4, speed=1e-3, rms_roughness=5e-8, half_domain=None)
    contact = replace(module, nodes=65, max_sweeps=300).solve(problem)
    assert not contact.converged
    assert contact.residual > module.tolerance
    assert contact.iterations <= 300


def test_refuses_what_the_modules_cannot_treat() -> None:
    with pytest.raises(ValueError, match="smooth"):
        BML(NODES).solve(SMOOTH)
    conserving = replace(ROUGH, lubricant=Lubricant(0.1, cavitation="mass_conserving"))
    with pytest.raises(ValueError, match="mass_conserving"):
        MEHL(nodes=NODES).solve(conserving)
    with pytest.raises(ValueError, match="positive"):
        EHL(NODES).sweep(ROUGH, [0.1, -1.0])
