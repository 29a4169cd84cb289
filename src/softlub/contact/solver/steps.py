"""Passes over the grid that search, project and take a step; each reads and writes every array once."""

# mypy: disable-error-code="no-untyped-def"

from __future__ import annotations

import numpy as np

from softlub.contact.solver.blocks import collect, spread
from softlub.contact.solver.compiled import compiled


@compiled
def search(pressure, weight, coarse, block, preconditioned, direction, momentum, step, added):
    """Complete z, set direction to -z + momentum · direction, and sum up the trial max(0, p + step · direction).

    A point that is not free but still carries pressure gives it up: its trial is 0.

    Parameters
    ----------
    pressure, weight : ndarray, shape (nx, ny)
        The weight φ is positive on the free set (no stencil of free points sums to less), 0 elsewhere.
    coarse : ndarray
        What is added to S g on every block, over φ.
    block : int
    preconditioned : ndarray, shape (nx, ny)
        S g on the free set; replaced by z.
    direction : ndarray, shape (nx, ny)
        The step to the last trial.
    momentum, step : float
    added : ndarray, shape of `coarse`
        Filled with what the clipping adds to the load of each block.

    Returns
    -------
    tuple of float
        Sum of the trial, sum of φ where it is positive, and the sum that was clipped.
    """
    nx, ny = pressure.shape
    number = pressure.dtype.type
    zero, one = number(0), number(1)
    correction = np.empty(ny, pressure.dtype)
    columns = np.zeros(ny, pressure.dtype)
    total = 0.0
    total_weight = 0.0
    clipped = 0.0
    for i in range(nx):
        if i % block == 0:
            spread(coarse[i // block], block, correction)
        row_total = zero
        row_weight = zero
        row_clipped = zero
        for j in range(ny):
            share = weight[i, j]
            free = one if share > zero else zero
            value = preconditioned[i, j] + share * correction[j]
            preconditioned[i, j] = value
            towards = free * (momentum * direction[i, j] - value) - (one - free) * pressure[i, j] / step
            direction[i, j] = towards
            trial = pressure[i, j] + step * towards
            positive = free if trial > zero else zero
            kept = positive * trial
            row_total += kept
            row_clipped -= (one - positive) * trial
            row_weight += positive * share
            columns[j] += kept - free * trial - (one - free) * pressure[i, j]
        total += row_total
        total_weight += row_weight
        clipped += row_clipped
        if (i + 1) % block == 0 or i + 1 == nx:
            collect(columns, block, added[i // block])
            columns[:] = 0
    return total, total_weight, clipped


@compiled
def project(pressure, gap, weight, direction, step, lifts, block, level):
    """Turn the direction into the step from p to the projected trial, its load restored by the blocks' lift · φ.

    Returns
    -------
    tuple of float
        Σ g · step with g above `level`, and the sum of the projected trial.
    """
    nx, ny = pressure.shape
    number = pressure.dtype.type
    zero = number(0)
    lift = np.empty(ny, pressure.dtype)
    slope = 0.0
    total = 0.0
    for i in range(nx):
        if i % block == 0:
            spread(lifts[i // block], block, lift)
        row_slope = zero
        row_total = zero
        for j in range(ny):
            trial = pressure[i, j] + step * direction[i, j]
            trial = trial + lift[j] * weight[i, j] if trial > zero else zero
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
        row_slope = pressure.dtype.type(0)
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
    least = pressure.dtype.type(0)
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
        Number of points that carry pressure in the trial, and Σ of their gaps. What the trial clipped is about to
        leave the contact: its gaps would lift the contact level.
    """
    nx, ny = pressure.shape
    number = pressure.dtype.type
    zero, one = number(0), number(1)
    count = 0.0
    gap_total = 0.0
    for i in range(nx):
        row_count = zero
        row_gap = zero
        for j in range(ny):
            value = pressure[i, j] + factor * move[i, j]
            opening = gap[i, j] + factor * displacement[i, j]
            carries = one if pressure[i, j] + move[i, j] > zero else zero
            pressure[i, j] = value if value > zero else zero
            gap[i, j] = opening
            row_count += carries
            row_gap += carries * opening
        count += row_count
        gap_total += row_gap
    return count, gap_total


@compiled
def clipped(values, shift, out):
    """Fill `out` with max(0, values + shift); return its sum and the number of its positive points."""
    nx, ny = values.shape
    number = values.dtype.type
    zero, one = number(0), number(1)
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
