"""What is read off a solved contact: friction, film, shares, widths, and the flags that speak against it."""

from __future__ import annotations

import numpy as np

from softlub.datasets.variables import FLAGS
from softlub.lubrication.friction import friction
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.result import FloatArray, LubricatedContact

WIDTH_LEVEL = 1e-3
"""The contact is as wide as the total pressure exceeds this part of its maximum."""
PERCOLATION_AREA = 0.4
"""Real contact above this part of the nominal area closes the last channel of the film."""
PARABOLA_LIMIT = 0.9
"""Pressurised half-width over radius above which a point lies outside the half-space: the parabola misses the circle
there by a quarter, and no body is left to be a half-space."""


def observe(contact: LubricatedContact, problem: Problem) -> dict[str, float]:
    """Scalars of one point, named as in the table of variables.

    Parameters
    ----------
    contact : LubricatedContact
    problem : Problem
        The problem that was solved.

    Returns
    -------
    dict of str to float
        Every quantity is NaN where the contact did not converge, except those that describe the solver's work.
    """
    parts = friction(contact, problem.law, problem.lubricant.viscosity)
    pressure = contact.fluid_pressure + contact.solid_pressure
    physical = {
        "friction_coefficient_fluid": parts.fluid,
        "friction_coefficient_couette": parts.couette,
        "friction_coefficient_poiseuille": parts.poiseuille,
        "separation_min": contact.separation_min,
        "separation_central": contact.separation_central,
        "load_share_solid": parts.load_share_solid,
        "real_contact_width": parts.real_contact_width,
        "contact_area_ratio_max": parts.contact_area_ratio_max,
        "contact_width": contact_width(contact.positions, pressure),
        "pressure_centroid": float(contact.weights @ (pressure * contact.positions)) / contact.load,
        "rupture_position": contact.rupture,
        "rigid_approach": contact.rigid_approach,
    }
    flags = _flags(contact, problem, physical)
    if not contact.converged:
        physical = dict.fromkeys(physical, np.nan)
    return {
        **physical,
        "converged": contact.converged,
        "iterations": contact.iterations,
        "residual": contact.residual,
        "load_error": contact.load_error,
        "flags": flags,
    }


def contact_width(positions: FloatArray, pressure: FloatArray) -> float:
    """Width over which the pressure exceeds a thousandth of its maximum, ends interpolated linearly [m].

    Parameters
    ----------
    positions : ndarray, shape (n,)
        Ascending [m].
    pressure : ndarray, shape (n,)
        Total pressure [Pa].

    Returns
    -------
    float
    """
    level = WIDTH_LEVEL * np.max(pressure)
    inside = np.flatnonzero(pressure > level)
    if inside.size == 0:
        return float("nan")
    first, last = inside[0], inside[-1]
    return _crossing(positions, pressure, last, last + 1, level) - _crossing(
        positions, pressure, first, first - 1, level
    )


def _crossing(positions: FloatArray, pressure: FloatArray, inner: int, outer: int, level: float) -> float:
    if not 0 <= outer < positions.size:
        return float(positions[inner])
    part = (pressure[inner] - level) / (pressure[inner] - pressure[outer])
    return float(positions[inner] + part * (positions[outer] - positions[inner]))


def _flags(contact: LubricatedContact, problem: Problem, values: dict[str, float]) -> int:
    if not contact.converged:
        return FLAGS["not_converged"]
    half_width = 0.5 * values["contact_width"]
    raised = {
        "outside_half_space": isinstance(problem.body, HalfSpaceCylinder)
        and half_width > PARABOLA_LIMIT * problem.body.radius,
        "percolates": values["contact_area_ratio_max"] > PERCOLATION_AREA,
        "law_extrapolated": contact.separation_min < problem.law.separation_range[0],
        "domain_truncates": _pressure_reaches_edge(contact),
    }
    return sum(FLAGS[name] for name, is_raised in raised.items() if is_raised)


def _pressure_reaches_edge(contact: LubricatedContact) -> bool:
    """Whether the fluid still carries a noticeable pressure in the outer tenth of the inlet."""
    edge = contact.positions < 0.9 * contact.positions[0]
    return bool(
        np.any(contact.fluid_pressure[edge] > WIDTH_LEVEL * np.max(contact.fluid_pressure, initial=0.0))
    )
