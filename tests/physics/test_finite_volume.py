"""The finite volumes on the system of Table 3-1: reference values, order, identity, invariance, balance."""

from dataclasses import replace

import numpy as np
import pytest

from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1e7 / (1 - 0.4999**2)
SHEAR_STRENGTH = 1e6
LAW = PerssonLaw(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9), MODULUS)
PROBLEM = Problem(
    body=HalfSpaceCylinder(radius=0.01, modulus=MODULUS),
    law=LAW,
    lubricant=Lubricant(viscosity=0.1),
    load=100.0,
    speed=0.1,
    rms_roughness=1e-6,
)
# Two independent solvers, extrapolated in the grid: speed, friction, smallest separation, asperity share.
REFERENCE = np.array(
    [
        [1e-5, 0.36154, 0.05626e-6, 0.9096],
        [1e-3, 0.15672, 0.3003e-6, 0.3882],
        [0.0425, 0.02908, 2.3766e-6, 0.0181],
        [0.1, 0.03698, 4.2072e-6, 0.00256],
    ]
)
GRIDS = (129, 257, 513, 1025)


def observed(contact: LubricatedContact) -> list[float]:
    parts = friction(contact, LAW, PROBLEM.lubricant.viscosity)
    solid = SHEAR_STRENGTH * parts.real_contact_width / contact.load
    return [parts.fluid + solid, contact.separation_min, parts.load_share_solid]


@pytest.fixture(scope="module")
def by_grid() -> dict[int, list[LubricatedContact]]:
    levels = FiniteVolume(GRIDS[-1]).sweep_levels(PROBLEM, list(REFERENCE[:, 0]))
    return dict(zip(GRIDS, levels, strict=True))


def test_reference_values(by_grid: dict[int, list[LubricatedContact]]) -> None:
    found = np.array([observed(contact) for contact in by_grid[1025]])
    rounding = np.array([5e-6, 5e-12, 5e-6])  # of the printed figures; the second of u_min in m
    assert np.all(np.abs(found - REFERENCE[:, 1:]) <= 5e-4 * REFERENCE[:, 1:] + 2 * rounding)


def least_squares_order(errors: np.ndarray) -> float:
    return float(-np.polyfit(np.log2(np.array(GRIDS[: errors.size]) - 1), np.log2(errors), 1)[0])


def test_order_of_convergence(by_grid: dict[int, list[LubricatedContact]]) -> None:
    finer = FiniteVolume(2049).sweep(PROBLEM, [0.0425, 0.1])
    for k, speed in enumerate([0.0425, 0.1]):
        place = list(REFERENCE[:, 0]).index(speed)
        values = np.array([observed(by_grid[n][place]) for n in GRIDS] + [observed(finer[k])])
        limit = (4 * values[-1] - values[-2]) / 3
        errors = np.abs(values[:-1] - limit)
        assert least_squares_order(errors[:, 0]) > 1.9
        assert least_squares_order(errors[:, 1]) > 1.5


def test_poiseuille_friction_is_the_moment_of_the_pressure(
    by_grid: dict[int, list[LubricatedContact]],
) -> None:
    for place in range(len(REFERENCE)):
        errors = []
        for n in GRIDS:
            contact = by_grid[n][place]
            total = contact.fluid_pressure + contact.solid_pressure
            centroid = contact.weights @ (contact.positions * total) / contact.load
            moment = -centroid / (2 * PROBLEM.body.radius)
            errors.append(abs(friction(contact, LAW, 0.1).poiseuille / moment - 1))
        assert errors[1] < 3e-3
        assert least_squares_order(np.array(errors)) == pytest.approx(2, abs=0.05)


def test_balance_and_complementarity(by_grid: dict[int, list[LubricatedContact]]) -> None:
    for contacts in by_grid.values():
        for contact in contacts:
            assert contact.converged
            assert contact.load_error <= 1e-12
            assert contact.residual <= 1e-10
            peak = PROBLEM.hertz.peak_pressure
            assert contact.fluid_pressure.min() >= -1e-10 * peak
            total = contact.weights @ (contact.fluid_pressure + contact.solid_pressure)
            assert total == pytest.approx(contact.load, rel=1e-12)


@pytest.mark.parametrize("factor", [0.01, 8.0])
def test_only_the_product_of_viscosity_and_speed_matters(factor: float) -> None:
    one = FiniteVolume(129).sweep(PROBLEM, [1e-4, 0.03])
    thicker = replace(PROBLEM, lubricant=Lubricant(0.1 * factor))
    other = FiniteVolume(129).sweep(thicker, [1e-4 / factor, 0.03 / factor])
    for a, b in zip(one, other, strict=True):
        assert b.separation == pytest.approx(a.separation, rel=1e-12)
        assert b.separation_min == pytest.approx(a.separation_min, rel=1e-12)
        fluid = [friction(c, LAW, eta).fluid for c, eta in ((a, 0.1), (b, 0.1 * factor))]
        assert fluid[1] == pytest.approx(fluid[0], rel=1e-12)


def test_results_come_in_the_order_asked_for() -> None:
    speeds = [0.1, 1e-3, 10.0, 1e-3]
    contacts = FiniteVolume(129).sweep(PROBLEM, speeds)
    assert [c.speed for c in contacts] == speeds
    assert contacts[1].separation_min == contacts[3].separation_min
    assert contacts[2].separation_min > contacts[0].separation_min > contacts[1].separation_min


def test_a_start_of_another_grid_saves_the_march() -> None:
    near = FiniteVolume(257).solve(PROBLEM.at(speed=0.09))
    started = FiniteVolume(129).solve(PROBLEM, near)
    cold = FiniteVolume(129).solve(PROBLEM)
    assert started.converged
    assert started.separation == pytest.approx(cold.separation, rel=1e-8)
    assert started.iterations <= 8


def test_contacts_are_corrected_at_their_own_speeds_on_this_grid() -> None:
    speeds = [0.1, 1e-3, 10.0]
    coarse = FiniteVolume(129).sweep(PROBLEM, speeds)
    failed = replace(coarse[1], converged=False)
    astray = replace(coarse[2], fluid_pressure=1e6 * coarse[0].fluid_pressure, separation_central=-1.0)
    first, second, third = FiniteVolume(257).correct(PROBLEM, [coarse[0], failed, astray])
    swept = FiniteVolume(257).sweep(PROBLEM, speeds)
    alone = FiniteVolume(257).solve(PROBLEM.at(speed=10.0))
    assert second is failed
    for found, expected in ((first, swept[0]), (third, alone)):
        assert found.converged
        assert found.speed == expected.speed
        assert found.separation == pytest.approx(expected.separation, rel=1e-8)


def test_impossible_speeds_are_refused() -> None:
    with pytest.raises(ValueError, match="positive"):
        FiniteVolume(129).sweep(PROBLEM, [0.1, -1.0])
