"""The contact that the benchmarks are run on: the source's table 3-1, its law and its speeds."""

from collections.abc import Sequence

import numpy as np

from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.result import LubricatedContact
from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.surfaces.spectrum import SelfAffine

MATERIAL = LinearElastic(young_modulus=10e6, poisson_ratio=0.4999)
SURFACE = SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9)
SHEAR_STRENGTH = 0.1 * MATERIAL.young_modulus
SPEEDS = np.geomspace(1e-5, 100, 40)
SOURCE_HALF_DOMAIN = 1e-3
"""The source's own domain, ±1 mm [m]."""


def table_3_1(half_domain: float | None = None) -> Problem:
    """A fresh problem, its law not yet tabulated."""
    modulus = MATERIAL.plane_strain_modulus
    return Problem(
        body=HalfSpaceCylinder(radius=0.01, modulus=modulus),
        law=PerssonLaw(SURFACE, modulus),
        lubricant=Lubricant(viscosity=0.1),
        load=100.0,
        speed=1.0,
        rms_roughness=SURFACE.rms_roughness,
        half_domain=half_domain,
    )


def total_friction(contact: LubricatedContact, problem: Problem, strength: float = SHEAR_STRENGTH) -> float:
    """μ, fluid and solid part together; NaN for a point that did not converge."""
    return friction_of(contact, problem, strength) if contact.converged else float("nan")


def friction_of(contact: LubricatedContact, problem: Problem, strength: float = SHEAR_STRENGTH) -> float:
    """μ of whatever the solver returned, converged or not."""
    parts = friction(contact, problem.law, problem.lubricant.viscosity)
    return parts.fluid + strength * parts.real_contact_width / problem.load


def smallest_separation(contact: LubricatedContact) -> float:
    """u_min [m]; NaN for a point that did not converge."""
    return contact.separation_min if contact.converged else float("nan")


def friction_curve(contacts: Sequence[LubricatedContact], problem: Problem) -> np.ndarray:
    """μ of every contact, shape (speeds,)."""
    return np.array([total_friction(contact, problem) for contact in contacts])


def separation_curve(contacts: Sequence[LubricatedContact]) -> np.ndarray:
    """u_min of every contact, shape (speeds,) [m]."""
    return np.array([smallest_separation(contact) for contact in contacts])
