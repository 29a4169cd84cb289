"""The long-wave half of the preconditioner: patches of contact coupled through the half-space, block by block.

Let S_F be the stencil on the free set and φ = S_F 1. A gap g that varies slowly is undone, patch by patch, by the
pressure φ c with c = g. That takes every patch as alone. Together they press with k c on average (k = Σφ/N² the
mean of φ over all points), which the half-space answers with k c / Q at the phase Q, so that g = (1 + λ) c with
λ = k / Q. Hence c = g / (1 + λ), and the stencil's φ g has to be reduced by φ T g, T = λ / (1 + λ). On blocks,
with s = Σφ and y = Σφ(g - δ), the symmetric form is -w IFFT(T FFT(w y)), w = s^(-1/2).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver.kernels import half_phases, phases
from softlub.contact.solver.transforms import RealTransform

BLOCK = 8
"""Points along a side of a block."""


class CoarseCorrection:
    """Correction of the stencil on blocks of points.

    Parameters
    ----------
    shape : tuple of int
        Points (nx, ny) of the grid.
    periodic : bool
        Whether patches also act across the edges; else the blocks are padded with as many empty ones.
    dtype : dtype-like
        Precision of the arrays.
    """

    def __init__(self, shape: tuple[int, int], periodic: bool, dtype: Any) -> None:
        self.shape = (-(-shape[0] // BLOCK), -(-shape[1] // BLOCK))
        self._points = shape[0] * shape[1]
        self.gap_sums: NDArray[Any] = np.zeros(self.shape, dtype)
        self.weight_sums: NDArray[Any] = np.zeros(self.shape, dtype)
        copies = 1 if periodic else 2
        padded = (copies * self.shape[0], copies * self.shape[1])
        self._transform = RealTransform(padded, dtype)
        self._norm = 1 / (padded[0] * padded[1])
        self._phase = np.hypot(phases(padded[0])[:, None], half_phases(padded[1])[None, :]) / BLOCK

    def mean_gap(self) -> float:
        """Mean of the gap over the free set, weighted with φ."""
        return float(self.gap_sums.sum(dtype=float) / self.weight_sums.sum(dtype=float))

    def correction(self) -> tuple[NDArray[Any], float, float]:
        """What to add to S_F g on every block, over φ, so that z carries no net load.

        Returns
        -------
        correction : ndarray, shape of the blocks
            The coarse correction, less δ (S_F acts on the gap above δ) and a constant that clears the load.
        mean : float
            δ, the mean of the gap over the free set, weighted with φ.
        product : float
            Sum of the gap times what is added.
        """
        mean = self.mean_gap()
        weight = np.maximum(self.weight_sums, 0)
        root = np.where(weight > 0, 1 / np.sqrt(np.where(weight > 0, weight, 1)), 0)
        total = float(weight.sum(dtype=float))
        rows, columns = self.shape
        self._transform.source[:rows, :columns] = root * (self.gap_sums - mean * self.weight_sums)
        self._transform.forward()
        # λ / (1 + λ) with λ = k / Q; 1 for the mean
        mean_weight = total / self._points
        self._transform.spectrum *= self._norm * mean_weight / (mean_weight + self._phase)
        self._transform.inverse()
        added = -root * self._transform.result[:rows, :columns]
        added -= float((weight * added).sum(dtype=float)) / total + mean
        product = float((self.gap_sums * added).sum(dtype=float))
        return np.asarray(added.astype(weight.dtype)), mean, product
