"""Two independent discretisations agree: spectral elements against finite volumes extrapolated from two grids."""

import numpy as np
import pytest

from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.finite_volume.extrapolation import extrapolated_sweep
from softlub.lubrication.solvers.spectral import Spectral
from softlub.surfaces.spectrum import SelfAffine

NODES = 257
SPEEDS = 3


def log_uniform(generator, low, high, size=None):
    return np.exp(generator.uniform(np.log(low), np.log(high), size))


def random_problem(seed, rough=True):
    """A contact within the ranges of the study ch3-map, and speeds."""
    generator = np.random.default_rng(seed)
    modulus = log_uniform(generator, 1e6, 50e6) / 0.75
    rms = log_uniform(generator, 0.1e-6, 10e-6)
    surface = SelfAffine(rms, hurst=0.8, rolloff=1e4, cutoff=7.8e9)
    problem = Problem(
        body=HalfSpaceCylinder(log_uniform(generator, 1e-3, 50e-3), modulus),
        law=PerssonLaw(surface, modulus) if rough else NoContact(),
        lubricant=Lubricant(log_uniform(generator, 1e-3, 1.0)),
        load=log_uniform(generator, 10.0, 1000.0),
        speed=1.0,
        rms_roughness=rms if rough else 0.0,
    )
    return problem, np.sort(log_uniform(generator, 1e-5 if rough else 1e-2, 10.0, SPEEDS))


def total_friction(problem):
    """μ with a shear strength of a tenth of E."""
    strength = 0.1 * 0.75 * problem.body.modulus

    def of(contact):
        assert contact.converged
        parts = friction(contact, problem.law, problem.lubricant.viscosity)
        return parts.fluid + strength * parts.real_contact_width / problem.load

    return of


@pytest.mark.parametrize("seed", range(8))
def test_friction_of_random_contacts_agrees(seed):
    problem, speeds = random_problem(seed)
    of = total_friction(problem)
    spectral = np.array([of(contact) for contact in Spectral(order=10).sweep(problem, speeds)])
    volumes = extrapolated_sweep(FiniteVolume(nodes=NODES), problem, speeds, of)
    assert np.max(np.abs(volumes - spectral)) <= 1e-4


def separation_difference(problem, speeds, nodes):
    """Relative difference of u_min, and u_min over h_rms."""
    spectral = np.array([contact.separation_min for contact in Spectral(order=10).sweep(problem, speeds)])
    volumes = extrapolated_sweep(
        FiniteVolume(nodes=nodes), problem, speeds, lambda contact: contact.separation_min
    )
    return np.abs(volumes / spectral - 1), spectral / problem.rms_roughness


@pytest.mark.parametrize("seed", range(8))
def test_smallest_separations_of_random_contacts_agree(seed):
    """In boundary lubrication the film is thinnest at an edge of the contact that 257 nodes do not resolve."""
    difference, film = separation_difference(*random_problem(100 + seed), NODES)
    assert np.all(difference[film > 0.3] <= 5e-3)
    assert np.all(difference[film > 3.0] <= 2e-4)


@pytest.mark.parametrize("seed", [3, 6])
def test_smallest_separations_in_boundary_lubrication_agree_on_fine_grids(seed):
    difference, film = separation_difference(*random_problem(100 + seed), 1025)
    assert film.min() < 0.15
    assert np.all(difference <= 1e-2)


@pytest.mark.parametrize("seed", range(3))
def test_smooth_contacts_agree(seed):
    problem, speeds = random_problem(200 + seed, rough=False)
    of = total_friction(problem)
    spectral = np.array([of(contact) for contact in Spectral(order=10).sweep(problem, speeds)])
    volumes = extrapolated_sweep(FiniteVolume(nodes=NODES), problem, speeds, of)
    assert np.max(np.abs(volumes - spectral)) <= 1e-4


def test_extrapolation_is_closer_than_either_grid():
    problem, speeds = random_problem(0)
    of = total_friction(problem)
    exact = np.array([of(contact) for contact in Spectral(order=12).sweep(problem, speeds)])
    plain = np.array([of(contact) for contact in FiniteVolume(nodes=NODES).sweep(problem, speeds)])
    extrapolated = extrapolated_sweep(FiniteVolume(nodes=NODES), problem, speeds, of)
    assert np.max(np.abs(extrapolated - exact)) < 0.3 * np.max(np.abs(plain - exact))


def test_the_estimated_error_follows_the_true_one():
    """The default order against two orders more, and against many more."""
    problem, speeds = random_problem(3)
    of = total_friction(problem)
    solver = Spectral()
    contacts = solver.sweep(problem, speeds)
    corrected, truth = solver.refined().correct(problem, contacts), Spectral(order=16).sweep(problem, speeds)
    coarse, finer, exact = (
        np.array([of(contact) for contact in solved]) for solved in (contacts, corrected, truth)
    )
    true, estimated = np.abs(coarse - exact), np.abs(coarse - finer)
    assert np.all(true <= 3 * estimated + 1e-8)
    assert np.all(true <= 2e-5)
