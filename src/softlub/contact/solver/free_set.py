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
def weigh(pressure, gap, move, rest, level, release, taps, wrap, block, weight, preconditioned, sums):
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
    sums : ndarray, shape (2, ceil(nx / block), ceil(ny / block))
        Filled with Σ φ and Σ φ g over each block.

    Returns
    -------
    tuple of float
        Number of free points; Σ of squared violations; Σ g S g; Σ g z_last over the free set.
    """
    nx, ny = pressure.shape
    rows = np.zeros((2, 5, ny + 4), pressure.dtype)  # five of the free set, five of its gap
    folded = np.zeros((3, ny + 4), pressure.dtype)
    filtered = np.zeros((2, ny), pressure.dtype)
    columns = np.zeros((2, ny), pressure.dtype)
    totals = np.zeros(4)
    for i in range(-4, nx):
        _enter(pressure, gap, move, i + 2, rest, level, release, wrap, rows, totals)
        if i >= 0:
            _filter(rows[0], i, taps, folded, filtered[0])
            _filter(rows[1], i, taps, folded, filtered[1])
            _leave(
                rows[0, (i + 2) % 5],
                rows[1, (i + 2) % 5],
                i,
                filtered,
                weight,
                preconditioned,
                columns,
                totals,
            )
            if (i + 1) % block == 0 or i + 1 == nx:
                collect(columns[0], block, sums[0, i // block])
                collect(columns[1], block, sums[1, i // block])
                columns[:] = 0
    return totals[0], totals[1], totals[2], totals[3]


@compiled
def _enter(pressure, gap, move, entering, rest, level, release, wrap, rows, totals):
    """Lay a grid row out for the stencil, or what lies beyond an edge.

    A row of the grid has its free points and squared violations counted in `totals`.
    """
    nx, ny = pressure.shape
    number = pressure.dtype.type
    zero, one = number(0), number(1)
    least = number(RELEASE)
    inverse = one / least
    i = entering % nx
    free_row, gap_row = rows[0, (entering + 2) % 5], rows[1, (entering + 2) % 5]
    count = zero
    square = zero
    for j in range(ny):
        deviation = gap[i, j] - level
        free = one if pressure[i, j] + rest * move[i, j] > release * deviation else zero
        violation = deviation if pressure[i, j] > least * deviation else pressure[i, j] * inverse
        count += free
        square += violation * violation
        free_row[j + 2] = free
        gap_row[j + 2] = free * deviation
    on_grid = (entering >= 0) & (entering < nx)
    if on_grid:
        totals[0] += count
        totals[1] += square
    _close(free_row, one if on_grid else number(wrap), number(wrap))
    _close(gap_row, one if on_grid else number(wrap), number(wrap))


@compiled
def _close(row, inside, wrap):
    """Clear a row that lies beyond an edge without period, and lay the halo of two points at either end."""
    ny = row.size - 4
    if inside == 0:
        row[:] = 0
    row[0] = wrap * row[ny]
    row[1] = wrap * row[ny + 1]
    row[ny + 2] = wrap * row[2]
    row[ny + 3] = wrap * row[3]


@compiled
def _filter(rows, i, taps, folded, filtered):
    """Apply the stencil at grid row `i`; grid row k lies in rows[(k + 2) % 5], two places further along."""
    far_up, up, here, down, far_down = i % 5, (i + 1) % 5, (i + 2) % 5, (i + 3) % 5, (i + 4) % 5
    t00, t10, t11, t20, t21, t22 = taps[0], taps[1], taps[2], taps[3], taps[4], taps[5]
    for k in range(rows.shape[1]):
        at, near, far = rows[here, k], rows[up, k] + rows[down, k], rows[far_up, k] + rows[far_down, k]
        folded[0, k] = t00 * at + t10 * near + t20 * far
        folded[1, k] = t10 * at + t11 * near + t21 * far
        folded[2, k] = t20 * at + t21 * near + t22 * far
    for j in range(filtered.size):
        filtered[j] = (
            folded[0, j + 2] + (folded[1, j + 1] + folded[1, j + 3]) + (folded[2, j] + folded[2, j + 4])
        )


@compiled
def _leave(free_row, gap_row, i, filtered, weight, preconditioned, columns, totals):
    """Store the stencils of a row on the free set; add Σ g S g and Σ g z_last to `totals`."""
    number = weight.dtype.type
    product = number(0)
    product_last = number(0)
    for j in range(weight.shape[1]):
        free = free_row[j + 2]
        deviation = gap_row[j + 2]
        share = free * filtered[0, j]
        stiff = free * filtered[1, j]
        product += deviation * stiff
        product_last += deviation * preconditioned[i, j]
        weight[i, j] = share
        preconditioned[i, j] = stiff
    for j in range(weight.shape[1]):
        columns[0, j] += weight[i, j]
        columns[1, j] += weight[i, j] * gap_row[j + 2]
    totals[2] += product
    totals[3] += product_last


@compiled
def carried(pressure, gap):
    """Number of points that carry pressure and the sum of their gaps."""
    nx, ny = pressure.shape
    number = pressure.dtype.type
    zero, one = number(0), number(1)
    count = 0.0
    gaps = 0.0
    for i in range(nx):
        row_count = zero
        row_gap = zero
        for j in range(ny):
            carries = one if pressure[i, j] > zero else zero
            row_count += carries
            row_gap += carries * gap[i, j]
        count += row_count
        gaps += row_gap
    return count, gaps


@compiled
def residual_squares(pressure, gap, level):
    """Number of free points and the sum of their squared gaps above `level`."""
    nx, ny = pressure.shape
    number = pressure.dtype.type
    zero, one = number(0), number(1)
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


@compiled
def keep_carrying(pressure, gap, level, out):
    """Fill `out` with the pressure, less that of points about to leave the contact; return its sum."""
    nx, ny = pressure.shape
    number = pressure.dtype.type
    zero, least = number(0), number(RELEASE)
    total = 0.0
    for i in range(nx):
        row_total = 0.0
        for j in range(ny):
            carried = pressure[i, j] if pressure[i, j] > least * (gap[i, j] - level) else zero
            out[i, j] = carried
            row_total += carried
        total += row_total
    return total
