"""Passes over the grid: the loops of one iteration, each reading and writing every array once.

A point is free where it carries pressure or the gap is negative: F = {p > 0 or g < 0}, with g the gap less the
contact level. Everything is dimensionless as said in `kernels`.
"""

# mypy: disable-error-code="no-untyped-def"

from __future__ import annotations

import numpy as np

from softlub.contact.solver.compiled import compiled


@compiled
def measure(pressure, gap, weight, level, block, gap_sums, weight_sums):
    """Count the free points, sum their squared gaps, and the gap and the weight φ over blocks of points.

    Parameters
    ----------
    pressure, gap, weight : ndarray, shape (nx, ny)
    level : float
        Contact level, in the arrays' precision.
    block : int
        Points along a side of a block; the last blocks may be smaller.
    gap_sums, weight_sums : ndarray, shape (ceil(nx / block), ceil(ny / block))
        Filled with Σ φ g and Σ φ over the free points of each block.

    Returns
    -------
    tuple of float
        Number of free points; Σ g² over them; Σ φ and the number of points off the free set.
    """
    nx, ny = pressure.shape
    zero = level * 0
    one = zero + 1
    row_gap = np.empty(ny, pressure.dtype)
    row_weight = np.empty(ny, pressure.dtype)
    count = 0.0
    square = 0.0
    for top in range(0, nx, block):
        row_gap[:] = 0
        row_weight[:] = 0
        for i in range(top, min(top + block, nx)):
            row_count = zero
            row_square = zero
            for j in range(ny):
                deviation = gap[i, j] - level
                free = one if (pressure[i, j] > zero) | (deviation < zero) else zero
                row_count += free
                row_square += free * deviation * deviation
                share = free * weight[i, j]
                row_weight[j] += share
                row_gap[j] += share * deviation
            count += row_count
            square += row_square
        _collect(row_gap, block, gap_sums[top // block])
        _collect(row_weight, block, weight_sums[top // block])
    return count, square


@compiled
def _collect(values, block, sums):
    """Sum the values over blocks; the last block takes what is left."""
    sums[:] = 0
    whole = values.size // block
    for offset in range(block):
        for k in range(whole):
            sums[k] += values[k * block + offset]
    for j in range(whole * block, values.size):
        sums[whole] += values[j]


@compiled
def _spread(blocks, block, values):
    """Give every point the value of its block."""
    whole = values.size // block
    for k in range(whole):
        value = blocks[k]
        for j in range(k * block, (k + 1) * block):
            values[j] = value
    for j in range(whole * block, values.size):
        values[j] = blocks[whole]


@compiled
def stencil_of_free_set(pressure, gap, level, taps, wrap, weight):
    """Fill the weight φ: the stencil applied to the free set's indicator, and its mean off the free set."""
    nx, ny = pressure.shape
    zero = level * 0
    one = zero + 1
    rows = np.zeros((5, ny + 4), pressure.dtype)
    folded = np.zeros((2, ny + 4), pressure.dtype)
    for i in range(-4, nx):
        target = (i + 2) % nx
        inside = one if (0 <= i + 2 < nx) | (wrap > zero) else zero
        row = rows[(i + 4) % 5]
        for j in range(ny):
            free = one if (pressure[target, j] > zero) | (gap[target, j] < level) else zero
            row[j + 2] = free * inside
        _halo(row, wrap)
        if i >= 0:
            _stencil_row(rows, i, taps, folded, weight[i])
    total = 0.0
    count = 0.0
    for i in range(nx):
        row_total = zero
        row_count = zero
        for j in range(ny):
            free = one if (pressure[i, j] > zero) | (gap[i, j] < level) else zero
            row_total += free * weight[i, j]
            row_count += free
        total += row_total
        count += row_count
    mean = zero + total / max(count, 1.0)
    for i in range(nx):
        for j in range(ny):
            free = (pressure[i, j] > zero) | (gap[i, j] < level)
            weight[i, j] = weight[i, j] if free else mean


@compiled
def precondition(pressure, gap, weight, level, shift, taps, wrap, coarse, block, out):
    """Fill `out` with z, the preconditioned gap: the stencil's share plus φ times the coarse correction.

    Parameters
    ----------
    pressure, gap, weight : ndarray, shape (nx, ny)
    level, shift : float
        Contact level, and the mean of the gap above it in the weight φ.
    taps : ndarray, shape (6,)
        Coefficients of the stencil, see `stencil`.
    wrap : float
        1 where the surface is periodic, else 0.
    coarse : ndarray
        Correction of every block, divided by φ.
    block : int
    out : ndarray, shape (nx, ny)
        z of the last iteration, replaced.

    Returns
    -------
    tuple of float
        Σ g z, Σ g z_last and Σ z.
    """
    nx, ny = pressure.shape
    zero = level * 0
    one = zero + 1
    whole = level + shift
    rows = np.zeros((5, ny + 4), pressure.dtype)
    folded = np.zeros((2, ny + 4), pressure.dtype)
    filtered = np.empty(ny, pressure.dtype)
    correction = np.empty(ny, pressure.dtype)
    product = 0.0
    product_last = 0.0
    total = 0.0
    for i in range(-4, nx):
        target = (i + 2) % nx
        inside = one if (0 <= i + 2 < nx) | (wrap > zero) else zero
        row = rows[(i + 4) % 5]
        for j in range(ny):
            free = one if (pressure[target, j] > zero) | (gap[target, j] < level) else zero
            row[j + 2] = free * inside * (gap[target, j] - whole)
        _halo(row, wrap)
        if i >= 0:
            _stencil_row(rows, i, taps, folded, filtered)
            if i % block == 0:
                _spread(coarse[i // block], block, correction)
            row_product = zero
            row_last = zero
            row_total = zero
            for j in range(ny):
                free = one if (pressure[i, j] > zero) | (gap[i, j] < level) else zero
                deviation = gap[i, j] - whole
                value = free * (filtered[j] + weight[i, j] * correction[j])
                row_product += deviation * value
                row_last += deviation * out[i, j]
                row_total += value
                out[i, j] = value
            product += row_product
            product_last += row_last
            total += row_total
    return product, product_last, total


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
def search(pressure, weight, preconditioned, direction, momentum, step):
    """Set direction to -z + momentum · direction; return what the trial max(0, p + step · direction) holds.

    Returns
    -------
    tuple of float
        Its sum, the sum of φ where it is positive, and the sum that was clipped.
    """
    nx, ny = pressure.shape
    zero = step * 0
    one = zero + 1
    total = 0.0
    total_weight = 0.0
    clipped = 0.0
    for i in range(nx):
        row_total = zero
        row_weight = zero
        row_clipped = zero
        for j in range(ny):
            towards = momentum * direction[i, j] - preconditioned[i, j]
            direction[i, j] = towards
            trial = pressure[i, j] + step * towards
            positive = one if trial > zero else zero
            row_total += positive * trial
            row_clipped -= (one - positive) * trial
            row_weight += positive * weight[i, j]
        total += row_total
        total_weight += row_weight
        clipped += row_clipped
    return total, total_weight, clipped


@compiled
def project(pressure, gap, weight, direction, step, lift, level):
    """Turn the direction into the step from p to the projected trial, its load restored by lift · φ.

    Returns
    -------
    tuple of float
        Σ g · step with g above `level`, and the sum of the projected trial.
    """
    nx, ny = pressure.shape
    zero = step * 0
    slope = 0.0
    total = 0.0
    for i in range(nx):
        row_slope = zero
        row_total = zero
        for j in range(ny):
            trial = pressure[i, j] + step * direction[i, j]
            trial = trial + lift * weight[i, j] if trial > zero else zero
            trial = trial if trial > zero else zero
            move = trial - pressure[i, j]
            direction[i, j] = move
            row_slope += move * (gap[i, j] - level)
            row_total += trial
        slope += row_slope
        total += row_total
    return slope, total


@compiled
def rescale(pressure, gap, move, factor, level):
    """Multiply the trial pressure + move by a factor; return Σ g · move with g above `level`."""
    nx, ny = pressure.shape
    slope = 0.0
    for i in range(nx):
        row_slope = level * 0
        for j in range(ny):
            value = factor * (pressure[i, j] + move[i, j]) - pressure[i, j]
            move[i, j] = value
            row_slope += value * (gap[i, j] - level)
        slope += row_slope
    return slope


@compiled
def room(pressure, move):
    """Largest factor of `move` that leaves every pressure positive."""
    nx, ny = pressure.shape
    least = move[0, 0] * 0
    for i in range(nx):
        for j in range(ny):
            # 0 / 0 off the contact compares as false
            ratio = move[i, j] / pressure[i, j]
            least = ratio if ratio < least else least
    return -1 / least if least < 0 else np.inf


@compiled
def advance(pressure, gap, move, displacement, factor):
    """Add `factor` times the move to the pressure and its displacement to the gap.

    Returns
    -------
    tuple of float
        Number of points under pressure, Σ of their gaps, Σ of the pressure.
    """
    nx, ny = pressure.shape
    zero = factor * 0
    one = zero + 1
    count = 0.0
    gap_total = 0.0
    total = 0.0
    for i in range(nx):
        row_count = zero
        row_gap = zero
        row_total = zero
        for j in range(ny):
            value = pressure[i, j] + factor * move[i, j]
            opening = gap[i, j] + factor * displacement[i, j]
            carries = one if value > zero else zero
            value = carries * value
            pressure[i, j] = value
            gap[i, j] = opening
            row_count += carries
            row_gap += carries * opening
            row_total += value
        count += row_count
        gap_total += row_gap
        total += row_total
    return count, gap_total, total


@compiled
def clipped(values, shift, out):
    """Fill `out` with max(0, values + shift); return its sum and the number of its positive points."""
    nx, ny = values.shape
    zero = shift * 0
    one = zero + 1
    total = 0.0
    count = 0.0
    for i in range(nx):
        row_total = zero
        row_count = zero
        for j in range(ny):
            value = values[i, j] + shift
            positive = one if value > zero else zero
            value = positive * value
            row_total += value
            row_count += positive
            out[i, j] = value
        total += row_total
        count += row_count
    return total, count


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
