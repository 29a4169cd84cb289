"""Order of elimination by nested dissection of a sparse matrix's graph.

A set of variables that parts the graph in two is eliminated after both sides, each side likewise: the sides know
nothing of each other, so that the dense blocks of the elimination stay small. The separators are level sets of a
breadth-first search from the graph's rim, which on the long thin meshes along a contact edge are its columns.
"""

from __future__ import annotations

from bisect import bisect_left
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import csgraph

IntArray = NDArray[np.int64]

LEAF_SIZE = 240
"""Variables below which a part is eliminated at once: the quickest of 48 to 400 on the triangle's meshes."""
BALANCE = 0.4
"""A separator has at least this share of the vertices on its both sides, itself counted with each."""


class Front(NamedTuple):
    """Variables that are eliminated together."""

    variables: IntArray
    children: tuple[int, ...]
    """Fronts, by their place in the order, whose remainder this one takes over."""


def nested_dissection(pattern: sparse.csr_array, leaf_size: int = LEAF_SIZE) -> list[Front]:
    """Fronts in an order in which every one comes after its children.

    Parameters
    ----------
    pattern : scipy.sparse.csr_array, shape (n, n)
        Its structure alone counts, made symmetric; it may fall into pieces.
    leaf_size : int
        Variables of a part that is no longer divided.

    Returns
    -------
    list of Front
        Each variable belongs to exactly one.
    """
    if pattern.shape[0] == 0:
        return []
    symmetric = sparse.csr_array(
        (np.ones(pattern.nnz, dtype=np.int8), pattern.indices, pattern.indptr), pattern.shape
    )
    symmetric = sparse.csr_array(symmetric + symmetric.T + sparse.eye_array(pattern.shape[0], dtype=np.int8))
    group, first = _indistinguishable(symmetric)
    graph = sparse.csr_array(symmetric[first][:, first])
    parts: list[Front] = []
    _dissect(graph, np.arange(first.size), max(leaf_size * first.size // max(group.size, 1), 1), parts)
    front_of = np.empty(first.size, dtype=np.int64)
    for number, part in enumerate(parts):
        front_of[part.variables] = number
    own = front_of[group]
    variables = np.split(np.argsort(own, kind="stable"), np.cumsum(np.bincount(own))[:-1])
    return [Front(*front) for front in zip(variables, (part.children for part in parts), strict=False)]


def _indistinguishable(pattern: sparse.csr_array) -> tuple[IntArray, IntArray]:
    """Group of each variable and a variable of each group; those with the same neighbours, as a node's, are one.

    Equal sets of neighbours have equal sums of random labels; integers, so that their order does not matter.
    """
    labels = np.random.default_rng(0).integers(1, 2**40, pattern.shape[0])
    sums = pattern.astype(np.int64) @ labels
    _, first, group = np.unique(sums, return_index=True, return_inverse=True)
    return group, first


def _dissect(
    graph: sparse.csr_array, vertices: IntArray, leaf_size: int, fronts: list[Front]
) -> tuple[int, ...]:
    """Append the fronts of a part of the graph; return those that nothing of the part takes over."""
    if vertices.size == 0:
        return ()
    if vertices.size <= leaf_size:
        fronts.append(Front(vertices, ()))
        return (len(fronts) - 1,)
    one, separator, other = _bisect(graph)
    below: tuple[int, ...] = ()
    for side in (one, other):
        below += _dissect(sparse.csr_array(graph[side][:, side]), vertices[side], leaf_size, fronts)
    if separator.size == 0:
        return below
    fronts.append(Front(vertices[separator], below))
    return (len(fronts) - 1,)


def _bisect(graph: sparse.csr_array) -> tuple[IntArray, IntArray, IntArray]:
    """One side, the separator, the other side; a graph in pieces needs no separator."""
    start = csgraph.breadth_first_order(graph, 0, return_predecessors=False)[-1]
    order, predecessors = csgraph.breadth_first_order(graph, start)
    size = graph.shape[0]
    if order.size < size:
        reached = np.zeros(size, dtype=bool)
        reached[order] = True
        return np.flatnonzero(reached), np.zeros(0, dtype=np.int64), np.flatnonzero(~reached)
    starts = _level_starts(order, predecessors)
    begin, end = starts[:-1], starts[1:]
    central = np.flatnonzero((begin <= (1 - BALANCE) * size) & (end >= BALANCE * size))
    level = central[np.argmin((end - begin)[central])]
    cuts = [begin[level], end[level]]
    one, separator, other = (np.sort(part).astype(np.int64) for part in np.split(order, cuts))
    return one, separator, other


def _level_starts(order: IntArray, predecessors: IntArray) -> IntArray:
    """Where the levels of a breadth-first search begin in its order, with the end of the last."""
    rank = np.empty(order.size, dtype=np.int64)
    rank[order] = np.arange(order.size)
    parents = rank[predecessors[order[1:]]].tolist()
    starts = [0, 1]
    while starts[-1] < order.size:
        # A vertex belongs to the next level if its parent lies in this one; parents ascend along the order.
        starts.append(1 + bisect_left(parents, starts[-1]))
    return np.array(starts)
