"""The film beyond the elements: no pressure there, but the separation that friction's Couette part needs.

Gauss points on a logarithmic map reach from the last element to the end of the domain. They are stretched with the
elements when the rupture point moves, so a three-point rule makes up for the small difference at the end.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray
from softlub.lubrication.solvers.spectral.equations import Grid, separation
from softlub.lubrication.solvers.spectral.kernel import log_kernel

END_POINTS = 3
_END_NODES = np.array([-np.sqrt(0.6), 0.0, np.sqrt(0.6)])
_END_WEIGHTS = np.array([5.0, 8.0, 5.0]) / 9.0


def remainder_points(order: int) -> int:
    """Number of Gauss points beyond elements of order p."""
    return order + 4


@lru_cache(maxsize=32)
def remainder_rule(order: int) -> FloatArray:
    """Their Gauss–Legendre nodes and weights, shape (2, points)."""
    return np.ascontiguousarray(np.stack(np.polynomial.legendre.leggauss(remainder_points(order))))


class Remainder(NamedTuple):
    """Quadrature beyond the elements of one grid.

    Attributes
    ----------
    nodes, weights : ndarray, shape (m,)
        Y and weights.
    kernel : ndarray, shape (m, n)
        Rows of the logarithmic kernel there.
    """

    nodes: FloatArray
    weights: FloatArray
    kernel: FloatArray


@njit(cache=True)
def make_remainder(grid: Grid, half_domain: float, basis: Basis, gauss: FloatArray) -> Remainder:
    """Points of the log-mapped rule `gauss` (nodes, weights in [-1, 1]; shape (2, m)) up to L."""
    start = grid.breaks[-1]
    scale = 0.5 * (start - grid.breaks[-2])
    length = max(half_domain - start, 0.0)
    half = 0.5 * np.log1p(length / scale)
    nodes = np.empty(gauss.shape[1])
    weights = np.empty(gauss.shape[1])
    for i in range(nodes.size):
        growth = np.exp(half * (gauss[0, i] + 1.0))
        nodes[i] = start + scale * (growth - 1.0)
        weights[i] = gauss[1, i] * half * scale * growth
    return Remainder(nodes, weights, log_kernel(nodes, grid.breaks, basis.legendre_weights))


@njit(cache=True)
def end_correction(
    state: FloatArray,
    grid: Grid,
    half_domain: float,
    legendre_weights: FloatArray,
    positions: FloatArray,
    weights: FloatArray,
    gap: FloatArray,
) -> None:
    """Fill the rule between the stretched end of the remainder and L (its weights may be negative)."""
    stretch = (state[-1] + half_domain) / (grid.rupture + half_domain)
    reached = stretch * (max(half_domain, grid.breaks[-1]) + half_domain) - half_domain
    half = 0.5 * (half_domain - reached)
    nodes, unused = np.empty(END_POINTS), np.empty(END_POINTS)
    for i in range(END_POINTS):
        positions[i] = reached + half * (_END_NODES[i] + 1.0)
        weights[i] = half * _END_WEIGHTS[i]
        nodes[i] = (positions[i] + half_domain) / stretch - half_domain
    kernel = log_kernel(nodes, grid.breaks, legendre_weights)
    separation(state, grid, half_domain, nodes, kernel, gap, unused)
