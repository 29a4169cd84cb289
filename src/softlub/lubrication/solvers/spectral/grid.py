"""Making a grid from element breaks, and moving solutions from one grid to the next by their polynomials."""

from __future__ import annotations

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray
from softlub.lubrication.solvers.spectral.equations import Grid
from softlub.lubrication.solvers.spectral.kernel import log_kernel
from softlub.lubrication.solvers.spectral.vectors import copy_into, fill


@njit(cache=True)
def make_grid(breaks: FloatArray, inlet: int, basis: Basis) -> Grid:
    """Nodes, weights and kernel of elements with the given ends, `inlet` of them left of the rupture point."""
    order = basis.nodes.size - 1
    elements = breaks.size - 1
    nodes = np.empty(elements * order + 1)
    weights = np.zeros(nodes.size)
    for e in range(elements):
        half = 0.5 * (breaks[e + 1] - breaks[e])
        for j in range(order):
            nodes[e * order + j] = breaks[e] + half * (basis.nodes[j] + 1.0)
        nodes[e * order] = breaks[e]
        for j in range(order + 1):
            weights[e * order + j] += half * basis.weights[j]
    nodes[-1] = breaks[-1]
    kernel = log_kernel(nodes, breaks, basis.legendre_weights)
    return Grid(breaks, nodes, weights, kernel, inlet, breaks[inlet])


@njit(cache=True)
def interpolation_weights(local: float, basis: Basis, weights: FloatArray) -> None:
    """Fill the values of all ℓ_j at one point of [-1, 1]."""
    total = 0.0
    for j in range(weights.size):
        distance = local - basis.nodes[j]
        if abs(distance) < 1e-15:
            fill(weights, 0.0)
            weights[j] = 1.0
            return
        weights[j] = basis.barycentric[j] / distance
        total += weights[j]
    for j in range(weights.size):
        weights[j] /= total


@njit(cache=True)
def element_of(position: float, breaks: FloatArray) -> int:
    """Index of the element that holds a position; the first or last one where none does."""
    e = 0
    while e < breaks.size - 2 and position > breaks[e + 1]:
        e += 1
    return e


@njit(cache=True)
def transfer(
    states: FloatArray, breaks: FloatArray, rupture: float, basis: Basis, new: Grid, half_domain: float
) -> FloatArray:
    """Solutions on old elements at the nodes of a new grid, shape (count, n_new + 2).

    `breaks`, `rupture` and `basis` are those of the old elements; the new grid's order may be another. Each state
    stretches both grids to its own rupture point, so one interpolation serves them all. Beyond the old elements the
    pressure is zero.
    """
    order = basis.nodes.size - 1
    n, m = states.shape[1] - 2, new.nodes.size
    moved = np.zeros((states.shape[0], m + 2))
    ratio = (rupture + half_domain) / (new.rupture + half_domain)
    weights = np.empty(order + 1)
    for i in range(m):
        position = (new.nodes[i] + half_domain) * ratio - half_domain
        if position > breaks[-1] * (1 + 1e-12):
            continue
        e = element_of(position, breaks)
        half = 0.5 * (breaks[e + 1] - breaks[e])
        interpolation_weights((position - breaks[e]) / half - 1.0, basis, weights)
        for k in range(states.shape[0]):
            for j in range(order + 1):
                moved[k, i] += weights[j] * states[k, e * order + j]
    for k in range(states.shape[0]):
        copy_into(moved[k, m:], states[k, n:])
    return moved
