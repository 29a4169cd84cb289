"""Loops that compile in no time where array expressions would each bring their own machinery along."""

from __future__ import annotations

from numba import njit

from softlub.lubrication.solvers.spectral.basis import FloatArray


@njit(cache=True, fastmath={"contract", "reassoc", "nsz"})
def inner(a: FloatArray, b: FloatArray) -> float:
    """Scalar product."""
    total = 0.0
    for i in range(a.size):
        total += a[i] * b[i]
    return total


@njit(cache=True)
def copy_into(target: FloatArray, source: FloatArray) -> None:
    """Copy values into an array of the same length."""
    for i in range(target.size):
        target[i] = source[i]


@njit(cache=True)
def fill(target: FloatArray, value: float) -> None:
    """Set all values of a vector."""
    for i in range(target.size):
        target[i] = value


@njit(cache=True)
def reverse(values: FloatArray, start: int, stop: int) -> None:
    """Turn round the order of values[start:stop] in place."""
    low, high = start, stop - 1
    while low < high:
        kept = values[low]
        values[low] = values[high]
        values[high] = kept
        low += 1
        high -= 1


@njit(cache=True)
def lowest(values: FloatArray) -> int:
    """Index of the smallest value."""
    best = 0
    for i in range(values.size):
        if values[i] < values[best]:
            best = i
    return best
