"""Ways to condense a sparse stiffness: ours, the trailing block of one sparse LU, many right-hand sides."""

from collections.abc import Callable

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from softlub.solid.reduction import condense

Condensation = Callable[[sparse.csr_array, np.ndarray], np.ndarray]

BLOCK = 64
"""Right-hand sides solved together: all at once would fill the memory."""
SYMMETRIC = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}


def _interior(matrix: sparse.csr_array, kept: np.ndarray) -> np.ndarray:
    return np.setdiff1d(np.arange(matrix.shape[0]), kept)


def trailing_block(matrix: sparse.csr_array, kept: np.ndarray) -> np.ndarray:
    """One LU, interior in minimum degree, kept ones last: S is the product of the trailing blocks of L and U."""
    inner = _interior(matrix, kept)
    interior = sparse.csc_array(matrix[inner][:, inner])
    degree = np.argsort(splu(interior, permc_spec="MMD_AT_PLUS_A", **SYMMETRIC).perm_c)
    order = np.concatenate([inner[degree], kept])
    factors = splu(sparse.csc_array(matrix[order][:, order]), permc_spec="NATURAL", **SYMMETRIC)
    last = np.arange(matrix.shape[0] - kept.size, matrix.shape[0])
    if not (np.array_equal(factors.perm_r[last], last) and np.array_equal(factors.perm_c[last], last)):
        raise RuntimeError("the kept degrees of freedom did not stay last")
    lower, upper = (part[last][:, last].toarray() for part in (factors.L.tocsr(), factors.U.tocsr()))
    return lower @ upper


def right_hand_sides(matrix: sparse.csr_array, kept: np.ndarray) -> np.ndarray:
    """S = K_kk - K_ki K_ii⁻¹ K_ik, one right-hand side a kept degree of freedom."""
    inner = _interior(matrix, kept)
    factors = splu(sparse.csc_array(matrix[inner][:, inner]), permc_spec="MMD_AT_PLUS_A", **SYMMETRIC)
    coupling = sparse.csc_array(matrix[inner][:, kept])
    back = matrix[kept][:, inner]
    reduced = matrix[kept][:, kept].toarray()
    for first in range(0, kept.size, BLOCK):
        columns = slice(first, first + BLOCK)
        reduced[:, columns] -= back @ factors.solve(coupling[:, columns].toarray())
    return reduced


METHODS: dict[str, Condensation] = {
    "nested dissection": condense,
    "trailing block of one LU": trailing_block,
    "many right-hand sides": right_hand_sides,
}
