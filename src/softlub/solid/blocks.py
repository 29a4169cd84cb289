"""Blocks of quads in rows and columns: spacing in a constant ratio, columns between two curves, joining of blocks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from softlub.solid.mesh import BodyMesh, FloatArray, IntArray

BISECTIONS = 60
"""Halvings of the interval of the ratio: to the last bit."""
LARGEST_RATIO = 1e3
"""Ratio of neighbouring cells that no mesh comes near."""


def graded(first: ArrayLike, length: ArrayLike, cells: int, even: int = 0) -> FloatArray:
    """Ends of cells that grow in a constant ratio over a length.

    Parameters
    ----------
    first : array_like, shape (...)
        Length of the first cell [m]; where that many of them would fill the length or more, the cells are even.
    length : array_like, shape (...)
        Length that the cells fill [m].
    cells : int
        Number of cells.
    even : int
        How many cells at the end are as long as the last growing one.

    Returns
    -------
    ndarray, shape (..., cells + 1)
        From 0 to `length` [m].
    """
    first, length = np.broadcast_arrays(np.asarray(first, dtype=float), np.asarray(length, dtype=float))
    powers = np.minimum(np.arange(cells), cells - 1 - even)
    wanted = np.maximum(length / first, cells)
    low, high = np.zeros(first.shape), np.full(first.shape, np.log(LARGEST_RATIO))
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        short = np.exp(middle[..., None] * powers).sum(axis=-1) < wanted
        low, high = np.where(short, middle, low), np.where(short, high, middle)
    sizes = np.exp(low[..., None] * powers)
    ends = np.cumsum(sizes, axis=-1) / sizes.sum(axis=-1, keepdims=True)
    ends[..., -1] = 1.0
    starts = np.zeros((*first.shape, 1), dtype=np.float64)
    return np.concatenate([starts, ends * length[..., None]], axis=-1)


def even_positions(edge_width: float, edge_nodes: int) -> FloatArray:
    """x of the nodes of a contact edge.

    Parameters
    ----------
    edge_width : float
        [m].
    edge_nodes : int

    Returns
    -------
    ndarray, shape (edge_nodes,)
        From -edge_width/2 to edge_width/2 [m], equal on both sides to the last bit.
    """
    steps = np.arange(edge_nodes, dtype=np.float64) - (edge_nodes - 1) / 2
    return steps * (edge_width / (edge_nodes - 1))


def symmetric_positions(edge_width: float, edge_nodes: int, width: float, flank_columns: int) -> FloatArray:
    """x of the columns of a body: even over the contact edge, growing towards both sides.

    Parameters
    ----------
    edge_width, width : float
        Of the contact edge and of the body [m].
    edge_nodes, flank_columns : int
        Nodes over the edge and cells on either side of it.

    Returns
    -------
    ndarray, shape (edge_nodes + 2 · flank_columns,)
        From -width/2 to width/2 [m], equal on both sides to the last bit.
    """
    spacing = edge_width / (edge_nodes - 1)
    edge = even_positions(edge_width, edge_nodes)
    flank = edge_width / 2 + graded(spacing, (width - edge_width) / 2, flank_columns)[1:]
    return np.concatenate([-flank[::-1], edge, flank])


def level(positions: FloatArray, height: float) -> FloatArray:
    """Points at one height.

    Parameters
    ----------
    positions : ndarray, shape (k,)
        x [m].
    height : float
        y [m].

    Returns
    -------
    ndarray, shape (k, 2)
    """
    return np.stack([positions, np.full_like(positions, height)], axis=1)


def block_cells(columns: int, rows: int) -> IntArray:
    """Cells of a block whose nodes are numbered row by row, counter-clockwise where rows lie above each other.

    Parameters
    ----------
    columns, rows : int
        Numbers of cells.

    Returns
    -------
    ndarray of int, shape (columns · rows, 4)
    """
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    return corner[:, None] + np.array([0, 1, columns + 2, columns + 1])


def columns_between(bottom: FloatArray, top: FloatArray, first_heights: ArrayLike, rows: int) -> FloatArray:
    """Nodes on straight columns from one curve to another, closest to each other at the bottom.

    Parameters
    ----------
    bottom, top : ndarray, shape (k, 2)
        Ends of the columns [m].
    first_heights : array_like, shape () or (k,)
        Lengths of the lowest cells [m].
    rows : int
        Number of cells from bottom to top.

    Returns
    -------
    ndarray, shape (rows + 1, k, 2)
    """
    way = top - bottom
    length = np.hypot(way[:, 0], way[:, 1])
    shares = graded(first_heights, length, rows) / length[:, None]
    return bottom + way * shares.T[..., None]


def one_block(
    bottom: FloatArray, top: FloatArray, first_heights: ArrayLike, rows: int, flank_columns: int
) -> BodyMesh:
    """Mesh of columns between a lower and an upper side, held along the upper one.

    Parameters
    ----------
    bottom, top : ndarray, shape (k, 2)
        Ends of the columns from left to right [m].
    first_heights : array_like, shape () or (k,)
        Lengths of the lowest cells [m].
    rows : int
    flank_columns : int
        Cells on either side that do not belong to the contact edge.

    Returns
    -------
    BodyMesh
    """
    nodes = columns_between(bottom, top, first_heights, rows)
    node = np.arange(len(bottom))
    return BodyMesh(
        points=nodes.reshape(-1, 2),
        cells=block_cells(node.size - 1, rows),
        edge=node[flank_columns : node.size - flank_columns],
        held=node + rows * node.size,
    )


def transfinite(lower: FloatArray, upper: FloatArray, left: FloatArray, right: FloatArray) -> FloatArray:
    """Nodes of a block between four curves that meet in its corners (Coons' patch).

    Parameters
    ----------
    lower, upper : ndarray, shape (columns + 1, 2)
        From left to right [m].
    left, right : ndarray, shape (rows + 1, 2)
        From the lower to the upper curve [m].

    Returns
    -------
    ndarray, shape (rows + 1, columns + 1, 2)
    """
    across, along = _shares(lower, upper), _shares(left, right)
    # Every node takes its two shares from where its row and its column, both straight in shares, cross.
    a0, a1, b0, b1 = across[0][None], across[1][None], along[0][:, None], along[1][:, None]
    s = (a0 + b0 * (a1 - a0)) / (1 - (a1 - a0) * (b1 - b0))
    t = (b0 + s * (b1 - b0))[..., None]
    s = s[..., None]
    sides = (1 - t) * lower[None] + t * upper[None] + (1 - s) * left[:, None] + s * right[:, None]
    corners = (1 - t) * ((1 - s) * lower[0] + s * lower[-1]) + t * ((1 - s) * upper[0] + s * upper[-1])
    return sides - corners


def _shares(first: FloatArray, second: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Length along each of two curves up to every node, as part of the whole."""
    lengths = [np.append(0.0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T))) for curve in (first, second)]
    return lengths[0] / lengths[0][-1], lengths[1] / lengths[1][-1]


def join(blocks: Sequence[FloatArray], tolerance: float) -> tuple[FloatArray, IntArray, list[IntArray]]:
    """Join blocks of nodes to one mesh; nodes in the same place become one.

    Parameters
    ----------
    blocks : sequence of ndarray, shape (rows + 1, columns + 1, 2)
        Places [m]; the cells come out counter-clockwise where rows lie above each other and columns go right.
    tolerance : float
        Distance below which two places are the same [m]; far below the shortest side of a cell.

    Returns
    -------
    points : ndarray, shape (n, 2)
    cells : ndarray of int, shape (m, 4)
    numbers : list of ndarray of int, shape (rows + 1, columns + 1)
        Node of every place of every block.
    """
    places = np.concatenate([block.reshape(-1, 2) for block in blocks])
    offsets = np.cumsum([0, *(block.shape[0] * block.shape[1] for block in blocks)])
    node = _same_places(places, tolerance)
    kept, number = np.unique(node, return_inverse=True)
    cells = [
        number[block_cells(block.shape[1] - 1, block.shape[0] - 1) + offset]
        for block, offset in zip(blocks, offsets, strict=False)
    ]
    numbers = [
        number[offset : offset + block.shape[0] * block.shape[1]].reshape(block.shape[:2])
        for block, offset in zip(blocks, offsets, strict=False)
    ]
    return places[kept], np.concatenate(cells), numbers


def _same_places(places: FloatArray, tolerance: float) -> IntArray:
    """The first of all places that each coincides with."""
    first = np.arange(len(places))
    # Two lattices, half a step apart, so that no pair falls on both sides of a border in both.
    for shift in ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)):
        lattice = np.floor(places / (4 * tolerance) + np.array(shift)).astype(np.int64)
        _, which = np.unique(lattice, axis=0, return_inverse=True)
        lowest = np.full(which.max() + 1, len(places))
        np.minimum.at(lowest, which.ravel(), first)
        first = lowest[which.ravel()]
    return first
