"""The linear equations of a body's free degrees of freedom, factorised over and over with one pattern.

Which entries of the full matrix are kept, and in which order they are eliminated, is found once: the first
factorisation orders the unknowns by minimum degree of A + Aᵀ, the next ones take them in that order. Pivots stay on
the diagonal: the matrix of a body with stiff contact springs is dominated by its symmetric part.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_matrix, csr_matrix
from scipy.sparse.linalg import SuperLU, splu

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


ACCURATE = 1e-10
"""Part of the right-hand side that a solution may miss."""
MOST_REFINEMENTS = 3


class SingularStiffness(RuntimeError):
    """The stiffness cannot be factorised, or its solution is not finite."""


class FreeSystem:
    """Solver of K[free, free] x = b for matrices of one pattern.

    Parameters
    ----------
    pattern : csr_matrix, shape (2n, 2n)
        Any matrix of the pattern, its indices sorted.
    free : ndarray of int, shape (f,)
        Degrees of freedom to solve for.
    """

    def __init__(self, pattern: csr_matrix, free: IntArray) -> None:
        self.free = free
        self._pattern = pattern
        self._order = np.arange(free.size)
        self._ordered = False
        self._number()

    def entries(self, rows: IntArray, columns: IntArray) -> IntArray:
        """Places among the full matrix's data of some of its entries.

        Parameters
        ----------
        rows, columns : ndarray of int, shape (j,)
            Entries that the pattern has.

        Returns
        -------
        ndarray of int, shape (j,)
        """
        indices, starts = self._pattern.indices, self._pattern.indptr
        return np.array(
            [
                starts[row] + np.searchsorted(indices[starts[row] : starts[row + 1]], column)
                for row, column in zip(rows, columns, strict=True)
            ]
        )

    def factorise(self, data: FloatArray) -> Factorisation:
        """Factorise the matrix that has these entries.

        Parameters
        ----------
        data : ndarray, shape (nnz,)
            Of the full matrix in the pattern's order [N/m²].

        Returns
        -------
        Factorisation

        Raises
        ------
        SingularStiffness
        """
        if not np.all(np.isfinite(data)):
            raise SingularStiffness("the stiffness has entries that are not finite")
        rule = "NATURAL" if self._ordered else "MMD_AT_PLUS_A"
        matrix = csc_matrix((data[self._kept], self._rows, self._starts), shape=(self.free.size,) * 2)
        try:
            factors = splu(matrix, permc_spec=rule, diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        except RuntimeError as error:
            raise SingularStiffness(f"the stiffness is singular ({error})") from error
        result = Factorisation(factors, matrix, self._order)
        if not self._ordered:
            self._order = np.argsort(factors.perm_c)
            self._ordered = True
            self._number()
        return result

    def _number(self) -> None:
        """Where the entries of the block, its unknowns in order, stand in the full matrix."""
        full = self._pattern
        places = csr_matrix((np.arange(1, full.nnz + 1), full.indices, full.indptr), shape=full.shape)
        chosen = self.free[self._order]
        block = places[chosen][:, chosen].tocsc()
        block.sort_indices()
        self._kept = block.data - 1
        self._rows, self._starts = block.indices, block.indptr


class Factorisation:
    """Factors of one matrix, and the matrix itself: without pivoting, a solution may need to be refined."""

    def __init__(self, factors: SuperLU, matrix: csc_matrix, order: IntArray) -> None:
        self._factors = factors
        self._matrix = matrix
        self._order = order

    def solve(self, right: FloatArray) -> FloatArray:
        """Solution for one or several right-hand sides.

        Parameters
        ----------
        right : ndarray, shape (f,) or (f, s)

        Returns
        -------
        ndarray
            Of the same shape.

        Raises
        ------
        SingularStiffness
            If the solution is not finite.
        """
        wanted = np.ascontiguousarray(right[self._order])
        ordered = self._factors.solve(wanted)
        for _ in range(MOST_REFINEMENTS):
            if not np.all(np.isfinite(ordered)):
                raise SingularStiffness("the stiffness is singular (its solution is not finite)")
            missing = wanted - self._matrix @ ordered
            if np.abs(missing).max() <= ACCURATE * np.abs(wanted).max():
                break
            ordered += self._factors.solve(missing)
        solution = np.empty_like(right)
        solution[self._order] = ordered
        return solution
