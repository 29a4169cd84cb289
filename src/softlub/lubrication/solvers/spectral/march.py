"""Continuation in the logarithm of the speed number: from a thick film down and up to all wanted speeds."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray
from softlub.lubrication.solvers.spectral.equations import Fields, Grid, Scene, make_fields, separation
from softlub.lubrication.solvers.spectral.grid import transfer
from softlub.lubrication.solvers.spectral.newton import make_workspace, newton
from softlub.lubrication.solvers.spectral.outcome import RESIDUAL, STEPS, Outcome, record, smallest_gap
from softlub.lubrication.solvers.spectral.remesh import make_mesh, outlet_end, rupture_layer, serves
from softlub.lubrication.solvers.spectral.resolution import is_film
from softlub.lubrication.solvers.spectral.start import martin_start
from softlub.lubrication.solvers.spectral.vectors import copy_into, fill, lowest

MAX_LOG_STEP = 0.9
MIN_LOG_STEP = 0.9 / 64
HISTORY = 4
MAX_ELEMENTS = 60
# The march starts at the larger of this speed number and this many times the scaled roughness.
START_SPEED_NUMBER = 60.0
START_OVER_ROUGHNESS = 30.0
STARTS = 5
# Round-off may keep a residual above the tolerance; up to this many times it is accepted.
ACCEPTED = 100.0
# Residuals are lengths in units of the gap scale: the tolerance is that of a film of this thickness or more, and falls
# with the film, down to this share.
TOLERANCE_FILM = 0.1
TOLERANCE_FLOOR = 0.01
# A prediction keeps at least this share of the last smallest gap.
KEPT_GAP = 0.2
# Grids reach this much further than the solid pressure does, since the film will thin on the way down.
REACH = 1.3


@njit(cache=True)
def predict(logs: FloatArray, states: FloatArray, count: int, log_speed: float, state: FloatArray) -> None:
    """Polynomial through the last `count` solutions (the newest first) at another speed."""
    fill(state, 0.0)
    for k in range(count):
        factor = 1.0
        for m in range(count):
            if m != k:
                factor *= (log_speed - logs[m]) / (logs[k] - logs[m])
        for i in range(state.size):
            state[i] += factor * states[k, i]


@njit(cache=True)
def push(logs: FloatArray, states: FloatArray, log_speed: float, state: FloatArray) -> None:
    """Put a solution at the head of the history."""
    for k in range(logs.size - 1, 0, -1):
        logs[k] = logs[k - 1]
        copy_into(states[k], states[k - 1])
    logs[0] = log_speed
    copy_into(states[0], state)


@njit(cache=True)
def open_gap(state: FloatArray, grid: Grid, scene: Scene, fields: Fields, allowed: float) -> float:
    """Lift the body of a predicted state where its gap would be below `allowed`; return the gap at the last node."""
    separation(state, grid, scene.half_domain, grid.nodes, grid.kernel, fields.gap, fields.gap_by_rupture)
    lift = max(allowed - fields.gap[lowest(fields.gap)], 0.0)
    state[-2] += lift
    return fields.gap[-1] + lift


@njit(cache=True)
def allowed_residual(tolerance: float, film_min: float) -> float:
    """The tolerance, which falls with the film."""
    return tolerance * min(max(film_min / TOLERANCE_FILM, TOLERANCE_FLOOR), 1.0)


@njit(cache=True)
def leg(
    targets: FloatArray,
    rows: NDArray[np.int64],
    first_log: float,
    scene: Scene,
    basis: Basis,
    gauss: FloatArray,
    dead_gap: float,
    tolerance: float,
    outcome: Outcome,
) -> bool:
    """March from a thick film through monotone targets of ln λ, recording each; False if the start fails.

    A step that fails is tried again from the state before instead of an extrapolation, then halved; below the
    smallest step the march ends and what lies beyond stays unrecorded.
    """
    mesh, state = martin_start(first_log, scene, basis, gauss, dead_gap)
    fields, work = make_fields(mesh.grid.nodes.size), make_workspace(mesh.grid.nodes.size)
    states, logs = np.zeros((HISTORY, state.size)), np.zeros(HISTORY)
    push(logs, states, first_log, state)
    known, use, index, largest = 0, HISTORY, 0, MAX_LOG_STEP
    film_min, layer = mesh.film_min, 1.0
    while index < targets.size:
        left = targets[index] - logs[0] if known > 0 else 0.0
        step = left / max(np.ceil(abs(left) / largest - 1e-9), 1.0)
        log_speed = logs[0] + step
        predict(logs, states, max(min(known, use), 1), log_speed, state)
        end_gap = open_gap(state, mesh.grid, scene, fields, KEPT_GAP * film_min)
        if known > 0 and not serves(mesh, state, log_speed, film_min, end_gap, scene):
            old = mesh.grid
            end = outlet_end(state, old, scene, basis, REACH * dead_gap)
            mesh = make_mesh(state[-1], state[-2], log_speed, film_min, layer, end, scene, basis, gauss)
            if mesh.grid.breaks.size > MAX_ELEMENTS:
                return True
            states = transfer(states, old.breaks, old.rupture, basis, mesh.grid, scene.half_domain)
            fields, work = make_fields(mesh.grid.nodes.size), make_workspace(mesh.grid.nodes.size)
            state = np.empty(states.shape[1])
            predict(logs, states, min(known, use), log_speed, state)
            open_gap(state, mesh.grid, scene, fields, KEPT_GAP * film_min)
        speed_number, allowed = np.exp(log_speed), allowed_residual(tolerance, film_min)
        count, residual = newton(
            state, speed_number, mesh.grid, scene, basis.integration, fields, work, allowed
        )
        if not (residual <= allowed * ACCEPTED and is_film(fields.gap, basis)):
            if known == 0:
                return False
            if use == 1:
                largest = 0.5 * min(largest, abs(step))
                if largest < MIN_LOG_STEP:
                    return True
            use = 1
            continue
        film_min = smallest_gap(fields.gap, basis)
        layer = rupture_layer(fields.gap[mesh.grid.inlet * (basis.nodes.size - 1)], speed_number, scene)
        push(logs, states, log_speed, state)
        known, use, largest = min(known + 1, HISTORY), HISTORY, min(MAX_LOG_STEP, 1.5 * largest)
        while index < targets.size and abs(log_speed - targets[index]) < 1e-12:
            record(rows[index], state, speed_number, mesh, scene, basis, fields, outcome)
            outcome.numbers[rows[index], STEPS], outcome.numbers[rows[index], RESIDUAL] = count, residual
            index += 1
    return True


def march(
    log_speeds: FloatArray,
    scene: Scene,
    basis: Basis,
    gauss: FloatArray,
    dead_gap: float,
    tolerance: float,
    outcome: Outcome,
) -> None:
    """Solve all ascending ln λ, from a thick film both ways, into the rows of `outcome`."""
    first = float(np.log(max(START_SPEED_NUMBER, START_OVER_ROUGHNESS * scene.roughness)))
    rows = np.arange(log_speeds.size)
    below = int(np.searchsorted(log_speeds, first))
    for targets, target_rows in (
        (log_speeds[:below][::-1].copy(), rows[:below][::-1].copy()),
        (log_speeds[below:].copy(), rows[below:].copy()),
    ):
        for trial in range(STARTS if targets.size else 0):
            start = first + trial * np.log(3.0)
            if leg(targets, target_rows, start, scene, basis, gauss, dead_gap, tolerance, outcome):
                break
