"""The spectral solver against what is known in closed form: thick, soft, slow and dry films; and extreme scenes."""

from dataclasses import replace

import numpy as np
import pytest

from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.auto import Auto
from softlub.lubrication.solvers.spectral import Spectral
from softlub.lubrication.solvers.spectral.basis import lobatto_basis
from softlub.lubrication.solvers.spectral.resolution import largest_tail, tail
from softlub.references.dry_limit import real_contact_width
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1e7 / (1 - 0.4999**2)
SMOOTH = Problem(HalfSpaceCylinder(0.01, MODULUS), NoContact(), Lubricant(0.1), 100.0, 1.0)
SPECTRUM = SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9)
ROUGH = replace(SMOOTH, law=PerssonLaw(SPECTRUM, MODULUS), rms_roughness=1e-6)


def at_speed_numbers(problem, speed_numbers, order=8):
    unit = problem.at(speed=1.0).speed_number
    contacts = Spectral(order).sweep(problem, np.asarray(speed_numbers) / unit)
    assert all(c.converged for c in contacts)
    return contacts


def test_martins_rigid_roller():
    """u_min = 2.447 ηvR/W where the film is thick against the deflection, and the inlet wide against the film."""
    wide = replace(SMOOTH, half_domain=1e5 * SMOOTH.hertz.half_width)
    contact = at_speed_numbers(wide, [1e6])[0]
    coefficient = (
        contact.separation_min * wide.load / (wide.lubricant.viscosity * contact.speed * wide.body.radius)
    )
    assert coefficient == pytest.approx(2.447, abs=1e-3)


def test_soft_similarity_film():
    """u(0) -> 0.446 λ^(3/5) a²/R and u_min -> 0.355 λ^(3/5) a²/R, from above."""
    numbers = np.array([1e-3, 1e-5, 1e-7])
    contacts = at_speed_numbers(SMOOTH, numbers)
    scale = SMOOTH.hertz.gap_scale * numbers**0.6
    central = np.array([c.separation_central for c in contacts]) / scale
    smallest = np.array([c.separation_min for c in contacts]) / scale
    assert np.all(np.diff(np.abs(central - 0.4458)) < 0)
    assert central[-1] == pytest.approx(0.446, abs=5e-4)
    assert 0.354 < smallest[-1] < 0.3555


def test_slow_smooth_contact_is_hertzian():
    errors = []
    for contact in at_speed_numbers(SMOOTH, [1e-3, 1e-5, 1e-7]):
        hertz = SMOOTH.hertz
        dry = hertz.peak_pressure * np.sqrt(np.maximum(0, 1 - (contact.positions / hertz.half_width) ** 2))
        errors.append(np.max(np.abs(contact.fluid_pressure - dry)) / hertz.peak_pressure)
    # The pressure leaves Hertz's within an edge layer of width λ^(2/5), where it is of order λ^(1/5).
    np.testing.assert_allclose(np.diff(np.log(errors)) / np.log(1e-2), 0.2, atol=0.03)


def test_dry_limit():
    """The slower, the nearer to the erf area on a dry rough contact, itself near that on Hertz's pressure."""
    contacts = at_speed_numbers(ROUGH, [1e-7, 1e-6])
    widths = [friction(c, ROUGH.law, 0.1).real_contact_width for c in contacts]
    shares = [friction(c, ROUGH.law, 0.1).load_share_solid for c in contacts]
    hertz = ROUGH.hertz
    dry = real_contact_width(hertz.half_width, hertz.peak_pressure, MODULUS, SPECTRUM.rms_slope)
    assert shares[0] > 0.995
    assert abs(widths[0] - dry) < abs(widths[1] - dry)
    assert widths[0] == pytest.approx(dry, rel=5e-3)


def random_scene(rng):
    def between(low, high):
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    modulus = between(0.5e6, 50e6) / 0.75
    height = between(0.02e-6, 10e-6)
    spectrum = SelfAffine(height, 0.8, 1e4, 7.8e9)
    law, height = (NoContact(), 0.0) if rng.uniform() < 0.2 else (PerssonLaw(spectrum, modulus), height)
    return Problem(
        HalfSpaceCylinder(0.01, modulus), law, Lubricant(between(1e-3, 1)), between(0.01, 1e4), 1.0, height
    )


@pytest.mark.parametrize("seed", range(12))
def test_random_scenes_are_solved_or_flagged_and_estimate_their_error(seed):
    rng = np.random.default_rng(seed)
    problem = random_scene(rng)
    speeds = np.geomspace(1e-5, 10, 9)
    contacts = Spectral().sweep(problem, speeds)
    finer = Spectral().refined().correct(problem, contacts)
    finest = Spectral(16).sweep(problem, speeds)
    assert sum(c.converged for c in contacts) >= len(speeds) - 1
    for contact, fine, truth in zip(contacts, finer, finest, strict=True):
        if not (contact.converged and fine.converged and truth.converged):
            continue
        estimate = abs(contact.separation_min - fine.separation_min)
        error = abs(contact.separation_min - truth.separation_min)
        assert error <= 3 * estimate + 2e-4 * truth.separation_min
        assert error <= 1e-2 * truth.separation_min


def deep(height, modulus, load, viscosity):
    """A film of half a nanometre, whose discrete equations have solutions that are no films."""
    modulus /= 1 - 0.4999**2
    law = PerssonLaw(SelfAffine(height, 0.8, 1e4, 7.8e9), modulus)
    return Problem(HalfSpaceCylinder(0.01, modulus), law, Lubricant(viscosity), load, 1.0, height)


LIFTING = [
    (deep(2.9761119628e-7, 5680071.84271, 9930.8940582, 0.00216680326), [6.355813316590349e-07]),
    (
        deep(2.9761119628e-7, 5680071.84271, 9930.8940582, 0.00216680326),
        [1.648, 2.719260e-7, 8.929e-2, 6.355813316590349e-07],
    ),
    (
        deep(2.4139173586551417e-08, 1299716.2138251723, 5906.9536168037885, 0.0027070408637781414),
        [2.327272278634836e-07, 3.6225046867941625e-07, 3.103156925309404e-06],
    ),
    (
        deep(3.816854700183876e-07, 1440377.1547234217, 6364.727591869952, 0.0014940699641816187),
        [5.463261484627943e-07, 2.6686654263569585e-07, 1.0193650348874243e-05],
    ),
]
"""Contacts and speeds at which a march of order 8 or 10 once took such a solution for the film."""


def real_width(contact, problem):
    return friction(contact, problem.law, problem.lubricant.viscosity).real_contact_width


@pytest.mark.parametrize("solver", [Spectral(6), Spectral(8), Spectral(10), Auto()], ids=str)
@pytest.mark.parametrize(("problem", "speeds"), LIFTING, ids=["alone", "swept", "smooth", "soft"])
def test_no_node_lifts_off_in_deep_boundary_lubrication(problem, speeds, solver):
    contacts, truth = solver.sweep(problem, speeds), Spectral(16).sweep(problem, speeds)
    assert all(contact.converged for contact in contacts) or isinstance(solver, Spectral)
    for contact, true in zip(contacts, truth, strict=True):
        assert true.converged
        if contact.converged:
            assert real_width(contact, problem) == pytest.approx(real_width(true, problem), rel=1e-3)


@pytest.mark.parametrize("order", [4, 6, 8, 10])
def test_films_keep_far_below_the_tail_that_tells_lifted_nodes(order):
    rng, basis, found = np.random.default_rng(20), lobatto_basis(order), []
    for _ in range(40):
        for contact in Spectral(order).sweep(random_scene(rng), np.geomspace(1e-5, 10, 9)):
            if contact.converged:
                found.append(tail(contact.separation[: contact.breaks[-1] + 1], basis))
    assert len(found) > 150
    assert max(found) < 0.5 * largest_tail(order)


@pytest.mark.parametrize("speed", [1e-5, 1e-2, 10.0])
def test_a_single_cold_speed_is_solved(speed):
    contact = Spectral().solve(ROUGH.at(speed=speed))
    assert contact.converged
    assert contact.residual < 1e-9
