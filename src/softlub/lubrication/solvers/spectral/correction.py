"""A solution taken to another polynomial order, on elements made for it alone: what its error is estimated by.

A march's elements were made for a speed on the way and serve several; that error is seen only where others take their
place. Begun at the solution, Newton's method needs some two factors, where a march from a thick film needs many.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from softlub.lubrication.hertz import HertzLine
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray, lobatto_basis
from softlub.lubrication.solvers.spectral.equations import Scene, make_fields
from softlub.lubrication.solvers.spectral.grid import transfer
from softlub.lubrication.solvers.spectral.march import ACCEPTED, MAX_ELEMENTS, allowed_residual
from softlub.lubrication.solvers.spectral.newton import make_workspace, newton
from softlub.lubrication.solvers.spectral.outcome import RESIDUAL, STEPS, Outcome, record
from softlub.lubrication.solvers.spectral.remesh import make_mesh, rupture_layer
from softlub.lubrication.solvers.spectral.resolution import is_film


class Known(NamedTuple):
    """A solution on elements of its own, in Hertz units.

    Attributes
    ----------
    state : ndarray, shape (n + 2,)
        Total pressures at the nodes of the elements, rigid approach, rupture point.
    breaks : ndarray
        Ends of the elements.
    basis : Basis
        Of their order.
    log_speed : float
        ln λ.
    film_min, rupture_gap : float
        Smallest separation, and that at the rupture point.
    """

    state: FloatArray
    breaks: FloatArray
    basis: Basis
    log_speed: float
    film_min: float
    rupture_gap: float


def known(contact: LubricatedContact, hertz: HertzLine, half_domain: float, log_speed: float) -> Known:
    """A contact of this package's solver; L in Hertz units."""
    nodes = contact.breaks[-1] + 1
    total = (contact.fluid_pressure + contact.solid_pressure)[:nodes] / hertz.peak_pressure
    breaks = contact.positions[list(contact.breaks)] / hertz.half_width
    # Back from SI units, which rounds.
    breaks[0] = -half_domain
    rupture = np.argmin(np.abs(contact.positions[:nodes] - contact.rupture))
    return Known(
        np.append(total, [contact.rigid_approach / hertz.gap_scale, contact.rupture / hertz.half_width]),
        breaks,
        lobatto_basis(contact.breaks.step),
        log_speed,
        contact.separation_min / hertz.gap_scale,
        float(contact.separation[rupture]) / hertz.gap_scale,
    )


@njit(cache=True)
def settle(
    row: int, start: Known, scene: Scene, basis: Basis, gauss: FloatArray, tolerance: float, outcome: Outcome
) -> None:
    """Solve at the speed of a known solution, begun from it, and record what was reached."""
    approach, rupture = start.state[-2], start.state[-1]
    speed_number, allowed = np.exp(start.log_speed), allowed_residual(tolerance, start.film_min)
    layer = rupture_layer(start.rupture_gap, speed_number, scene)
    end = start.breaks[-1]
    mesh = make_mesh(rupture, approach, start.log_speed, start.film_min, layer, end, scene, basis, gauss)
    if mesh.grid.breaks.size > MAX_ELEMENTS:
        return
    states = start.state.reshape(1, -1)
    state = transfer(states, start.breaks, rupture, start.basis, mesh.grid, scene.half_domain)[0]
    fields, work = make_fields(mesh.grid.nodes.size), make_workspace(mesh.grid.nodes.size)
    count, residual = newton(state, speed_number, mesh.grid, scene, basis.integration, fields, work, allowed)
    if residual <= allowed * ACCEPTED and is_film(fields.gap, basis):
        record(row, state, speed_number, mesh, scene, basis, fields, outcome)
        outcome.numbers[row, STEPS], outcome.numbers[row, RESIDUAL] = count, residual
