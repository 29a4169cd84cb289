"""The long-wave half of the preconditioner: patches of contact coupled through the half-space, block by block.

Let S_F be the stencil on the free set and φ = S_F 1. A gap g that varies slowly is undone, patch by patch, by the
pressure φ c with c = g. That takes every patch as alone. Together they press block by block with the loads s c,
s = Σφ, which the half-space answers with the displacement K s c of the blocks, so that y / s = c + K s c is to be
solved for c, with y = Σφ(g - δ). On v = √s c that is the symmetric

    (1 + √s K √s) v = y / √s,

of which a few conjugate gradients are enough: what they leave, the outer iteration sees. They are preconditioned by
the same with the mean of φ in the place of every s / (block's points), which transforms diagonalise. The stencil's
φ y / s has then to be corrected by φ (c - y / s).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver.kernels import half_phases, love_spectrum, phases
from softlub.contact.solver.transforms import QUICK, RealTransform

BLOCK = 8
"""Points along a side of a block."""
STEPS = 3
"""Conjugate gradients on the blocks; more save no outer iteration."""
SHORTEST = np.pi * np.sqrt(2)
"""Phase of the shortest wave."""


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

    Attributes
    ----------
    sums : ndarray, shape (2, rows of blocks, columns of blocks)
        Σ φ and Σ φ g over each block, for `free_set.weigh` to fill.
    """

    def __init__(self, shape: tuple[int, int], periodic: bool, dtype: Any) -> None:
        self.shape = (-(-shape[0] // BLOCK), -(-shape[1] // BLOCK))
        self._points = shape[0] * shape[1]
        self.sums: NDArray[Any] = np.zeros((2, *self.shape), dtype)
        self._weight_sums, self._gap_sums = self.sums
        copies = 1 if periodic else 2
        padded = (copies * self.shape[0], copies * self.shape[1])
        self._transform = RealTransform(padded, dtype, QUICK)
        self._norm = self._gap_sums.dtype.type(1 / (padded[0] * padded[1]))
        phase = np.hypot(phases(padded[0])[:, None], half_phases(padded[1])[None, :])
        self._phase = (phase / BLOCK).astype(dtype)
        self._compliance = self._of_blocks(phase, periodic).astype(dtype)

    def _of_blocks(self, phase: NDArray[np.float64], periodic: bool) -> NDArray[np.float64]:
        """Displacement of the blocks under loads of one each, wave by wave.

        What a block does to itself the stencil knows already: the least of all factors is taken from each.
        """
        if periodic:
            compliance = np.divide(1, phase, out=np.zeros_like(phase), where=phase > 0)
        else:
            compliance = love_spectrum(self.shape)
        return np.maximum(compliance - 1 / SHORTEST, 0) / BLOCK

    def mean_gap(self) -> float:
        """Mean of the gap over the free set, weighted with φ."""
        return float(self._gap_sums.sum(dtype=float) / self._weight_sums.sum(dtype=float))

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
        weight = self._weight_sums
        root, inverse = self._roots()
        alone = inverse * (self._gap_sums - weight.dtype.type(mean) * weight)
        added = inverse * (self._coupled(root, alone) - alone)
        load = float((weight * added).sum(dtype=float))
        added -= weight.dtype.type(load / float(weight.sum(dtype=float)) + mean)
        product = float((self._gap_sums * added).sum(dtype=float))
        return added, mean, product

    def lift(self, added: NDArray[Any]) -> tuple[NDArray[Any], float]:
        """The answer to a load that a projection has added to every block.

        The longest waves of it would displace the surface by far the most, the more so the larger the grid.

        Returns
        -------
        lift : ndarray, shape of the blocks
            The c of a pressure φ c that undoes what the added load displaces.
        load : float
            Sum of φ c.
        """
        root, inverse = self._roots()
        displaced = root * self._filtered(added, self._compliance)
        lift = -inverse * self._coupled(root, displaced)
        return lift, float((lift * self._weight_sums).sum(dtype=float))

    def _roots(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """√s of every block and its inverse, 0 where nothing is free."""
        root = np.sqrt(np.maximum(self._weight_sums, 0))
        return root, np.divide(1, root, out=np.zeros_like(root), where=root > 0)

    def _coupled(self, root: NDArray[Any], alone: NDArray[Any]) -> NDArray[Any]:
        """Solve (1 + √s K √s) v = y / √s to within a few steps of conjugate gradients."""
        number = alone.dtype.type
        mean_weight = float(self._weight_sums.sum(dtype=float)) / self._points
        together = self._phase / (self._phase + number(mean_weight))  # 1 / (1 + λ) with λ = k / Q
        solved, direction, rest = np.zeros_like(alone), np.zeros_like(alone), alone.copy()
        last = 1.0
        for _ in range(STEPS):
            smooth = self._filtered(rest, together)
            product = float(np.vdot(rest, smooth))
            if product <= 0:  # nothing to correct
                break
            direction *= number(product / last)
            direction += smooth
            image = direction + root * self._filtered(root * direction, self._compliance)
            factor = number(product / float(np.vdot(direction, image)))
            solved += factor * direction
            rest -= factor * image
            last = product
        return solved

    def _filtered(self, values: NDArray[Any], factors: NDArray[Any]) -> NDArray[Any]:
        rows, columns = self.shape
        self._transform.source[:rows, :columns] = values
        self._transform.forward()
        self._transform.spectrum *= factors
        self._transform.inverse()
        return np.asarray(self._transform.result[:rows, :columns] * self._norm)
