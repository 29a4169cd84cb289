"""Static condensation: the stiffness that a body's kept degrees of freedom feel (equations 5-2 and 5-3).

With the interior i free of force the kept ones k meet S = K_kk - K_ki K_ii⁻¹ K_ik, Guyan's reduction of a static
system. The interior is eliminated front by front in the order of a nested dissection (the multifrontal method): a
front gathers the matrix's entries and its children's remainders in a dense block, eliminates its own variables by
LU with partial pivoting, and hands on what that leaves on the others. What is left on the kept ones is S; no factor
is stored. The trailing block of one sparse LU with the kept ones last (SuperLU, interior in minimum degree) takes two
to ten times as long for the same accuracy: it also factorises the dense block that is wanted, to multiply it again.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import sparse
from scipy.linalg import lapack

from softlub.protocols import FloatArray
from softlub.solid.dissection import IntArray, nested_dissection

SINGULAR = 1e-15
"""Reciprocal condition of a front, in the 1-norm, below which it counts as singular."""


class SingularInteriorError(ValueError):
    """The interior can move without force: the kept degrees of freedom do not hold it."""


class _Remainder(NamedTuple):
    """What an eliminated front leaves to those above it."""

    variables: IntArray
    matrix: FloatArray


def condense(matrix: sparse.sparray | sparse.spmatrix, kept: ArrayLike) -> FloatArray:
    """Schur complement of a sparse matrix on the kept degrees of freedom.

    Parameters
    ----------
    matrix : sparse array, shape (n, n)
        Tangent stiffness [N/m²] of the free degrees of freedom; it need not be symmetric.
    kept : array_like of int, shape (k,)
        Degrees of freedom to keep, in the order wanted.

    Returns
    -------
    ndarray, shape (k, k)
        S, so that S u_k is the force on the kept ones while the others carry none [N/m²].

    Raises
    ------
    ValueError
        If the matrix is not square or not finite, or a kept index is outside it or given twice.
    SingularInteriorError
        If the interior can move with the kept degrees of freedom held.

    Notes
    -----
    Equation 5-3 of the source, where a finite-element program's substructures do it.
    """
    rows = sparse.csr_array(matrix, dtype=float)
    keep = _checked(rows, kept)
    interior = np.ones(rows.shape[0], dtype=bool)
    interior[keep] = False
    inner = np.flatnonzero(interior)
    fronts = nested_dissection(sparse.csr_array(rows[inner][:, inner]))
    order = np.concatenate([*(inner[front.variables] for front in fronts), keep])
    assembly = _Assembly(sparse.csr_array(rows[order][:, order]))
    remainders: dict[int, _Remainder] = {}
    begin = 0
    for number, front in enumerate(fronts):
        children = [remainders.pop(child) for child in front.children]
        end = begin + front.variables.size
        remainders[number] = assembly.eliminate(begin, end, children, order)
        begin = end
    return assembly.gather(begin, order.size, list(remainders.values())).matrix


def _checked(matrix: sparse.csr_array, kept: ArrayLike) -> IntArray:
    """The kept indices, after all checks."""
    if matrix.shape[0] != matrix.shape[1]:
        raise ValueError(
            f"a matrix of {matrix.shape[0]} by {matrix.shape[1]} cannot be condensed: it must be square"
        )
    if not np.all(np.isfinite(matrix.data)):
        raise ValueError(
            "the matrix to condense holds NaN or infinite entries: check the state it was taken at"
        )
    indices = np.asarray(kept)
    if indices.ndim != 1 or (indices.size and not np.issubdtype(indices.dtype, np.integer)):
        raise ValueError(
            f"kept must be a list of whole numbers, not {indices.dtype} of shape {indices.shape}"
        )
    outside = indices[(indices < 0) | (indices >= matrix.shape[0])]
    if outside.size:
        raise ValueError(
            f"kept index {outside[0]} lies outside the matrix: allowed are 0 to {matrix.shape[0] - 1}"
        )
    values, counts = np.unique(indices, return_counts=True)
    if np.any(counts > 1):
        raise ValueError(f"kept index {values[counts > 1][0]} is given more than once: keep each only once")
    return indices.astype(np.int64)


class _Assembly:
    """Dense blocks out of the matrix in the order of elimination."""

    def __init__(self, ordered: sparse.csr_array) -> None:
        self.rows = ordered
        self.columns = ordered.tocsc()
        self.place = np.zeros(ordered.shape[0], dtype=np.int64)

    def gather(self, begin: int, end: int, children: list[_Remainder]) -> _Remainder:
        """Rows and columns begin…end-1 of what is left of the matrix, on those and on all later ones they meet."""
        columns, row, entries = _slice(self.rows, begin, end)
        rows, column, mirrored = _slice(self.columns, begin, end)
        later = columns >= end, rows >= end
        met = [child.variables for child in children]
        beyond = np.unique(np.concatenate([columns[later[0]], rows[later[1]], *met]))
        variables = np.concatenate([np.arange(begin, end), beyond[beyond >= end]])
        place = self.place
        place[variables] = np.arange(variables.size)
        block = np.zeros((variables.size, variables.size), order="F")
        ahead = columns >= begin
        block[row[ahead], place[columns[ahead]]] = entries[ahead]
        block[place[rows[later[1]]], column[later[1]]] = mirrored[later[1]]
        for child in children:
            at = place[child.variables]
            block[np.ix_(at, at)] += child.matrix
        return _Remainder(variables, block)

    def eliminate(self, begin: int, end: int, children: list[_Remainder], order: IntArray) -> _Remainder:
        """Take the variables begin…end-1 out; the remainder lies on those that they meet."""
        variables, block = self.gather(begin, end, children)
        own = end - begin
        norm = lapack.dlange("1", block[:own, :own])
        factors, pivots, failed = lapack.dgetrf(block[:own, :own])
        condition = 0.0 if failed else lapack.dgecon(factors, norm)[0]
        if not condition > SINGULAR:
            loose = order[begin + int(np.argmin(np.abs(factors.diagonal())))]
            raise SingularInteriorError(
                f"the interior is singular at degree of freedom {loose} (reciprocal condition {condition:.1e}): it "
                "can move while the kept ones are held; hold it, or keep more"
            )
        response, _ = lapack.dgetrs(factors, pivots, block[:own, own:])
        remainder = block[own:, own:]
        remainder -= block[own:, :own] @ response
        return _Remainder(variables[own:], remainder)


def _slice(
    matrix: sparse.csr_array | sparse.csc_array, begin: int, end: int
) -> tuple[NDArray[np.integer], IntArray, FloatArray]:
    """Minor indices, major indices from 0 and entries of the major lines begin…end-1."""
    pointers = matrix.indptr[begin : end + 1]
    span = slice(pointers[0], pointers[-1])
    return matrix.indices[span], np.repeat(np.arange(end - begin), np.diff(pointers)), matrix.data[span]
