"""Displacement of the half-space by summing the influence of every point on every other: the slow reference.

The source's equation 4-25, against which its figure 4-9 holds the transforms. N⁴ operations on N x N points.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver.compiled import compiled
from softlub.contact.solver.kernels import love_rectangle


class SummedCompliance:
    """Love's rectangles on an unloaded surrounding, summed directly; a `Compliance` in double precision.

    Parameters
    ----------
    shape : tuple of int
        Points (nx, ny) that may carry pressure.
    """

    def __init__(self, shape: tuple[int, int]) -> None:
        self.count = 0
        self.source: NDArray[np.float64] = np.zeros(shape)
        self.result: NDArray[np.float64] = np.zeros(shape)
        x, y = (np.arange(points, dtype=float) for points in shape)
        self._influence = love_rectangle(x[:, None], y[None, :])

    def apply(self) -> float:
        """Fill `result` from `source`; return the sum over the grid of source times result."""
        self.count += 1
        sum_influences(self.source, self._influence, self.result)
        return float(np.vdot(self.source, self.result))

    def renew(self) -> None:
        """Take new arrays for `source` and `result`; the old ones belong to whoever holds them."""
        self.source, self.result = np.empty_like(self.source), np.empty_like(self.result)


@compiled
def sum_influences(source, influence, result):  # type: ignore[no-untyped-def]
    """Add up influence[|i - k|, |j - l|] · source[k, l] over all loaded points."""
    nx, ny = source.shape
    result[:] = 0
    for k in range(nx):
        for m in range(ny):
            value = source[k, m]
            if value == 0:
                continue
            for i in range(nx):
                row = influence[abs(i - k)]
                for j in range(m):
                    result[i, j] += value * row[m - j]
                for j in range(m, ny):
                    result[i, j] += value * row[j - m]
