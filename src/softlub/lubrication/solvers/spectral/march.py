"""Continuation in the logarithm of the speed number: from a thick film down and up to all wanted speeds."""

from __future__ import annotations

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray
from softlub.lubrication.solvers.spectral.breaks import element_breaks, is_hertzian
from softlub.lubrication.solvers.spectral.equations import (
    Fields,
    Grid,
    Scene,
    evaluate,
    make_fields,
    separation,
)
from softlub.lubrication.solvers.spectral.grid import make_grid, transfer
from softlub.lubrication.solvers.spectral.kernel import log_kernel
from softlub.lubrication.solvers.spectral.martin import rigid_film
from softlub.lubrication.solvers.spectral.newton import make_workspace, newton
from softlub.lubrication.solvers.spectral.outcome import RESIDUAL, STEPS, Outcome, record, smallest_gap
from softlub.lubrication.solvers.spectral.remainder import make_remainder

MAX_LOG_STEP = 0.9
MIN_LOG_STEP = 0.9 / 64
HISTORY = 4
MAX_ELEMENTS = 60
# A grid serves as long as the speed number changes by less than this (in the logarithm), the rupture point (and the
# elements with it) by less than this share of the finest element, and the smallest gap falls by less than this factor.
GRID_LOG_RANGE = 2.8
GRID_RUPTURE_SHARE = 0.4
GRID_GAP_FACTOR = 0.45


@njit(cache=True)
def predict(
    log_speeds: FloatArray, states: FloatArray, count: int, log_speed: float, state: FloatArray
) -> None:
    """Polynomial through the last `count` solutions (the newest first) at another speed."""
    state[:] = 0.0
    for k in range(count):
        factor = 1.0
        for m in range(count):
            if m != k:
                factor *= (log_speed - log_speeds[m]) / (log_speeds[k] - log_speeds[m])
        for i in range(state.size):
            state[i] += factor * states[k, i]


@njit(cache=True)
def open_gap(state: FloatArray, grid: Grid, scene: Scene, fields: Fields, allowed: float) -> None:
    """Lift the body of a predicted state where the gap would be smaller than allowed."""
    separation(state, grid, scene.half_domain, grid.nodes, grid.kernel, fields.gap, fields.gap_by_rupture)
    lowest = np.min(fields.gap)
    if lowest < allowed:
        state[-2] += allowed - lowest


@njit(cache=True)
def rupture_layer(fields: Fields, last: int, speed_number: float) -> float:
    """Length |dp_s/dH| H³/λ over which asperities and flow find their balance before the rupture."""
    return -fields.solid_slope[last] * fields.gap[last] ** 3 / speed_number


@njit(cache=True)
def outlet_end(state: FloatArray, grid: Grid, scene: Scene, basis: Basis, dead_gap: float) -> float:
    """Where right of the rupture the separation reaches `dead_gap`, at which the solid pressure has died out."""
    rupture = state[-1]
    width = 0.1
    position, gap, unused = np.empty(1), np.empty(1), np.empty(1)
    stretch = (rupture + scene.half_domain) / (grid.rupture + scene.half_domain)
    end = rupture
    for _ in range(30):
        position[0] = (end + scene.half_domain) / stretch - scene.half_domain
        kernel = log_kernel(position, grid.breaks, basis.legendre_weights)
        separation(state, grid, scene.half_domain, position, kernel, gap, unused)
        if gap[0] >= dead_gap or end >= scene.half_domain:
            break
        end = min(rupture + width, scene.half_domain)
        width *= 1.5
    return end


@njit(cache=True)
def martin_start(speed_number: float, scene: Scene, basis: Basis, dead_gap: float) -> tuple[Grid, FloatArray]:
    """Grid and first iterate of a thick film."""
    film, rupture = rigid_film(speed_number, scene.half_domain)
    end = min(np.sqrt(2 * max(dead_gap - film, 0.0)), scene.half_domain)
    breaks, inlet = element_breaks(
        rupture,
        film,
        film,
        speed_number,
        scene.roughness,
        1.0,
        np.array([-scene.half_domain, max(end, rupture)]),
    )
    grid = make_grid(breaks, inlet, basis)
    order = basis.nodes.size - 1
    state = np.zeros(grid.nodes.size + 2)
    outlet = film + 0.5 * rupture**2
    gap = film + 0.5 * grid.nodes**2
    flow = (gap - outlet) / gap**3
    for e in range(inlet):
        half = 0.5 * (breaks[e + 1] - breaks[e]) * speed_number
        for i in range(1, order + 1):
            rise = 0.0
            for j in range(order + 1):
                rise += basis.integration[i, j] * flow[e * order + j]
            state[e * order + i] = state[e * order] + half * rise
    middle = int(np.argmin(np.abs(grid.nodes)))
    n = grid.nodes.size
    state[n] = film + np.sum(grid.kernel[middle] * state[:n]) / np.pi
    state[n + 1] = rupture
    return grid, state


@njit(cache=True)
def leg(
    targets: FloatArray,
    rows: FloatArray,
    first_log: float,
    grid: Grid,
    first_state: FloatArray,
    scene: Scene,
    basis: Basis,
    gauss: FloatArray,
    dead_gap: float,
    tolerance: float,
    outcome: Outcome,
) -> None:
    """March from one solution through monotone targets of ln λ, recording each."""
    fields, work = make_fields(grid.nodes.size), make_workspace(grid.nodes.size)
    remainder = make_remainder(grid, scene.half_domain, basis, gauss)
    states = np.zeros((HISTORY, first_state.size))
    states[0] = first_state
    logs = np.zeros(HISTORY)
    logs[0] = first_log
    known = 1
    evaluate(first_state, np.exp(first_log), grid, scene, basis.integration, fields)
    film_min = smallest_gap(fields.gap, basis)
    layer = rupture_layer(fields, grid.inlet * (basis.nodes.size - 1), np.exp(first_log))
    grid_log, grid_film = first_log, film_min
    grid_hertzian = is_hertzian(first_state[-2], film_min, np.exp(first_log), scene.roughness)
    state = first_state.copy()
    for index in range(targets.size):
        largest = MAX_LOG_STEP
        use = HISTORY
        while True:
            left = targets[index] - logs[0]
            step = left / max(np.ceil(abs(left) / largest - 1e-9), 1.0)
            log_speed = logs[0] + step
            speed_number = np.exp(log_speed)
            predict(logs, states, min(known, use), log_speed, state)
            hertzian = is_hertzian(state[-2], film_min, speed_number, scene.roughness)
            finest = np.min(np.diff(grid.breaks[: grid.inlet + 1]))
            if (
                abs(log_speed - grid_log) > GRID_LOG_RANGE
                or abs(state[-1] - grid.rupture) > GRID_RUPTURE_SHARE * finest
                or film_min < GRID_GAP_FACTOR * grid_film
                or hertzian != grid_hertzian
            ):
                end = outlet_end(states[0], grid, scene, basis, dead_gap)
                breaks, inlet = element_breaks(
                    state[-1],
                    state[-2],
                    film_min,
                    speed_number,
                    scene.roughness,
                    layer,
                    np.array([-scene.half_domain, end + state[-1] - states[0, -1]]),
                )
                if breaks.size > MAX_ELEMENTS:
                    return
                new = make_grid(breaks, inlet, basis)
                states = transfer(states, grid, new, scene.half_domain, basis)
                grid = new
                grid_log, grid_film, grid_hertzian = log_speed, film_min, hertzian
                fields, work = make_fields(grid.nodes.size), make_workspace(grid.nodes.size)
                remainder = make_remainder(grid, scene.half_domain, basis, gauss)
                state = np.empty(states.shape[1])
                predict(logs, states, min(known, use), log_speed, state)
            open_gap(state, grid, scene, fields, 0.2 * film_min)
            steps, residual = newton(
                state, speed_number, grid, scene, basis.integration, fields, work, tolerance
            )
            if not residual <= tolerance * 100:
                if use > 1:
                    use = 1
                    continue
                largest = 0.5 * min(largest, abs(step))
                if largest < MIN_LOG_STEP:
                    return
                continue
            use = HISTORY
            largest = min(MAX_LOG_STEP, largest * 1.5)
            known = min(known + 1, HISTORY)
            for k in range(HISTORY - 1, 0, -1):
                states[k] = states[k - 1]
                logs[k] = logs[k - 1]
            states[0] = state
            logs[0] = log_speed
            film_min = smallest_gap(fields.gap, basis)
            layer = rupture_layer(fields, grid.inlet * (basis.nodes.size - 1), speed_number)
            if abs(log_speed - targets[index]) < 1e-12:
                break
        row = int(rows[index])
        record(row, state, speed_number, grid, remainder, scene, basis, fields, outcome)
        outcome.numbers[row, STEPS] = steps
        outcome.numbers[row, RESIDUAL] = residual


@njit(cache=True)
def march(
    log_speeds: FloatArray,
    scene: Scene,
    basis: Basis,
    gauss: FloatArray,
    dead_gap: float,
    tolerance: float,
    outcome: Outcome,
) -> None:
    """Solve all ascending ln λ, from a thick film both ways."""
    start = max(60.0, 30 * scene.roughness)
    for _ in range(5):
        grid, state = martin_start(start, scene, basis, dead_gap)
        fields, work = make_fields(grid.nodes.size), make_workspace(grid.nodes.size)
        _, residual = newton(state, start, grid, scene, basis.integration, fields, work, tolerance)
        if residual <= tolerance * 100:
            below = np.searchsorted(log_speeds, np.log(start))
            rows = np.arange(log_speeds.size).astype(np.float64)
            down, up = log_speeds[:below][::-1].copy(), log_speeds[below:].copy()
            leg(
                down,
                rows[:below][::-1].copy(),
                np.log(start),
                grid,
                state,
                scene,
                basis,
                gauss,
                dead_gap,
                tolerance,
                outcome,
            )
            leg(
                up,
                rows[below:].copy(),
                np.log(start),
                grid,
                state,
                scene,
                basis,
                gauss,
                dead_gap,
                tolerance,
                outcome,
            )
            return
        start *= 3
