"""The mesh of a soft body: four-node quads in the plane, their contact edge and the nodes that the holder holds.

x runs along the plate and y up; the body stands above the plate, its apex at the origin. Degrees of freedom are
numbered 2 · node + component.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class BodyMesh:
    """Quads of a body in plane strain, one metre thick.

    Parameters
    ----------
    points : ndarray, shape (n, 2)
        Places of the nodes [m].
    cells : ndarray of int, shape (m, 4)
        Nodes of every cell, counter-clockwise.
    edge : ndarray of int, shape (k,)
        Nodes of the contact edge, ascending in x.
    held : ndarray of int, shape (h,)
        Nodes that the holder fixes.

    Raises
    ------
    ValueError
        If an array has another shape, a place is not finite, a node does not exist or belongs to no cell, the edge
        does not ascend in x, or an edge node is held.
    """

    points: FloatArray
    cells: IntArray
    edge: IntArray
    held: IntArray

    def __post_init__(self) -> None:
        self._check_shapes()
        if not np.all(np.isfinite(self.points)):
            bad = np.flatnonzero(~np.isfinite(self.points).all(axis=1))
            raise ValueError(f"{bad.size} nodes of the mesh have no finite place, the first is node {bad[0]}")
        nodes = np.arange(len(self.points))
        for name in ("cells", "edge", "held"):
            if not np.isin(getattr(self, name), nodes).all():
                raise ValueError(f"{name} name nodes outside 0 to {len(self.points) - 1}")
        loose = np.setdiff1d(nodes, self.cells)
        if loose.size:
            raise ValueError(f"{loose.size} nodes belong to no cell, the first is node {loose[0]}")
        if np.any(np.diff(self.edge_positions) <= 0):
            raise ValueError("the nodes of the contact edge must ascend in x, none above another")
        if np.isin(self.edge, self.held).any():
            raise ValueError(
                "a node of the contact edge is held: the edge reaches the holder; make it narrower"
            )

    def _check_shapes(self) -> None:
        for name, shape in (("points", (-1, 2)), ("cells", (-1, 4)), ("edge", (-1,)), ("held", (-1,))):
            given = getattr(self, name).shape
            if len(given) != len(shape) or given[1:] != shape[1:]:
                raise ValueError(f"{name} of shape {given}: allowed is {str(shape).replace('-1', 'n')}")
        if self.edge.size < 3:
            raise ValueError(f"a contact edge of {self.edge.size} nodes: at least 3 are needed")

    @cached_property
    def edge_positions(self) -> FloatArray:
        """x of the edge nodes [m], shape (k,)."""
        return self.points[self.edge, 0]

    @cached_property
    def edge_widths(self) -> FloatArray:
        """Length along x that each edge node stands for in the reference state [m], shape (k,)."""
        halves = np.diff(self.edge_positions) / 2
        return np.append(halves, 0.0) + np.append(0.0, halves)

    @cached_property
    def base_gap(self) -> FloatArray:
        """Height of the edge nodes above the lowest of them [m], shape (k,)."""
        heights = self.points[self.edge, 1]
        return heights - heights.min()

    @cached_property
    def free_dofs(self) -> IntArray:
        """Degrees of freedom of all nodes that are not held, ascending."""
        free = np.setdiff1d(np.arange(len(self.points)), self.held)
        return _dofs(free)

    @cached_property
    def edge_dofs(self) -> IntArray:
        """Degrees of freedom of the edge nodes, shape (2k,), ordered x0, y0, x1, y1, ..."""
        return _dofs(self.edge)


def _dofs(nodes: IntArray) -> IntArray:
    return (2 * nodes[:, None] + np.arange(2)).ravel()
