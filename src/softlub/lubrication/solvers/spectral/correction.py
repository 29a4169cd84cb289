"""A solution taken to another polynomial order on its own elements: what its error is estimated by.

Begun there, Newton's method needs one factor a point, where a march of the higher order from a thick film needs six.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numba import njit

from softlub.lubrication.hertz import HertzLine
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray, lobatto_basis
from softlub.lubrication.solvers.spectral.equations import Scene, make_fields
from softlub.lubrication.solvers.spectral.grid import interpolation_weights
from softlub.lubrication.solvers.spectral.march import allowed_residual
from softlub.lubrication.solvers.spectral.newton import make_workspace, newton
from softlub.lubrication.solvers.spectral.outcome import RESIDUAL, STEPS, Outcome, record
from softlub.lubrication.solvers.spectral.remesh import mesh_on


@lru_cache(maxsize=32)
def interpolation(old: int, new: int) -> FloatArray:
    """Values at the nodes of one order of the Lagrange polynomials of another, shape (new + 1, old + 1)."""
    basis = lobatto_basis(old)
    values = np.empty((new + 1, old + 1))
    for node, row in zip(lobatto_basis(new).nodes, values, strict=True):
        interpolation_weights(node, basis, row)
    return values


def elements(contact: LubricatedContact, hertz: HertzLine, half_domain: float) -> tuple[FloatArray, int]:
    """Ends of a contact's elements in Hertz units, and how many elements lie left of the rupture point."""
    breaks = contact.positions[list(contact.breaks)] / hertz.half_width
    # Back from SI units, which rounds.
    breaks[0] = -half_domain
    inlet = int(np.argmin(np.abs(breaks - contact.rupture / hertz.half_width)))
    return breaks, inlet


def state_of(contact: LubricatedContact, hertz: HertzLine, order: int) -> FloatArray:
    """A contact's unknowns on the same elements at another order: total pressures, rigid approach, rupture point."""
    old = contact.breaks.step
    last = contact.breaks[-1]
    total = (contact.fluid_pressure + contact.solid_pressure)[: last + 1] / hertz.peak_pressure
    by_element = np.arange(0, last, old)[:, None] + np.arange(old + 1)
    moved = total[by_element] @ interpolation(old, order).T
    return np.concatenate(
        [
            moved[:, :-1].ravel(),
            [total[-1], contact.rigid_approach / hertz.gap_scale, contact.rupture / hertz.half_width],
        ]
    )


@njit(cache=True)
def settle(
    row: int,
    state: FloatArray,
    breaks: FloatArray,
    inlet: int,
    log_speed: float,
    film_min: float,
    scene: Scene,
    basis: Basis,
    gauss: FloatArray,
    tolerance: float,
    outcome: Outcome,
) -> None:
    """Solve at one ln λ from a start on given elements, and record what was reached."""
    mesh = mesh_on(breaks, inlet, state[-2], log_speed, film_min, scene, basis, gauss)
    fields, work = make_fields(mesh.grid.nodes.size), make_workspace(mesh.grid.nodes.size)
    speed_number, allowed = np.exp(log_speed), allowed_residual(tolerance, film_min)
    count, residual = newton(state, speed_number, mesh.grid, scene, basis.integration, fields, work, allowed)
    if np.isfinite(residual):
        record(row, state, speed_number, mesh, scene, basis, fields, outcome)
        outcome.numbers[row, STEPS], outcome.numbers[row, RESIDUAL] = count, residual
