"""A first solution: the rigid roller at a speed so high that the elastic body hardly matters (Martin's limit)."""

from __future__ import annotations

import numpy as np

from softlub.lubrication.solvers.finite_volume.equations import State
from softlub.lubrication.solvers.finite_volume.reynolds import film_pressure
from softlub.lubrication.solvers.finite_volume.scaled import LOAD, ScaledContact

MARTIN = 2.447 / (3 * np.pi)
"""Martin's film coefficient: u_c = 2.447 ηvR/W is H = 0.2596 λ."""


def starting_speed_number(contact: ScaledContact) -> float:
    """λ at which the film carries the load alone and is thicker than a²/R."""
    return max(60.0, 30 * contact.roughness)


def rigid_start(contact: ScaledContact, speed_number: float) -> State:
    """Martin's pressure at this speed, with the central film adapted to the load on these nodes."""
    space = contact.space
    film = MARTIN * speed_number
    ends = np.zeros(space.positions.size)
    everywhere = ends == 0
    for _ in range(4):
        gap = film + space.base_gap
        fluid = film_pressure(space.positions, gap, speed_number, False, ends, everywhere)[0]
        film *= float(space.widths @ fluid) / LOAD
    total = fluid + contact.solid(gap)[0]
    front = float(np.flatnonzero(fluid)[-1])
    return State(total, film - float(space.deflection(total)[contact.apex]), front)
