"""The displacement of the half-space under a pressure, as one convolution: periodic or free at its edges."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver.compiled import compiled
from softlub.contact.solver.convolution import Convolution
from softlub.contact.solver.kernels import half_phases, love_spectrum, phases
from softlub.contact.solver.transforms import RealTransform


class Compliance(Protocol):
    """One convolution with the half-space's influence, on arrays that it owns."""

    source: NDArray[Any]
    """Pressure to convolve, shape (nx, ny)."""
    result: NDArray[Any]
    """Displacement, up to a constant where the surface is periodic, shape (nx, ny)."""
    count: int
    """Convolutions so far, each a pair of transforms."""

    def apply(self) -> float:
        """Fill `result` from `source`; return the sum over the grid of source times result."""
        ...

    def renew(self) -> None:
        """Take new arrays for `source` and `result`; the old ones belong to whoever holds them."""
        ...


class PeriodicCompliance:
    """Compliance 1 / |θ| of every wave of the period; the mean displacement is zero by convention, K(0) = 0.

    Parameters
    ----------
    shape : tuple of int
        Points (nx, ny) of one period.
    dtype : dtype-like
        float32 or float64.
    effort : str, optional
        As of `RealTransform`.
    """

    def __init__(self, shape: tuple[int, int], dtype: Any, effort: str | None = None) -> None:
        self._convolution = Convolution(shape, dtype, effort)
        self.count = 0
        self.source, self.result = self._convolution.source, self._convolution.result
        number = self.source.dtype.type
        columns = self._convolution.columns
        # real and imaginary parts of a number share its factors
        self._across_squared = np.repeat(phases(shape[0]) ** 2, 2).astype(dtype)
        self._along_squared = np.ones(columns, dtype)
        self._along_squared[: shape[1] // 2 + 1] = half_phases(shape[1]) ** 2
        self._weights = np.zeros(columns, dtype)
        self._weights[: shape[1] // 2 + 1] = conjugate_weights(shape[1])
        self._norm = number(1 / (shape[0] * shape[1]))
        # no wave but the mean has less
        self._least = number((2 * np.pi / max(shape)) ** 2 / 2)

    def apply(self) -> float:
        """Fill `result` from `source`; return the sum over the grid of source times result."""
        self.count += 1
        return self._convolution.convolve(self._divide)

    def _divide(self, numbers: NDArray[Any], columns: slice) -> float:
        if columns.start == 0:
            numbers[0, :2] = 0
        return float(
            divide_by_phase(
                numbers,
                self._along_squared[columns],
                self._across_squared,
                self._weights[columns],
                self._norm,
                self._least,
            )
        )

    def renew(self) -> None:
        """Take new arrays for `source` and `result`; the old ones belong to whoever holds them."""
        self._convolution.renew()
        self.source, self.result = self._convolution.source, self._convolution.result

    def stiffness_of_source(self) -> None:
        """Fill `result` with the pressure that displaces the surface by `source`: the factor |θ|."""
        self.count += 1
        self._convolution.convolve(self._multiply)

    def _multiply(self, numbers: NDArray[Any], columns: slice) -> float:
        multiply_by_phase(numbers, self._along_squared[columns], self._across_squared, self._norm)
        return 0.0


class FreeCompliance:
    """Love's rectangles on an unloaded surrounding, by zero padding to twice the size (DC-FFT).

    Parameters
    ----------
    shape : tuple of int
        Points (nx, ny) that may carry pressure.
    dtype : dtype-like
        float32 or float64.
    effort : str, optional
        As of `RealTransform`.
    """

    def __init__(self, shape: tuple[int, int], dtype: Any, effort: str | None = None) -> None:
        padded = (2 * shape[0], 2 * shape[1])
        self._transform = RealTransform(padded, dtype, effort)
        self.count = 0
        self.source: NDArray[Any] = np.zeros(shape, dtype)
        self.result: NDArray[Any] = np.zeros(shape, dtype)
        self._numbers = self._transform.spectrum.view(dtype)
        self._factors = np.repeat(love_spectrum(shape) / (padded[0] * padded[1]), 2, axis=1).astype(dtype)
        self._weights = np.repeat(conjugate_weights(padded[1]), 2).astype(dtype)

    def apply(self) -> float:
        """Fill `result` from `source`; return the sum over the grid of source times result."""
        nx, ny = self.source.shape
        self._transform.source[:nx, :ny] = self.source
        self.count += 1
        self._transform.forward()
        energy = multiply_by_table(self._numbers, self._factors, self._weights)
        self._transform.inverse()
        self.result[:] = self._transform.result[:nx, :ny]
        return energy

    def renew(self) -> None:
        """Take new arrays for `source` and `result`; the old ones belong to whoever holds them."""
        self.source, self.result = np.empty_like(self.source), np.empty_like(self.result)

    def stiffness_of_source(self) -> None:
        """Fill `result` with |θ| times `source`, the surrounding taken as zero: near the inverse of `apply`."""
        nx, ny = self.source.shape
        self.count += 1
        self._transform.source[:nx, :ny] = self.source
        self._transform.forward()
        dtype = self.source.dtype
        across = (phases(2 * nx) ** 2).astype(dtype)
        along = np.repeat(half_phases(2 * ny) ** 2, 2).astype(dtype)
        multiply_by_phase(self._numbers, across, along, dtype.type(1 / (4 * nx * ny)))
        self._transform.inverse()
        self.result[:] = self._transform.result[:nx, :ny]


def conjugate_weights(points: int) -> NDArray[np.float64]:
    """How often each column of a half spectrum stands in the whole one: 1 for the mean and Nyquist, else 2."""
    weights = np.full(points // 2 + 1, 2.0)
    weights[0] = 1
    if points % 2 == 0:
        weights[-1] = 1
    return weights


@compiled
def divide_by_phase(numbers, rows, columns, weights, norm, least):  # type: ignore[no-untyped-def]
    """Multiply rows of waves by 1 / |θ| in place; return the energy, the sum of their squares times that.

    `rows` and `columns` hold θ² along the first and the second axis; `least` takes the place of smaller |θ|².
    """
    energy = 0.0
    for i in range(rows.size):
        of_row = numbers.dtype.type(0)
        for j in range(columns.size):
            value = numbers[i, j]
            squared = rows[i] + columns[j]
            displacement = value * (norm / np.sqrt(squared if squared > least else least))
            of_row += value * displacement
            numbers[i, j] = displacement
        energy += weights[i] * of_row
    return energy


@compiled
def multiply_by_phase(numbers, rows, columns, norm):  # type: ignore[no-untyped-def]
    """Multiply rows of waves by |θ| in place."""
    for i in range(rows.size):
        for j in range(columns.size):
            numbers[i, j] *= norm * np.sqrt(rows[i] + columns[j])


@compiled
def multiply_by_table(numbers, factors, weights):  # type: ignore[no-untyped-def]
    """Multiply a half spectrum by a table in place; return the energy as `divide_by_phase` does."""
    energy = 0.0
    for i in range(numbers.shape[0]):
        of_row = numbers.dtype.type(0)
        for j in range(numbers.shape[1]):
            value = numbers[i, j]
            displacement = value * factors[i, j]
            of_row += weights[j] * value * displacement
            numbers[i, j] = displacement
        energy += of_row
    return energy
