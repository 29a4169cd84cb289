"""Mass-conserving cavitation: exact bearings whose film forms again, and what it does to a soft contact."""

from dataclasses import replace

import numpy as np
import pytest

from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.finite_volume.fluxes import face_fluxes
from softlub.lubrication.solvers.finite_volume.reynolds import film_pressure, pressure
from softlub.references.pocket import Pocket
from softlub.references.wavy_slider import WavySlider
from softlub.surfaces.spectrum import SelfAffine

POCKET = Pocket(
    land_film=1e-6,
    pocket_film=2e-6,
    first_land=3e-4,
    pocket_length=4e-4,
    second_land=3e-4,
    ambient_pressure=1e5,
    viscosity=0.01,
    speed=1.0,
)
SLIDER = WavySlider(
    mean_separation=2e-6,
    relative_amplitude=0.5,
    wavelength=1e-3,
    phase=np.pi / 2,
    length=1.2e-3,
    viscosity=0.05,
    speed=1.0,
)


def pocket_nodes(nodes: int) -> np.ndarray:
    """Even nodes, doubled at the two steps, so that the gap is that of the pocket exactly."""
    ends = POCKET.first_land, POCKET.first_land + POCKET.pocket_length
    edges = [edge * (1 + side * 1e-12) for edge in ends for side in (-1, 1)]
    return np.unique(np.concatenate([np.linspace(0, ends[1] + POCKET.second_land, nodes), edges]))


def test_the_pocket_of_the_closed_form() -> None:
    x = pocket_nodes(1000)
    film = pressure(x, POCKET.separation(x), 0.01, 1.0, "mass_conserving", POCKET.ambient_pressure)
    assert film.converged
    assert film.pressure == pytest.approx(POCKET.pressure(x), abs=2e-3 * POCKET.exit_pressure)
    empty = (x > POCKET.rupture_position * 1.001) & (x < 0.98 * POCKET.reformation_position)
    assert film.void_fraction[empty] == pytest.approx(1 - POCKET.filling, rel=1e-8)
    assert np.all(film.void_fraction[x > 1.01 * POCKET.reformation_position] == 0)


def test_reynolds_condition_invents_lubricant_in_the_pocket() -> None:
    x = pocket_nodes(1000)
    film = pressure(x, POCKET.separation(x), 0.01, 1.0, "reynolds", POCKET.ambient_pressure)
    assert film.pressure.max() > 1.05 * POCKET.exit_pressure


def test_the_wavy_slider_converges() -> None:
    errors, fills = [], []
    for nodes in (201, 401, 801, 1601):
        x = np.linspace(0, SLIDER.length, nodes)
        film = pressure(x, SLIDER.separation(x), 0.05, 1.0, "mass_conserving")
        assert film.converged
        exact = SLIDER.pressure(x)
        errors.append(np.max(np.abs(film.pressure - exact)) / exact.max())
        inside = (x > SLIDER.rupture_position + 1e-5) & (x < SLIDER.reformation_position - 1e-5)
        fills.append(np.max(np.abs(1 - film.void_fraction - SLIDER.filling(x))[inside]))
    assert errors[-1] < 5e-3
    assert fills[-1] < 1e-3
    assert np.log2(errors[0] / errors[-1]) > 2.5  # order one at the edge where the film forms again
    assert np.log2(fills[0] / fills[-1]) > 4


def test_one_flow_passes_through_film_and_void() -> None:
    x = np.linspace(0, 1, 301)
    gap = SLIDER.separation(x * SLIDER.length) / SLIDER.mean_separation
    everywhere = np.ones(x.size, dtype=bool)
    start = film_pressure(x, gap, 1.0, False, 0 * x, everywhere)[0] > 0
    fluid, arriving, _, settled = film_pressure(x, gap, 1.0, True, 0 * x, start)
    flux = face_fluxes(x, gap, fluid, 1.0)[0]
    assert settled
    assert arriving[1:-1] == pytest.approx(flux[0], rel=1e-10)


MODULUS = 1e7 / (1 - 0.4999**2)
CONTACT = Problem(
    body=HalfSpaceCylinder(radius=0.01, modulus=MODULUS),
    law=PerssonLaw(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9), MODULUS),
    lubricant=Lubricant(viscosity=0.1),
    load=100.0,
    speed=0.1,
    rms_roughness=1e-6,
)


def test_conserving_mass_leaves_a_flooded_cylinder_as_it_is() -> None:
    """One film that ruptures once and never forms again: both conditions end it with p = dp/dx = 0."""
    conserving = replace(CONTACT, lubricant=Lubricant(0.1, "mass_conserving"))
    speeds = np.geomspace(1e-5, 10, 7)
    pairs = zip(
        FiniteVolume(129).sweep(CONTACT, speeds), FiniteVolume(129).sweep(conserving, speeds), strict=True
    )
    for reynolds, conserved in pairs:
        assert reynolds.converged
        assert conserved.converged
        assert conserved.separation == pytest.approx(reynolds.separation, rel=1e-7)
        fluid = [friction(contact, CONTACT.law, 0.1).fluid for contact in (reynolds, conserved)]
        assert fluid[1] == pytest.approx(fluid[0], rel=1e-7)
