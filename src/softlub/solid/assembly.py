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
        self._cells = cells.T.astype(np.int64)
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
        """Place of every element entry among the matrix's, their columns, and the starts of the rows.

        Found for pairs of nodes first, each of which is a block of two rows and two columns.
        """
        nodes = self.size // 2
        pairs, block = np.unique(self._cells[:, None] * nodes + self._cells[None], return_inverse=True)
        row, column = np.divmod(pairs, nodes)
        starts = np.searchsorted(row, np.arange(nodes + 1))
        count = np.diff(starts)[row]
        within = np.arange(pairs.size) - starts[row]
        component = np.arange(2)
        # Four entries for every pair of the rows above, then those of this row's first component.
        corner = 4 * starts[row] + 2 * within
        places = corner[:, None, None] + 2 * count[:, None, None] * component[:, None] + component
        indices = np.empty(4 * pairs.size, dtype=np.int32)
        indices[places] = 2 * column[:, None, None] + component
        row_starts = 4 * starts[:-1, None] + 2 * np.diff(starts)[:, None] * component
        element_places = places[block.reshape(4, 4, -1)].transpose(0, 3, 1, 4, 2).ravel()
        return element_places, indices, np.append(row_starts.ravel(), indices.size).astype(np.int32)
