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
    number = pressure.dtype.type
    beyond = number(wrap)
    free_rows = np.zeros((5, ny + 4), pressure.dtype)
    gap_rows = np.zeros((5, ny + 4), pressure.dtype)
    filtered = np.zeros((2, ny), pressure.dtype)
    columns = np.zeros((2, ny), pressure.dtype)
    folded = np.zeros((3, ny + 4), pressure.dtype)
    totals = np.zeros(4)
    for i in range(-4, nx):
        entering = i + 2
        slot = (i + 4) % 5
        on_grid = (entering >= 0) & (entering < nx)
        _enter(
            pressure,
            gap,
            move,
            entering % nx,
            rest,
            level,
            release,
            free_rows,
            gap_rows,
            slot,
            totals,
            on_grid,
        )
        _close(free_rows, slot, number(1) if on_grid else beyond, beyond)
        _close(gap_rows, slot, number(1) if on_grid else beyond, beyond)
        if i >= 0:
            _filter(free_rows, i, taps, folded, filtered, 0)
            _filter(gap_rows, i, taps, folded, filtered, 1)
            _leave(free_rows, gap_rows, (i + 2) % 5, filtered, weight, preconditioned, i, columns, totals)
            if (i + 1) % block == 0 or i + 1 == nx:
                collect(columns[0], block, weight_sums[i // block])
                collect(columns[1], block, gap_sums[i // block])
                columns[:] = 0
    return totals[0], totals[1], totals[2], totals[3]


@compiled
def _enter(pressure, gap, move, i, rest, level, release, free_rows, gap_rows, slot, totals, counted):
    """Lay a grid row out for the stencil; count its free points and squared violations in `totals`."""
    number = pressure.dtype.type
    zero, one = number(0), number(1)
    least = number(RELEASE)
    inverse = one / least
    count = zero
    square = zero
    for j in range(pressure.shape[1]):
        deviation = gap[i, j] - level
        free = one if pressure[i, j] + rest * move[i, j] > release * deviation else zero
        violation = deviation if pressure[i, j] > least * deviation else pressure[i, j] * inverse
        count += free
        square += violation * violation
        free_rows[slot, j + 2] = free
        gap_rows[slot, j + 2] = free * deviation
    if counted:
        totals[0] += count
        totals[1] += square


@compiled
def _close(rows, slot, inside, wrap):
    """Clear a row that lies beyond an edge without period, and lay the halo of two points at either end."""
    ny = rows.shape[1] - 4
    if inside == 0:
        rows[slot, :] = 0
    rows[slot, 0] = wrap * rows[slot, ny]
    rows[slot, 1] = wrap * rows[slot, ny + 1]
    rows[slot, ny + 2] = wrap * rows[slot, 2]
    rows[slot, ny + 3] = wrap * rows[slot, 3]


@compiled
def _filter(rows, i, taps, folded, filtered, which):
    """Apply the stencil at grid row `i`; grid row k lies in rows[(k + 2) % 5], two places further along."""
    far_up, up, here, down, far_down = i % 5, (i + 1) % 5, (i + 2) % 5, (i + 3) % 5, (i + 4) % 5
    t00, t10, t11, t20, t21, t22 = taps[0], taps[1], taps[2], taps[3], taps[4], taps[5]
    for k in range(rows.shape[1]):
        at, near, far = rows[here, k], rows[up, k] + rows[down, k], rows[far_up, k] + rows[far_down, k]
        folded[0, k] = t00 * at + t10 * near + t20 * far
        folded[1, k] = t10 * at + t11 * near + t21 * far
        folded[2, k] = t20 * at + t21 * near + t22 * far
    for j in range(filtered.shape[1]):
        filtered[which, j] = (
            folded[0, j + 2] + (folded[1, j + 1] + folded[1, j + 3]) + (folded[2, j] + folded[2, j + 4])
        )


@compiled
def _leave(free_rows, gap_rows, slot, filtered, weight, preconditioned, i, columns, totals):
    """Store the stencils of a row on the free set; add Σ g S g and Σ g z_last to `totals`."""
    number = weight.dtype.type
    product = number(0)
    product_last = number(0)
    for j in range(weight.shape[1]):
        free = free_rows[slot, j + 2]
        deviation = gap_rows[slot, j + 2]
        share = free * filtered[0, j]
        stiff = free * filtered[1, j]
        product += deviation * stiff
        product_last += deviation * preconditioned[i, j]
        weight[i, j] = share
        preconditioned[i, j] = stiff
    for j in range(weight.shape[1]):
        columns[0, j] += weight[i, j]
        columns[1, j] += weight[i, j] * gap_rows[slot, j + 2]
    totals[2] += product
    totals[3] += product_last


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
