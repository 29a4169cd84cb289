"""What is kept of each solved point, written straight into the rows of preallocated arrays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray
from softlub.lubrication.solvers.spectral.equations import Fields, Grid, Scene, separation
from softlub.lubrication.solvers.spectral.grid import element_of, interpolation_weights
from softlub.lubrication.solvers.spectral.remainder import END_POINTS, end_correction, remainder_points
from softlub.lubrication.solvers.spectral.remesh import Mesh
from softlub.lubrication.solvers.spectral.vectors import fill, lowest

# Columns of `Outcome.fields` and of `Outcome.numbers`.
POSITION, WEIGHT, FLUID, SOLID, GAP, GRADIENT = range(6)
COUNT, ELEMENTS, APPROACH, GAP_MIN, GAP_CENTRAL, RUPTURE, STEPS, RESIDUAL, LOAD_ERROR, FLUID_MIN = range(10)


class Outcome(NamedTuple):
    """Results of a sweep in Hertz units, one row a speed.

    Attributes
    ----------
    fields : ndarray, shape (6, speeds, points)
        X, weight, p_f, p_s, H, dp_f/dX; only the first `numbers[:, COUNT]` points of a row are filled.
    numbers : ndarray, shape (speeds, 10)
        Scalars of each point; NaN where no solution was reached.
    """

    fields: FloatArray
    numbers: FloatArray


def make_outcome(speeds: int, elements: int, order: int) -> Outcome:
    """Room for so many speeds on so many elements each."""
    points = elements * order + 1 + remainder_points(order) + END_POINTS
    return Outcome(np.zeros((6, speeds, points)), np.full((speeds, 10), np.nan))


@njit(cache=True)
def _write_remainder(
    out: FloatArray, state: FloatArray, mesh: Mesh, length: float, legendre_weights: FloatArray
) -> int:
    """Write the film beyond the elements, where there is no pressure; return the number of points so far."""
    grid, remainder = mesh.grid, mesh.remainder
    n, far = grid.nodes.size, remainder.nodes.size
    stretch = (state[n + 1] + length) / (grid.rupture + length)
    for column in (FLUID, SOLID, GRADIENT):
        fill(out[column, n : n + far + END_POINTS], 0.0)
    for i in range(far):
        out[POSITION, n + i] = stretch * (remainder.nodes[i] + length) - length
        out[WEIGHT, n + i] = stretch * remainder.weights[i]
    separation(
        state,
        grid,
        length,
        remainder.nodes,
        remainder.kernel,
        out[GAP, n : n + far],
        out[GRADIENT, n : n + far],
    )
    fill(out[GRADIENT, n : n + far], 0.0)
    stop = n + far + END_POINTS
    end_correction(
        state,
        grid,
        length,
        legendre_weights,
        out[POSITION, n + far : stop],
        out[WEIGHT, n + far : stop],
        out[GAP, n + far : stop],
    )
    return stop


@njit(cache=True)
def record(
    row: int,
    state: FloatArray,
    speed_number: float,
    mesh: Mesh,
    scene: Scene,
    basis: Basis,
    fields: Fields,
    outcome: Outcome,
) -> None:
    """Write one solution; `fields` holds its last evaluation."""
    grid = mesh.grid
    n = grid.nodes.size
    order = basis.nodes.size - 1
    last = grid.inlet * order
    out = outcome.fields[:, row]
    length = scene.half_domain
    stretch = (state[n + 1] + length) / (grid.rupture + length)
    load = 0.0
    least = 0.0
    for i in range(n):
        out[POSITION, i] = stretch * (grid.nodes[i] + length) - length
        out[WEIGHT, i] = stretch * grid.weights[i]
        inside = 0 < i < last
        out[FLUID, i] = state[i] - fields.solid[i] if inside else 0.0
        out[SOLID, i] = fields.solid[i] if inside else state[i]
        out[GAP, i] = fields.gap[i]
        out[GRADIENT, i] = speed_number * fields.flow[i] if i <= last else 0.0
        load += out[WEIGHT, i] * (out[FLUID, i] + out[SOLID, i])
        least = min(least, out[FLUID, i])
    stop = _write_remainder(out, state, mesh, length, basis.legendre_weights)
    numbers = outcome.numbers[row]
    numbers[COUNT] = stop
    numbers[ELEMENTS] = grid.breaks.size - 1
    numbers[APPROACH] = state[n]
    numbers[GAP_MIN] = smallest_gap(fields.gap, basis)
    numbers[GAP_CENTRAL] = central_gap(stretch, grid, length, fields.gap, basis)
    numbers[RUPTURE] = state[n + 1]
    numbers[LOAD_ERROR] = abs(load / (0.5 * np.pi) - 1.0)
    numbers[FLUID_MIN] = least


@njit(cache=True)
def polynomial(local: float, values: FloatArray, basis: Basis, weights: FloatArray) -> float:
    """Value at one point of the polynomial through nodal values."""
    interpolation_weights(local, basis, weights)
    total = 0.0
    for j in range(weights.size):
        total += weights[j] * values[j]
    return total


@njit(cache=True)
def central_gap(stretch: float, grid: Grid, half_domain: float, gap: FloatArray, basis: Basis) -> float:
    """H at X = 0."""
    order = basis.nodes.size - 1
    position = half_domain / stretch - half_domain
    e = element_of(position, grid.breaks)
    half = 0.5 * (grid.breaks[e + 1] - grid.breaks[e])
    local = (position - grid.breaks[e]) / half - 1.0
    return polynomial(local, gap[e * order : (e + 1) * order + 1], basis, np.empty(order + 1))


@njit(cache=True)
def smallest_gap(gap: FloatArray, basis: Basis) -> float:
    """Minimum of the polynomials around the lowest node."""
    order = basis.nodes.size - 1
    node = lowest(gap)
    best = gap[node]
    slope = np.empty(order + 1)
    weights = np.empty(order + 1)
    for e in range(max((node - 1) // order, 0), min(node // order, (gap.size - 1) // order - 1) + 1):
        values = gap[e * order : (e + 1) * order + 1]
        for i in range(order + 1):
            slope[i] = 0.0
            for j in range(order + 1):
                slope[i] += basis.differentiation[i, j] * values[j]
        here = node - e * order
        low = basis.nodes[max(here - 1, 0)]
        high = basis.nodes[min(here + 1, order)]
        for _ in range(26):
            middle = 0.5 * (low + high)
            if polynomial(middle, slope, basis, weights) < 0:
                low = middle
            else:
                high = middle
        best = min(best, polynomial(0.5 * (low + high), values, basis, weights))
    return best
