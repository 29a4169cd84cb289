"""From element quantities to the body's vectors and matrices, through index maps that are made once.

Newton's method assembles one mesh many times. Where each element entry goes in the sparse matrix never changes, so
it is looked up once; afterwards a matrix costs one pass of additions and no sorting.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

FloatArray = NDArray[np.float64]
IndexArray = NDArray[np.intp]


class Assembly:
    """Scatter of the degrees of freedom 2 node + component of four-node elements.

    Parameters
    ----------
    cells : ndarray, shape (m, 4)
        Node numbers of the elements.
    nodes : int
        Number of nodes n.
    """

    def __init__(self, cells: IndexArray, nodes: int) -> None:
        self.size = 2 * nodes
        self._element_dofs = np.stack([2 * cells.T, 2 * cells.T + 1], axis=1)  # (4, 2, m)

    def vector(self, element_forces: FloatArray) -> FloatArray:
        """Sum of element vectors.

        Parameters
        ----------
        element_forces : ndarray, shape (4, 2, m)

        Returns
        -------
        ndarray, shape (2n,)
        """
        sums: FloatArray = np.bincount(self._element_dofs.ravel(), element_forces.ravel(), self.size).astype(
            float
        )
        return sums

    def matrix(self, element_matrices: FloatArray) -> csr_matrix:
        """Sum of element matrices.

        Parameters
        ----------
        element_matrices : ndarray, shape (4, 2, 4, 2, m)

        Returns
        -------
        csr_matrix, shape (2n, 2n)
            With sorted indices; every matrix of one mesh has the same pattern.
        """
        place, indices, starts = self._pattern
        data = np.bincount(place, element_matrices.ravel(), indices.size)
        return csr_matrix((data, indices, starts), shape=(self.size, self.size))

    @cached_property
    def _pattern(self) -> tuple[IndexArray, NDArray[np.int32], NDArray[np.int32]]:
        """Place of every element entry among the matrix's, their columns, and the starts of the rows."""
        dofs = self._element_dofs.astype(np.int64)
        key = (dofs[:, :, None, None] * self.size + dofs[None, None]).ravel()
        entries, place = np.unique(key, return_inverse=True)
        starts = np.searchsorted(entries, np.arange(self.size + 1) * self.size)
        return place, (entries % self.size).astype(np.int32), starts.astype(np.int32)
