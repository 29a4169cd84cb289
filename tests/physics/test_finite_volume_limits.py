"""The finite volumes in the limits that are known otherwise, and where they are driven too far."""

from dataclasses import replace

import numpy as np
import pytest

from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.references.martin import MartinRoller
from softlub.references.soft_similarity import central_film, smallest_film
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1e7 / (1 - 0.4999**2)
SMOOTH = Problem(
    body=HalfSpaceCylinder(radius=0.01, modulus=MODULUS),
    law=NoContact(),
    lubricant=Lubricant(viscosity=0.1),
    load=100.0,
    speed=0.1,
)


def speed_for(speed_number: float) -> float:
    return speed_number / SMOOTH.at(speed=1.0).speed_number


def test_smooth_contact_becomes_hertzian() -> None:
    contact = FiniteVolume(513).solve(SMOOTH.at(speed=speed_for(1e-5)))
    scaled = contact.positions / SMOOTH.hertz.half_width
    hertz = np.sqrt(np.clip(1 - scaled**2, 0, None))
    inside = np.abs(scaled) < 0.9
    assert contact.converged
    assert contact.fluid_pressure[inside] / SMOOTH.hertz.peak_pressure == pytest.approx(
        hertz[inside], abs=5e-3
    )


def test_smooth_film_follows_the_similarity_solution() -> None:
    numbers = [1e-3, 1e-4, 1e-5]
    contacts = FiniteVolume(1025).sweep(SMOOTH, [speed_for(number) for number in numbers])
    a = SMOOTH.hertz.half_width
    for number, contact, bound in zip(numbers, contacts, [3e-2, 1e-2, 5e-3], strict=True):
        assert contact.separation_central == pytest.approx(central_film(0.01, a, number), rel=bound)
        assert contact.separation_min == pytest.approx(smallest_film(0.01, a, number), rel=bound)


def test_fast_contact_becomes_martins_roller() -> None:
    problem = replace(SMOOTH, half_domain=1000 * SMOOTH.hertz.half_width).at(speed=speed_for(5000))
    contact = FiniteVolume(513).solve(problem)
    rigid = MartinRoller(radius=0.01, viscosity=0.1, speed=problem.speed, load=100.0)
    assert contact.separation_min == pytest.approx(rigid.smallest_separation, rel=1e-2)
    assert contact.rupture == pytest.approx(rigid.rupture_position, rel=1e-2)


@pytest.mark.parametrize("grid", ["graded", "even"])
def test_single_cold_speeds_agree_with_a_sweep(grid: str) -> None:
    law = PerssonLaw(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9), MODULUS)
    rough = replace(SMOOTH, law=law, rms_roughness=1e-6, half_domain=1e-3)
    speeds = [1e-6, 1e-3, 0.1, 10.0]
    swept = FiniteVolume(257, grid=grid).sweep(rough, speeds)
    for speed, contact in zip(speeds, swept, strict=True):
        alone = FiniteVolume(257, grid=grid).solve(rough.at(speed=speed))
        assert alone.converged
        assert contact.converged
        # The grid follows the slowest speed, so that the two differ by the grid's error.
        assert alone.separation_min == pytest.approx(contact.separation_min, rel=1e-3)


@pytest.mark.parametrize(
    ("rms", "modulus", "load", "viscosity"),
    [
        (10e-6, 5e5, 1.0, 1e-3),  # asperities larger than the dry contact
        (0.05e-6, 5e5, 1e2, 1e-3),  # asperities lost in it
        (5e-6, 5e7, 1.0, 1.0),
        (0.05e-6, 5e7, 1e4, 1.0),
    ],
)
def test_extreme_scenes_converge(rms: float, modulus: float, load: float, viscosity: float) -> None:
    law = PerssonLaw(SelfAffine(rms_roughness=rms, hurst=0.8, rolloff=1e4, cutoff=7.8e9), modulus)
    problem = Problem(
        HalfSpaceCylinder(0.01, modulus), law, Lubricant(viscosity), load, 1.0, rms_roughness=rms
    )
    contacts = FiniteVolume(129).sweep(problem, np.geomspace(1e-7, 10, 9))
    assert all(contact.converged for contact in contacts)
    films = [contact.separation_min for contact in contacts]
    assert np.all(np.diff(films) > 0)
    assert films[0] > 0


def test_a_point_that_fails_is_flagged() -> None:
    contact = FiniteVolume(129, most_steps=1).solve(SMOOTH)
    assert not contact.converged
    assert contact.residual > 1e-10
    assert contact.iterations <= 1
