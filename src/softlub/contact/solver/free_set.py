"""The free set: the stencil, the weights and the sums that an iteration needs, in one pass over the grid.

A point is free where t > c g: t is its pressure in the last trial, the gap g is taken above the contact level, and
c is small. So it carries pressure and is not about to leave the contact, or it overlaps. The trial's pressure and
not the present one, since a step of less than full length leaves some pressure on every point that the trial
clipped. Kept in the free set, such points bend the preconditioned direction of their neighbours uphill, and only
ever shrink. Everything is dimensionless as said in `kernels`.
"""

# mypy: disable-error-code="no-untyped-def"

from __future__ import annotations

import numpy as np

from softlub.contact.solver.blocks import collect
from softlub.contact.solver.compiled import compiled

RELEASE = np.float32(0.05)
"""Least c of the free set; it is raised where the direction leads uphill all the same."""


@compiled
def weigh(
    pressure,
    gap,
    move,
    rest,
    level,
    release,
    taps,
    wrap,
    block,
    weight,
    preconditioned,
    gap_sums,
    weight_sums,
):
    """Apply the stencil to the free set and to its gap; sum up what the step needs.

    Parameters
    ----------
    pressure, gap, move : ndarray, shape (nx, ny)
        `move` is the step to the last trial.
    rest : float
        Share of that step that was not taken.
    level : float
        Contact level, in the arrays' precision.
    release : float
        c of the free set, at least `RELEASE`.
    taps : ndarray, shape (6,)
        Coefficients of the stencil S, see `stencil`.
    wrap : float
        1 where the surface is periodic, else 0.
    block : int
        Points along a side of a block; the last blocks may be smaller.
    weight : ndarray, shape (nx, ny)
        Filled with φ = S 1 on the free set, 0 elsewhere.
    preconditioned : ndarray, shape (nx, ny)
        z of the last iteration; replaced by S g on the free set, 0 elsewhere.
    gap_sums, weight_sums : ndarray, shape (ceil(nx / block), ceil(ny / block))
        Filled with Σ φ g and Σ φ over each block.

    Returns
    -------
    tuple of float
        Number of free points; Σ of squared violations; Σ g S g; Σ g z_last over the free set.
    """
    nx, ny = pressure.shape
    zero = level * 0
    one = zero + 1
    free_rows = np.zeros((5, ny + 4), pressure.dtype)
    gap_rows = np.zeros((5, ny + 4), pressure.dtype)
    folded = np.zeros((2, ny + 4), pressure.dtype)
    stencil_free = np.zeros(ny, pressure.dtype)
    stencil_gap = np.zeros(ny, pressure.dtype)
    column_gap = np.zeros(ny, pressure.dtype)
    column_weight = np.zeros(ny, pressure.dtype)
    count = 0.0
    square = 0.0
    product = 0.0
    product_last = 0.0
    for i in range(-4, nx):
        target = (i + 2) % nx
        inside = one if (0 <= i + 2 < nx) | (wrap > zero) else zero
        slot = (i + 4) % 5
        row_count, row_square = _enter(
            pressure[target],
            gap[target],
            move[target],
            rest,
            level,
            release,
            inside,
            wrap,
            free_rows[slot],
            gap_rows[slot],
        )
        if 0 <= i + 2 < nx:
            count += row_count
            square += row_square
        if i < 0:
            continue
        _stencil_row(free_rows, i, taps, folded, stencil_free)
        _stencil_row(gap_rows, i, taps, folded, stencil_gap)
        row_product, row_last = _leave(
            free_rows[(i + 2) % 5],
            gap_rows[(i + 2) % 5],
            stencil_free,
            stencil_gap,
            weight[i],
            preconditioned[i],
            column_gap,
            column_weight,
        )
        product += row_product
        product_last += row_last
        if (i + 1) % block == 0 or i + 1 == nx:
            collect(column_gap, block, gap_sums[i // block])
            collect(column_weight, block, weight_sums[i // block])
            column_gap[:] = 0
            column_weight[:] = 0
    return count, square, product, product_last


@compiled
def _enter(pressure, gap, move, rest, level, release, inside, wrap, free_row, gap_row):
    """Lay a grid row and its halo out for the stencil; return its free points and squared violations."""
    zero = level * 0
    one = zero + 1
    count = zero
    square = zero
    for j in range(pressure.size):
        deviation = gap[j] - level
        free = one if pressure[j] + rest * move[j] > release * deviation else zero
        violation = deviation if pressure[j] > RELEASE * deviation else pressure[j] * (one / RELEASE)
        count += free
        square += violation * violation
        free_row[j + 2] = free * inside
        gap_row[j + 2] = free * inside * deviation
    _halo(free_row, wrap)
    _halo(gap_row, wrap)
    return count, square


@compiled
def _leave(free_row, gap_row, stencil_free, stencil_gap, weight, preconditioned, column_gap, column_weight):
    """Store a row's stencils on the free set; return Σ g S g and Σ g z_last."""
    product = free_row[0] * 0
    product_last = free_row[0] * 0
    for j in range(weight.size):
        free = free_row[j + 2]
        deviation = gap_row[j + 2]
        share = free * stencil_free[j]
        stiff = free * stencil_gap[j]
        product += deviation * stiff
        product_last += deviation * preconditioned[j]
        column_weight[j] += share
        column_gap[j] += share * deviation
        weight[j] = share
        preconditioned[j] = stiff
    return product, product_last


@compiled
def _halo(row, wrap):
    ny = row.size - 4
    row[0] = wrap * row[ny]
    row[1] = wrap * row[ny + 1]
    row[ny + 2] = wrap * row[2]
    row[ny + 3] = wrap * row[3]


@compiled
def _stencil_row(rows, i, taps, folded, out):
    """Apply the stencil at grid row `i`; grid row k lies in rows[(k + 2) % 5], with two points of halo a side."""
    near, far = folded[0], folded[1]
    here = rows[(i + 2) % 5]
    _add(rows[(i + 1) % 5], rows[(i + 3) % 5], near)
    _add(rows[i % 5], rows[(i + 4) % 5], far)
    t00, t10, t11, t20, t21, t22 = taps[0], taps[1], taps[2], taps[3], taps[4], taps[5]
    for j in range(out.size):
        # halo: the point stands two places further
        out[j] = (
            t00 * here[j + 2]
            + t10 * (here[j + 1] + here[j + 3] + near[j + 2])
            + t11 * (near[j + 1] + near[j + 3])
            + t20 * (here[j] + here[j + 4] + far[j + 2])
            + t21 * (near[j] + near[j + 4] + far[j + 1] + far[j + 3])
            + t22 * (far[j] + far[j + 4])
        )


@compiled
def _add(first, second, out):
    for k in range(out.size):
        out[k] = first[k] + second[k]


@compiled
def residual_squares(pressure, gap, level):
    """Number of free points and the sum of their squared gaps above `level`."""
    nx, ny = pressure.shape
    zero = level * 0
    one = zero + 1
    count = 0.0
    square = 0.0
    for i in range(nx):
        row_count = zero
        row_square = zero
        for j in range(ny):
            deviation = gap[i, j] - level
            free = one if (pressure[i, j] > zero) | (deviation < zero) else zero
            row_count += free
            row_square += free * deviation * deviation
        count += row_count
        square += row_square
    return count, square
