"""Where an iteration begins: the dry contact, a smooth full film, or another solution."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.scaled import LOAD
from softlub.lubrication.solvers.modules.contact import EvenContact, Fields
from softlub.lubrication.solvers.modules.inverse_law import gap_at_pressure
from softlub.lubrication.solvers.modules.iteration import SMALLEST_GAP
from softlub.protocols import FloatArray

SOFT_FILM = 0.446
"""Central film of the soft similarity solution, H = 0.446 λ^0.6."""
HERTZIAN_SPEED_NUMBER = 1.0
"""λ up to which the pressure of a full film resembles Hertz's."""
NEGLIGIBLE_FILM = 0.02
"""Soft film over roughness below which a dry contact is a good start."""
MIXED_FILM = 0.3
"""Soft film over roughness up to which the boundary-mixed module prepares the mixed one (source: up to 1.5e-3 m/s)."""


def hertz_pressure(contact: EvenContact) -> FloatArray:
    """√(1 - X²) on the nodes, with exactly the load, shape (n,)."""
    pressure = np.sqrt(np.maximum(0.0, 1 - contact.nodes**2))
    return pressure * (LOAD / contact.force(pressure))


def dry_start(contact: EvenContact) -> Fields:
    """Hertz pressure carried by the asperities, no fluid pressure; the gap from the law at the centre."""
    pressure = hertz_pressure(contact)
    opening = gap_at_pressure(contact.scaled.table, pressure[contact.centre])
    return _fields_around(contact, np.zeros_like(pressure), pressure, contact.centre, opening)


def film_start(contact: EvenContact) -> Fields:
    """Hertz pressure carried by the fluid, over the film of the soft similarity solution."""
    pressure = hertz_pressure(contact)
    lowest = int(np.argmin(contact.scaled.gap(pressure, 0.0)))
    opening = SOFT_FILM * contact.speed_number**0.6
    return _fields_around(contact, pressure, np.zeros_like(pressure), lowest, opening)


def _fields_around(
    contact: EvenContact, fluid: FloatArray, solid: FloatArray, node: int, opening: float
) -> Fields:
    """Fields whose gap has a given value at one node; nowhere less than half of it."""
    gap = contact.scaled.gap(fluid + solid, 0.0)
    approach = opening - float(gap[node])
    return Fields(fluid, solid, np.maximum(gap + approach, max(0.5 * opening, SMALLEST_GAP)), approach)


def from_solution(contact: EvenContact, solution: LubricatedContact) -> Fields:
    """Fields of a solution of whatever solver, grid, load and speed, interpolated onto the nodes.

    The approach is that of the elasticity at the centre, so that it does not depend on the solution's own units.
    """
    hertz = contact.problem.hertz
    places = contact.nodes * hertz.half_width

    def interpolated(values: FloatArray, outside: float | None) -> FloatArray:
        return np.interp(places, solution.positions, values, left=outside, right=outside)

    fluid = interpolated(solution.fluid_pressure, 0.0) / hertz.peak_pressure
    solid = interpolated(solution.solid_pressure, 0.0) / hertz.peak_pressure
    gap = interpolated(solution.separation, None) / hertz.gap_scale
    gap = np.maximum(gap, SMALLEST_GAP)
    undeflected = contact.scaled.gap(fluid + solid, 0.0)
    return Fields(fluid, solid, gap, float((gap - undeflected)[contact.centre]))


def dry_speed_number(contact: EvenContact) -> float:
    """λ below which the soft film is negligible against the roughness."""
    return _speed_number_of_film(contact, NEGLIGIBLE_FILM)


def mixed_speed_number(contact: EvenContact) -> float:
    """λ up to which the asperities carry a good part of the load."""
    return _speed_number_of_film(contact, MIXED_FILM)


def _speed_number_of_film(contact: EvenContact, part: float) -> float:
    """λ at which the soft film is as thick as a part of the roughness."""
    return (part * contact.scaled.roughness / SOFT_FILM) ** (5 / 3)


class Begin(NamedTuple):
    """A speed at which a module can begin, and the fields to begin with."""

    speed_number: float
    fields: Fields
    is_settled: bool = False
    """Whether the fields are (nearly) a solution at that speed."""


def slow_start(contact: EvenContact) -> Begin:
    """The dry contact at the contact's own λ, or at the highest λ at which it still is a good start."""
    return Begin(min(contact.speed_number, dry_speed_number(contact)), dry_start(contact))


def fast_start(contact: EvenContact) -> Begin:
    """A full film at the contact's own λ, or at the highest λ at which Hertz's pressure still is a good start."""
    speed_number = min(contact.speed_number, HERTZIAN_SPEED_NUMBER)
    slower = contact.at(contact.problem.speed * speed_number / contact.speed_number)
    return Begin(speed_number, film_start(slower))
