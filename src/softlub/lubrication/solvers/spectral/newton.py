"""Newton's method, damped where the gap would close; its last factor serves again at the end."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from softlub.lubrication.solvers.spectral.basis import FloatArray
from softlub.lubrication.solvers.spectral.equations import (
    Fields,
    Grid,
    Scene,
    evaluate,
    gap_derivative,
    jacobian,
)
from softlub.lubrication.solvers.spectral.linear import factorise, substitute
from softlub.lubrication.solvers.spectral.vectors import copy_into, inner

MAX_STEPS = 40
MAX_FACTORS = 25
# A step may change the gap by this share of itself, and the rupture point by this share of 1 + |b|.
MAX_GAP_CHANGE = 0.8
MAX_RUPTURE_CHANGE = 0.3
# Below this residual the factor at hand is used again as long as each step gains this factor.
CHORD_RESIDUAL = 1e-3
CHORD_GAIN = 0.1
# A residual that low which a step does not lower is round-off.
ROUND_OFF = 1e-9


class Workspace(NamedTuple):
    """Matrices and vectors of Newton's method on one grid."""

    derivative: FloatArray
    matrix: FloatArray
    pivots: NDArray[np.int64]
    scale: FloatArray
    step: FloatArray
    trial: FloatArray


@njit(cache=True)
def make_workspace(nodes: int) -> Workspace:
    """Room for Newton's method on a grid of so many nodes."""
    n = nodes + 2
    return Workspace(
        np.empty((nodes, n)), np.empty((n, n)), np.empty(n, np.int64), np.empty(n), np.empty(n), np.empty(n)
    )


@njit(cache=True)
def newton(
    state: FloatArray,
    speed_number: float,
    grid: Grid,
    scene: Scene,
    integration: FloatArray,
    fields: Fields,
    work: Workspace,
    tolerance: float,
) -> tuple[int, float]:
    """Solve in place from a start; return the number of steps and the largest scaled residual reached."""
    size = state.size
    residual = evaluate(state, speed_number, grid, scene, integration, fields)
    factored = False
    factors = 0
    for count in range(MAX_STEPS):
        if residual <= tolerance or not np.isfinite(residual):
            return count, residual
        if not factored:
            factors += 1
            if factors > MAX_FACTORS:
                return count, residual
            gap_derivative(state, grid, scene.half_domain, fields, work.derivative)
            jacobian(
                state,
                speed_number,
                grid,
                scene.half_domain,
                integration,
                fields,
                work.derivative,
                work.matrix,
            )
            copy_into(work.scale, fields.scale)
            if not factorise(work.matrix, work.pivots):
                return count, np.inf
        for i in range(size):
            work.step[i] = -fields.residual[i] / work.scale[i]
        substitute(work.matrix, work.pivots, work.step)
        before = residual
        share = 1.0 if factored else _admissible_share(state, grid, fields, work)
        for _ in range(8):
            for i in range(size):
                work.trial[i] = state[i] + share * work.step[i]
            if abs(work.trial[size - 1]) < scene.half_domain:
                residual = evaluate(work.trial, speed_number, grid, scene, integration, fields)
                if np.isfinite(residual):
                    break
            residual = np.inf
            share *= 0.5
        if factored and residual > 0.5 * before and before <= ROUND_OFF:
            # Round-off: the factor is good and still nothing is gained.
            evaluate(state, speed_number, grid, scene, integration, fields)
            return count + 1, before
        copy_into(state, work.trial)
        factored = share == 1.0 and residual < CHORD_RESIDUAL and residual < CHORD_GAIN * before
    return MAX_STEPS, residual


@njit(cache=True)
def _admissible_share(state: FloatArray, grid: Grid, fields: Fields, work: Workspace) -> float:
    """Share of the step that keeps the changes of the gap and of the rupture point within their limits."""
    share = 1.0
    moved = abs(work.step[work.step.size - 1])
    allowed = MAX_RUPTURE_CHANGE * (1.0 + abs(state[-1]))
    if moved > allowed:
        share = allowed / moved
    for i in range(grid.nodes.size):
        change = abs(inner(work.derivative[i], work.step))
        if change * share > MAX_GAP_CHANGE * fields.gap[i]:
            share = MAX_GAP_CHANGE * fields.gap[i] / change
    return share
