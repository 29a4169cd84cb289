"""The polynomial basis of one element: Lagrange polynomials on Gauss–Lobatto–Legendre nodes of [-1, 1]."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


class Basis(NamedTuple):
    """Nodes of one order p, and the operators on nodal values.

    Attributes
    ----------
    nodes, weights : ndarray, shape (p + 1,)
        Lobatto nodes, ascending, and quadrature weights (exact to degree 2p - 1).
    integration : ndarray, shape (p + 1, p + 1)
        S_ij = ∫ from -1 to node i of ℓ_j, exact.
    differentiation : ndarray, shape (p + 1, p + 1)
        D_ij = ℓ_j'(node i).
    legendre_weights : ndarray, shape (p + 1, p + 1)
        Row k holds the coefficient of the Legendre polynomial P_k in every ℓ_j.
    barycentric : ndarray, shape (p + 1,)
        Weights of the barycentric interpolation formula.
    """

    nodes: FloatArray
    weights: FloatArray
    integration: FloatArray
    differentiation: FloatArray
    legendre_weights: FloatArray
    barycentric: FloatArray


def lobatto_nodes(order: int) -> FloatArray:
    """Zeros of (1 - t²) P_p'(t), ascending, shape (order + 1,)."""
    slope = legendre.legder(np.eye(order + 1)[order])
    curvature = legendre.legder(slope)
    inner = np.sort(legendre.legroots(slope).real)
    for _ in range(3):  # the eigenvalues of the companion matrix are good to 1e-13 only
        inner -= legendre.legval(inner, slope) / legendre.legval(inner, curvature)
    inner = 0.5 * (inner - inner[::-1])
    return np.concatenate([[-1.0], inner, [1.0]])


@lru_cache(maxsize=32)
def lobatto_basis(order: int) -> Basis:
    """The basis of a given polynomial order.

    Parameters
    ----------
    order : int
        p >= 2.

    Returns
    -------
    Basis

    Raises
    ------
    ValueError
        If the order is below 2.
    """
    if order < 2:
        raise ValueError(f"order {order} is too low for a spectral element; it must be 2 or more")
    nodes = lobatto_nodes(order)
    values = legendre.legvander(nodes, order + 1)
    weights = 2 / (order * (order + 1) * values[:, order] ** 2)
    degree = np.arange(order + 1)
    # Discrete Legendre transform: exact for every P_k with its Lobatto norm, 2/p for the last one.
    norm = 2 / (2 * degree + 1)
    norm[order] = 2 / order
    legendre_weights = values[:, : order + 1].T * weights / norm[:, None]
    antiderivative = np.empty((order + 1, order + 1))
    antiderivative[:, 0] = nodes + 1
    for k in range(1, order + 1):
        antiderivative[:, k] = (values[:, k + 1] - values[:, k - 1]) / (2 * k + 1)
    distance = nodes[:, None] - nodes[None, :] + np.eye(order + 1)
    barycentric = 1 / distance.prod(axis=1)
    differentiation = barycentric[None, :] / barycentric[:, None] / distance
    np.fill_diagonal(differentiation, 0)
    np.fill_diagonal(differentiation, -differentiation.sum(axis=1))
    return Basis(
        nodes,
        weights,
        np.ascontiguousarray(antiderivative @ legendre_weights),
        np.ascontiguousarray(differentiation),
        np.ascontiguousarray(legendre_weights),
        barycentric / np.abs(barycentric).max(),
    )
