"""The spectral solver on the system of Table 3-1: reference values, convergence, exact relations, honesty."""

from dataclasses import replace

import numpy as np
import pytest

from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.spectral import Spectral
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1e7 / (1 - 0.4999**2)
SHEAR_STRENGTH = 1e6
SPEEDS = np.geomspace(1e-5, 100, 40)
PROBLEM = Problem(
    body=HalfSpaceCylinder(radius=0.01, modulus=MODULUS),
    law=PerssonLaw(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9), MODULUS),
    lubricant=Lubricant(viscosity=0.1),
    load=100.0,
    speed=0.1,
    rms_roughness=1e-6,
)


def total_friction(contact, problem=PROBLEM):
    parts = friction(contact, problem.law, problem.lubricant.viscosity)
    return parts.fluid + SHEAR_STRENGTH * parts.real_contact_width / problem.load


def curve(order, problem=PROBLEM, speeds=SPEEDS):
    contacts = Spectral(order).sweep(problem, speeds)
    return (
        np.array([total_friction(c, problem) for c in contacts]),
        np.array([c.separation_min for c in contacts]),
        contacts,
    )


@pytest.fixture(scope="module")
def reference():
    return curve(20)


@pytest.fixture(scope="module")
def default():
    return curve(8)


def test_reference_values():
    """Friction, smallest separation and asperity share from two other solvers, extrapolated in their grids."""
    expected = np.array(
        [
            [1e-5, 0.36154, 0.05626e-6, 0.9096],
            [1e-3, 0.15672, 0.3003e-6, 0.3882],
            [0.0425, 0.02908, 2.3766e-6, 0.0181],
            [0.1, 0.03698, 4.2072e-6, 0.00256],
        ]
    )
    friction_found, film, contacts = curve(8, speeds=expected[:, 0])
    share = [friction(c, PROBLEM.law, 0.1).load_share_solid for c in contacts]
    np.testing.assert_allclose(friction_found, expected[:, 1], rtol=2e-4)
    np.testing.assert_allclose(film, expected[:, 2], rtol=1e-3)
    np.testing.assert_allclose(share, expected[:, 3], rtol=1e-3, atol=5e-5)


def test_accuracy_of_the_default_order(reference, default):
    assert all(c.converged for c in default[2])
    assert np.max(np.abs(default[0] - reference[0])) < 2e-6
    assert np.max(np.abs(default[1] / reference[1] - 1)) < 1e-4


def test_error_falls_geometrically_with_the_order(reference):
    errors = np.array([np.max(np.abs(curve(order)[0] - reference[0])) for order in (5, 7, 9, 11)])
    rates = errors[:-1] / errors[1:]
    assert np.all(rates > 5)
    assert errors[0] / errors[-1] > 1e4


def test_the_poiseuille_part_is_minus_the_centroid(default):
    """μ_Poiseuille = -x̄/(2R), x̄ the centroid of the total pressure, for any law."""
    for contact in default[2]:
        total = contact.fluid_pressure + contact.solid_pressure
        centroid = contact.weights @ (contact.positions * total) / PROBLEM.load
        poiseuille = friction(contact, PROBLEM.law, 0.1).poiseuille
        assert poiseuille == pytest.approx(-centroid / (2 * PROBLEM.body.radius), abs=1e-6)


def test_load_and_complementarity(default):
    for contact in default[2]:
        load = contact.weights @ (contact.fluid_pressure + contact.solid_pressure)
        assert load == pytest.approx(PROBLEM.load, rel=1e-10)
        assert contact.load_error < 1e-10
        cavitated = contact.positions >= contact.rupture * (1 + 1e-12)
        assert np.all(contact.fluid_pressure[cavitated] == 0)
        assert np.all(contact.fluid_pressure > -1e-6 * PROBLEM.hertz.peak_pressure)
        assert contact.separation.min() > 0


def test_the_quadrature_covers_the_domain(default):
    for contact in default[2]:
        half_domain = PROBLEM.domain
        assert contact.weights.sum() == pytest.approx(2 * half_domain, rel=1e-12)
        assert contact.weights @ contact.positions**2 == pytest.approx(2 * half_domain**3 / 3, rel=1e-8)


def test_viscosity_and_speed_enter_as_a_product():
    speeds = np.array([1e-4, 1e-2, 1.0])
    thick = replace(PROBLEM, lubricant=Lubricant(viscosity=0.73))
    one, other = curve(8, speeds=speeds), curve(8, thick, speeds / 7.3)
    np.testing.assert_allclose(other[0], one[0], rtol=1e-12)
    np.testing.assert_allclose(other[1], one[1], rtol=1e-12)


@pytest.mark.parametrize(
    ("half_widths", "slow", "fast"), [(16, 0.0355, 0.1147), (32, 0.0365, 0.1225), (64, 0.0370, 0.1270)]
)
def test_the_domain_decides_friction(half_widths, slow, fast):
    problem = replace(PROBLEM, half_domain=half_widths * PROBLEM.hertz.half_width)
    found, _, contacts = curve(8, problem, [0.1, 1.0])
    assert all(c.converged for c in contacts)
    np.testing.assert_allclose(found, [slow, fast], atol=6e-5)


def test_the_domain_of_the_source():
    """±1 mm starves the film at 1 m/s: 18.6 µm at 4 a and 23.6 µm at 8 a, against 27.0 µm at 64 a."""
    for half_widths, film in ((3.2, None), (4, 18.6e-6), (8, 23.6e-6)):
        problem = replace(PROBLEM, half_domain=half_widths * PROBLEM.hertz.half_width)
        contacts = Spectral().sweep(problem, SPEEDS)
        swept = Spectral().refined().sweep(problem, SPEEDS)
        corrected = Spectral().refined().correct(problem, contacts)
        for coarse, fine, begun in zip(contacts, swept, corrected, strict=True):
            assert coarse.converged
            assert begun.converged
            # The march and the correction stretch their elements differently.
            for other in (fine, begun):
                assert total_friction(coarse, problem) == pytest.approx(
                    total_friction(other, problem), abs=1e-6
                )
        if film is not None:
            assert Spectral().sweep(problem, [1.0])[0].separation_min == pytest.approx(film, rel=2e-3)


def test_results_come_in_the_order_asked_for_and_do_not_depend_on_the_sweep(default):
    mixed = [1.0, SPEEDS[3], SPEEDS[30], SPEEDS[3]]
    contacts = Spectral().sweep(PROBLEM, mixed)
    assert [c.speed for c in contacts] == mixed
    assert contacts[1] is contacts[3]
    alone = Spectral().solve(PROBLEM.at(speed=float(SPEEDS[3])))
    assert alone.separation_min == pytest.approx(default[1][3], rel=1e-4)
    assert contacts[2].separation_min == pytest.approx(default[1][30], rel=1e-4)


def test_the_smallest_separation_lies_below_the_nodes_and_the_central_one_between(default):
    for contact in default[2]:
        assert contact.separation_min <= contact.separation.min()
        assert contact.separation_min > 0.9 * contact.separation.min()
        order = np.argsort(contact.positions)
        nearby = np.interp(0, contact.positions[order], contact.separation[order])
        assert contact.separation_central == pytest.approx(nearby, rel=0.1)


def test_an_unreachable_tolerance_is_flagged_not_raised():
    contacts = Spectral(tolerance=1e-30).sweep(PROBLEM, [1e-3, 1.0])
    assert len(contacts) == 2
    for contact in contacts:
        assert not contact.converged
        assert np.isnan(contact.separation_min)


def test_coarse_orders_admit_what_they_are():
    """Where a coarse polynomial makes the film pressure negative the point is flagged."""
    contacts = Spectral(4).sweep(PROBLEM, SPEEDS)
    floor = -1e-6 * PROBLEM.hertz.peak_pressure
    negative = np.array([bool(np.nanmin(c.fluid_pressure) < floor) for c in contacts])
    assert negative.any()
    assert not any(c.converged for c, bad in zip(contacts, negative, strict=True) if bad)


def test_the_refined_solver_estimates_the_error(reference):
    coarse, fine = curve(5), curve(7)
    estimate = np.abs(coarse[0] - fine[0])
    true = np.abs(coarse[0] - reference[0])
    np.testing.assert_allclose(estimate, true, rtol=0.3, atol=5e-6)
    assert Spectral(5).refined() == Spectral(7)


def test_a_correction_at_another_order_is_as_good_as_the_sweep_of_that_order(reference):
    """Both are off by the errors of order 8, which are far below the change that the correction makes."""
    coarse = curve(6)
    corrected = Spectral(8).correct(PROBLEM, coarse[2])
    assert all(contact.converged for contact in corrected)
    assert max(contact.iterations for contact in corrected) <= 6
    found = np.array([total_friction(contact) for contact in corrected])
    error = np.abs(found - reference[0])
    assert error.max() < 0.2 * np.abs(coarse[0] - reference[0]).max()
    np.testing.assert_allclose(found, curve(8)[0], atol=error.max())


def test_a_correction_at_its_own_order_changes_nothing_but_the_elements():
    contacts = Spectral(12).sweep(PROBLEM, SPEEDS[::4])
    for before, after in zip(contacts, Spectral(12).correct(PROBLEM, contacts), strict=True):
        assert after.converged
        assert after.speed == before.speed
        assert after.separation_min == pytest.approx(before.separation_min, rel=1e-6)
        assert total_friction(after) == pytest.approx(total_friction(before), abs=1e-8)


def test_a_start_that_leads_nowhere_is_swept_and_a_failed_one_left_alone(default):
    good = default[2][20]
    astray = replace(good, rigid_approach=-good.rigid_approach - 1e-4)
    failed = replace(good, converged=False)
    swept, kept = Spectral(10).correct(PROBLEM, [astray, failed])
    assert swept.converged
    assert swept.separation_min == pytest.approx(good.separation_min, rel=1e-4)
    assert kept is failed


def test_contacts_of_other_solvers_are_not_corrected(default):
    other = replace(default[2][0], solver="finite_volume", breaks=range(0))
    with pytest.raises(ValueError, match="not those of finite_volume"):
        Spectral().correct(PROBLEM, [default[2][1], other])


def test_what_it_cannot_solve_is_refused(default):
    conserving = replace(PROBLEM, lubricant=Lubricant(viscosity=0.1, cavitation="mass_conserving"))
    with pytest.raises(ValueError, match="mass_conserving"):
        Spectral().solve(conserving)
    with pytest.raises(ValueError, match="mass_conserving"):
        Spectral(10).correct(conserving, default[2])
    with pytest.raises(ValueError, match="positive"):
        Spectral().sweep(PROBLEM, [0.1, -1.0])
