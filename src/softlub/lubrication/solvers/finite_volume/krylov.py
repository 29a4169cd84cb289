"""GMRES with a preconditioner on the right: what it minimises is the true residual."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from softlub.protocols import FloatArray

Operator = Callable[[FloatArray], FloatArray]


def gmres(
    operator: Operator, precondition: Operator, right: FloatArray, tolerance: float, most: int
) -> tuple[FloatArray, int]:
    """Solve a linear system from its products with vectors, without restart.

    Parameters
    ----------
    operator, precondition : callable
        A v and M⁻¹ v.
    right : ndarray, shape (n,)
    tolerance : float
        Relative to the norm of `right`, of the residual.
    most : int
        Largest number of products with A.

    Returns
    -------
    solution : ndarray, shape (n,)
    products : int
        `most` where the tolerance may not have been reached.
    """
    norm = float(np.linalg.norm(right))
    if norm == 0.0 or not np.isfinite(norm):
        return right.copy(), 0
    basis = np.zeros((most + 1, right.size))
    triangle = np.zeros((most + 1, most))
    rotations = np.zeros((most, 2))
    reduced = np.zeros(most + 1)
    basis[0], reduced[0] = right / norm, norm
    count = 0
    while count < most and abs(reduced[count]) > tolerance * norm:
        vector = operator(precondition(basis[count]))
        # Classical Gram–Schmidt, twice: two products with the basis instead of a loop over it.
        column = basis[: count + 1] @ vector
        vector -= column @ basis[: count + 1]
        again = basis[: count + 1] @ vector
        vector -= again @ basis[: count + 1]
        length = float(np.linalg.norm(vector))
        triangle[: count + 1, count] = column + again
        _rotate(triangle[:, count], rotations, count, length)
        cosine, sine = rotations[count]
        reduced[count + 1], reduced[count] = -sine * reduced[count], cosine * reduced[count]
        count += 1
        if length == 0.0:
            break
        basis[count] = vector / length
    weights = np.linalg.solve(triangle[:count, :count], reduced[:count])
    return precondition(weights @ basis[:count]), count


def _rotate(column: FloatArray, rotations: FloatArray, index: int, below: float) -> None:
    """Apply the Givens rotations so far to a new Hessenberg column and find the one that clears its last entry."""
    for k in range(index):
        cosine, sine = rotations[k]
        column[k], column[k + 1] = (
            cosine * column[k] + sine * column[k + 1],
            cosine * column[k + 1] - sine * column[k],
        )
    length = float(np.hypot(column[index], below))
    rotations[index] = column[index] / length, below / length
    column[index] = length
