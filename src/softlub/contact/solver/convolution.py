"""Convolution with a transfer function, whose columns are transformed, multiplied and transformed back in the cache.

A transform in two dimensions runs along the rows, then along the columns. Those of the half spectrum lie a row apart
in memory: here a few of them at a time are laid side by side, where both transforms along them and the factor
between cost no traffic to memory, and far less time to plan.
"""

# mypy: disable-error-code="no-untyped-def"

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pyfftw
from numpy.typing import NDArray

from softlub.contact.solver.compiled import compiled
from softlub.contact.solver.transforms import SPECTRUM_TYPES, planning_effort

ROWS = 32
"""Rows of one call of the row plans, where they divide the grid; plans for few are quickly measured."""
COLUMNS = 32
"""Columns side by side."""
SPARE = 8
"""Numbers between one column and the next, lest all fall on the same lines of the cache."""
BAD_WIDTH = 256
"""A spectrum should not be a multiple of this many columns wide, for the same reason."""

ColumnPass = Callable[[NDArray[Any], slice], float]
"""Multiplies columns in place, given as real numbers, shape (COLUMNS, 2 (nx + SPARE)): real and imaginary parts in
turn, the last `SPARE` pairs without meaning. The slice says which of the half spectrum they are; some beyond its end
are zero. Returns something to be summed up."""


class Convolution:
    """Convolution of one shape and precision, on fixed arrays.

    Parameters
    ----------
    shape : tuple of int
        Shape (nx, ny) of the real arrays.
    dtype : dtype-like
        float32 or float64.
    effort : str, optional
        As of `RealTransform`.

    Attributes
    ----------
    source, result : ndarray, shape (nx, ny)
        Input and output.
    columns : int
        Columns of the half spectrum, ny // 2 + 1, and of what fills up the last pass.
    """

    def __init__(self, shape: tuple[int, int], dtype: Any, effort: str | None = None) -> None:
        nx, ny = shape
        kind = SPECTRUM_TYPES[np.dtype(dtype)]
        half = ny // 2 + 1
        self.columns = -(-half // COLUMNS) * COLUMNS
        width = self.columns + (COLUMNS if self.columns % BAD_WIDTH == 0 else 0)
        self.source: NDArray[Any] = pyfftw.zeros_aligned(shape, dtype=dtype)
        self.result: NDArray[Any] = pyfftw.zeros_aligned(shape, dtype=dtype)
        self._spectrum: NDArray[Any] = pyfftw.zeros_aligned((nx, width), dtype=kind)
        self._waves = self._spectrum[:, :half]
        self._gathered: NDArray[Any] = pyfftw.zeros_aligned((COLUMNS, nx + SPARE), dtype=kind)
        self._transformed: NDArray[Any] = pyfftw.zeros_aligned((COLUMNS, nx + SPARE), dtype=kind)
        self._numbers = self._transformed.view(dtype)
        self._rows = ROWS if nx % ROWS == 0 else nx
        effort = effort or planning_effort(shape, dtype)
        rows, waves = self.result[: self._rows], self._waves[: self._rows]
        here, there = self._gathered[:, :nx], self._transformed[:, :nx]
        self._rows_forward = pyfftw.FFTW(rows, waves, axes=(1,), flags=(effort,))
        self._rows_back = pyfftw.FFTW(waves, rows, axes=(1,), direction="FFTW_BACKWARD", flags=(effort,))
        self._columns_forward = pyfftw.FFTW(here, there, axes=(1,), flags=(effort,))
        self._columns_back = pyfftw.FFTW(there, here, axes=(1,), direction="FFTW_BACKWARD", flags=(effort,))
        # measuring plans leaves rubbish behind
        for array in (self.result, self._spectrum, self._gathered, self._transformed):
            array[:] = 0

    def renew(self) -> None:
        """Take new real arrays; the old ones belong to whoever holds them."""
        self.source = pyfftw.empty_aligned(self.source.shape, dtype=self.source.dtype)
        self.result = pyfftw.empty_aligned(self.result.shape, dtype=self.result.dtype)

    def convolve(self, multiply: ColumnPass) -> float:
        """Fill `result` from `source`, without the factor 1 / (nx ny); return the sum of what the passes return."""
        for begin in range(0, len(self.source), self._rows):
            rows = slice(begin, begin + self._rows)
            self._rows_forward.update_arrays(self.source[rows], self._waves[rows])
            self._rows_forward.execute()
        total = 0.0
        for first in range(0, self.columns, COLUMNS):
            gather(self._spectrum, first, self._gathered)
            self._columns_forward.execute()
            total += multiply(self._numbers, slice(first, first + COLUMNS))
            self._columns_back.execute()
            scatter(self._gathered, first, self._spectrum)
        for begin in range(0, len(self.result), self._rows):
            rows = slice(begin, begin + self._rows)
            self._rows_back.update_arrays(self._waves[rows], self.result[rows])
            self._rows_back.execute()
        return total


@compiled
def gather(spectrum, first, columns):
    """Lay columns of the spectrum side by side, eight rows at a time: as many as a line of the cache takes."""
    nx = spectrum.shape[0]
    for begin in range(0, nx, 8):
        end = min(begin + 8, nx)
        for j in range(columns.shape[0]):
            for i in range(begin, end):
                columns[j, i] = spectrum[i, first + j]


@compiled
def scatter(columns, first, spectrum):
    """Bring them back."""
    nx = spectrum.shape[0]
    for begin in range(0, nx, 8):
        end = min(begin + 8, nx)
        for i in range(begin, end):
            for j in range(columns.shape[0]):
                spectrum[i, first + j] = columns[j, i]
