"""One lubricated contact on a given grid: the discrete equations, their derivative, and Newton's method.

Unknowns, in Hertz units: the total pressure P at the nodes, the rigid approach H_c, the rupture point b. The grid was
made for the rupture point b_0; it is stretched about its left end, X = -L + s (Y + L) with s = (b + L)/(b_0 + L),
so that a moving b needs no new kernel:

    H_i = H_c + X_i²/2 - (s/π) (Σ_j K_ij P_j + ln s Σ_j w_j P_j)

Rows: p_f = 0 at -L; in each element left of b Reynolds' equation, once integrated from the element's left end,

    p_f,i - p_f,left = s λ Σ_j S_ij (H_j - H_b) / H_j³

(which holds p_f'(b) = 0 by itself); P = p_s(H) right of b; p_f(b) = 0; the load Σ s w P = π/2. p_f = P - p_s(H).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import FloatArray
from softlub.lubrication.solvers.spectral.vectors import copy_into, inner
from softlub.pressure_table import pressure_and_slope

# In deep contact round-off in H is multiplied by dp_s/dH, which rows are therefore allowed to miss by.
SLOPE_SHARE = 0.01
# The load is held to this share of the tolerance.
LOAD_SCALE = 0.02


class Scene(NamedTuple):
    """What stays the same along a sweep, in Hertz units.

    Attributes
    ----------
    half_domain : float
        L.
    roughness : float
        h_rms R/a².
    first, step, coefficients : float, float, ndarray
        The contact law's pressure table over H, in units of p0.
    """

    half_domain: float
    roughness: float
    first: float
    step: float
    coefficients: FloatArray


class Grid(NamedTuple):
    """Elements made for one rupture point, and the kernel on them.

    Attributes
    ----------
    breaks : ndarray, shape (e + 1,)
    nodes, weights : ndarray, shape (n,)
        Y and quadrature weights.
    kernel : ndarray, shape (n, n)
        ∫ ln|Y_i - Y| ℓ_j dY.
    inlet : int
        Number of elements left of b.
    rupture : float
        b_0.
    """

    breaks: FloatArray
    nodes: FloatArray
    weights: FloatArray
    kernel: FloatArray
    inlet: int
    rupture: float


class Fields(NamedTuple):
    """Nodal fields of one iterate, shape (n,) each, filled in place.

    Attributes
    ----------
    gap, gap_by_rupture : ndarray
        H and dH/db.
    solid, solid_slope : ndarray
        p_s and dp_s/dH.
    flow, flow_slope, flow_outlet : ndarray
        (H - H_b)/H³, its derivatives by H and by H_b.
    residual : ndarray, shape (n + 2,)
        One entry a row, not scaled.
    scale : ndarray, shape (n + 2,)
        What the rows are divided by.
    """

    gap: FloatArray
    gap_by_rupture: FloatArray
    solid: FloatArray
    solid_slope: FloatArray
    flow: FloatArray
    flow_slope: FloatArray
    flow_outlet: FloatArray
    residual: FloatArray
    scale: FloatArray


@njit(cache=True)
def make_fields(nodes: int) -> Fields:
    """Room for the fields of a grid."""
    return Fields(
        np.zeros(nodes),
        np.zeros(nodes),
        np.zeros(nodes),
        np.zeros(nodes),
        np.zeros(nodes),
        np.zeros(nodes),
        np.zeros(nodes),
        np.zeros(nodes + 2),
        np.ones(nodes + 2),
    )


@njit(cache=True)
def separation(
    state: FloatArray,
    grid: Grid,
    half_domain: float,
    nodes: FloatArray,
    kernel: FloatArray,
    gap: FloatArray,
    by_rupture: FloatArray,
) -> None:
    """Fill H and dH/db at the given nodes (of the grid or elsewhere; `kernel` holds their rows)."""
    n = grid.nodes.size
    pressure, approach, rupture = state[:n], state[n], state[n + 1]
    length = grid.rupture + half_domain
    stretch = (rupture + half_domain) / length
    log_stretch = np.log(stretch)
    total = inner(grid.weights, pressure)
    for i in range(nodes.size):
        potential = inner(kernel[i], pressure)
        distance = nodes[i] + half_domain
        position = stretch * distance - half_domain
        gap[i] = approach + 0.5 * position**2 - stretch / np.pi * (potential + log_stretch * total)
        by_rupture[i] = (position * distance - (potential + (log_stretch + 1.0) * total) / np.pi) / length


@njit(cache=True)
def evaluate(
    state: FloatArray, speed_number: float, grid: Grid, scene: Scene, integration: FloatArray, fields: Fields
) -> float:
    """Fill `fields` at an iterate; return the largest scaled residual, infinite where the gap closes."""
    n = grid.nodes.size
    gap, solid, residual = fields.gap, fields.solid, fields.residual
    separation(state, grid, scene.half_domain, grid.nodes, grid.kernel, gap, fields.gap_by_rupture)
    order = integration.shape[0] - 1
    last = grid.inlet * order
    outlet = gap[last]
    for i in range(n):
        if not gap[i] > 0.0:
            return np.inf
        solid[i], fields.solid_slope[i] = pressure_and_slope(
            scene.first, scene.step, scene.coefficients, gap[i]
        )
        cube = 1.0 / gap[i] ** 3
        fields.flow[i] = (gap[i] - outlet) * cube
        fields.flow_slope[i] = (3 * outlet - 2 * gap[i]) * cube / gap[i]
        fields.flow_outlet[i] = -cube
    stretch = (state[n + 1] + scene.half_domain) / (grid.rupture + scene.half_domain)
    residual[0] = state[0] - solid[0]
    for e in range(grid.inlet):
        first = e * order
        width = 0.5 * (grid.breaks[e + 1] - grid.breaks[e]) * speed_number * stretch
        start = state[first] - solid[first]
        for i in range(1, order + 1):
            rise = 0.0
            largest = 0.0
            for j in range(order + 1):
                rise += integration[i, j] * fields.flow[first + j]
                largest = max(largest, abs(integration[i, j] * fields.flow_slope[first + j]))
            residual[first + i] = state[first + i] - solid[first + i] - start - width * rise
            fields.scale[first + i] = 1.0 + width * largest + SLOPE_SHARE * abs(fields.solid_slope[first + i])
    for i in range(last + 1, n):
        residual[i] = state[i] - solid[i]
        fields.scale[i] = 1.0 + SLOPE_SHARE * abs(fields.solid_slope[i])
    residual[n] = state[last] - solid[last]
    fields.scale[n] = 1.0 + SLOPE_SHARE * abs(fields.solid_slope[last])
    residual[n + 1] = stretch * inner(grid.weights, state[:n]) - 0.5 * np.pi
    fields.scale[n + 1] = LOAD_SCALE
    worst = 0.0
    for i in range(n + 2):
        worst = max(worst, abs(residual[i]) / fields.scale[i])
    return worst


@njit(cache=True)
def gap_derivative(
    state: FloatArray, grid: Grid, half_domain: float, fields: Fields, derivative: FloatArray
) -> None:
    """Fill dH_i by all unknowns, shape (n, n + 2): the one place that knows the elastic body."""
    n = grid.nodes.size
    stretch = (state[n + 1] + half_domain) / (grid.rupture + half_domain)
    log_stretch = np.log(stretch)
    for i in range(n):
        for j in range(n):
            derivative[i, j] = -stretch / np.pi * (grid.kernel[i, j] + log_stretch * grid.weights[j])
        derivative[i, n] = 1.0
        derivative[i, n + 1] = fields.gap_by_rupture[i]


@njit(cache=True, fastmath={"contract", "reassoc", "nsz"})
def _subtract_rows(row: FloatArray, factors: FloatArray, sources: FloatArray) -> None:
    """Subtract a linear combination of rows, four at a time."""
    whole = factors.size // 4 * 4
    for j in range(0, whole, 4):
        f0, f1, f2, f3 = factors[j], factors[j + 1], factors[j + 2], factors[j + 3]
        s0, s1, s2, s3 = sources[j], sources[j + 1], sources[j + 2], sources[j + 3]
        for k in range(row.size):
            row[k] -= f0 * s0[k] + f1 * s1[k] + f2 * s2[k] + f3 * s3[k]
    for j in range(whole, factors.size):
        factor, source = factors[j], sources[j]
        for k in range(row.size):
            row[k] -= factor * source[k]


@njit(cache=True, fastmath={"contract", "reassoc", "nsz"})
def jacobian(
    state: FloatArray,
    speed_number: float,
    grid: Grid,
    half_domain: float,
    integration: FloatArray,
    fields: Fields,
    derivative: FloatArray,
    matrix: FloatArray,
) -> None:
    """Fill the derivative of the scaled rows; `derivative` is that of the gap."""
    n = grid.nodes.size
    order = integration.shape[0] - 1
    last = grid.inlet * order
    length = grid.rupture + half_domain
    stretch = (state[n + 1] + half_domain) / length
    factors = np.empty(order + 1)
    for i in range(n):
        row = matrix[i]
        for j in range(n + 2):
            row[j] = -fields.solid_slope[i] * derivative[i, j]
        row[i] += 1.0
    copy_into(matrix[n], matrix[last])
    for e in range(grid.inlet - 1, -1, -1):
        first = e * order
        half = 0.5 * (grid.breaks[e + 1] - grid.breaks[e]) * speed_number
        for i in range(order, 0, -1):
            row = matrix[first + i]
            rise = 0.0
            by_outlet = 0.0
            for j in range(order + 1):
                factors[j] = half * stretch * integration[i, j] * fields.flow_slope[first + j]
                by_outlet += integration[i, j] * fields.flow_outlet[first + j]
                rise += integration[i, j] * fields.flow[first + j]
            _subtract_rows(row, factors, derivative[first : first + order + 1])
            by_outlet *= half * stretch
            source = derivative[last]
            for k in range(n + 2):
                row[k] -= by_outlet * source[k]
            row[n + 1] -= half * rise / length
        # The left node's p_f is subtracted while its own row still holds just that.
        left = matrix[first]
        for i in range(1, order + 1):
            row = matrix[first + i]
            for k in range(n + 2):
                row[k] -= left[k]
    for j in range(n):
        matrix[n + 1, j] = stretch * grid.weights[j]
    matrix[n + 1, n] = 0.0
    matrix[n + 1, n + 1] = inner(grid.weights, state[:n]) / length
    for i in range(n + 2):
        factor = 1.0 / fields.scale[i]
        row = matrix[i]
        for k in range(n + 2):
            row[k] *= factor
