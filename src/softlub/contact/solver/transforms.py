"""Real two-dimensional Fourier transforms with planned buffers.

A transform owns the two real arrays and the spectrum that its plans were made for, so that no pass copies into
or out of FFTW's memory. One convolution is one forward and one inverse transform.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pyfftw
from numpy.typing import NDArray

SPECTRUM_TYPES = {np.dtype(np.float32): np.complex64, np.dtype(np.float64): np.complex128}
MEASURED_POINTS = 128 * 128
"""From this many points on the time spent on measuring plans is repaid by some loads, in single precision.

Double precision judges each load with a transform or two, which would not repay it.
"""
QUICK, MEASURED = "FFTW_ESTIMATE", "FFTW_MEASURE"
"""How plans are made; a measured plan takes some tenths of a second, and a third off large transforms."""


def planning_effort(shape: tuple[int, int], dtype: Any) -> str:
    """FFTW's flag for the time to spend on plans of a shape and precision."""
    measured = np.dtype(dtype) == np.float32 and shape[0] * shape[1] >= MEASURED_POINTS
    return MEASURED if measured else QUICK


class RealTransform:
    """Forward and inverse transform of one shape and precision, on fixed arrays.

    Parameters
    ----------
    shape : tuple of int
        Shape (nx, ny) of the real arrays.
    dtype : dtype-like
        float32 or float64.
    effort : str, optional
        `QUICK` or `MEASURED`; by default as `planning_effort` says.

    Attributes
    ----------
    source, result : ndarray, shape (nx, ny)
        Input of `forward` and output of `inverse`.
    spectrum : ndarray, shape (nx, ny // 2 + 1)
        Output of `forward` and input of `inverse`, which destroys it.
    """

    def __init__(self, shape: tuple[int, int], dtype: Any, effort: str | None = None) -> None:
        half = (shape[0], shape[1] // 2 + 1)
        self.source: NDArray[Any] = pyfftw.zeros_aligned(shape, dtype=dtype)
        self.result: NDArray[Any] = pyfftw.zeros_aligned(shape, dtype=dtype)
        self.spectrum: NDArray[Any] = pyfftw.zeros_aligned(half, dtype=SPECTRUM_TYPES[np.dtype(dtype)])
        effort = effort or planning_effort(shape, dtype)
        self._forward = pyfftw.FFTW(self.source, self.spectrum, axes=(0, 1), flags=(effort,))
        self._inverse = pyfftw.FFTW(
            self.spectrum, self.result, axes=(0, 1), direction="FFTW_BACKWARD", flags=(effort,)
        )
        # measuring plans leaves rubbish behind
        self.source[:] = 0
        self.result[:] = 0

    def renew(self) -> None:
        """Take new real arrays; the old ones belong to whoever holds them."""
        self.source = pyfftw.empty_aligned(self.source.shape, dtype=self.source.dtype)
        self.result = pyfftw.empty_aligned(self.result.shape, dtype=self.result.dtype)
        self._forward.update_arrays(self.source, self.spectrum)
        self._inverse.update_arrays(self.spectrum, self.result)

    def forward(self) -> None:
        """Transform `source` into `spectrum`."""
        self._forward.execute()

    def inverse(self) -> None:
        """Transform `spectrum` into `result`, without the factor 1 / (nx ny)."""
        self._inverse.execute()
