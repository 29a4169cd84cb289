"""Whether a mesh can carry a calculation: its numbers, and the refusal of one that cannot."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softlub.solid.mesh import BodyMesh, FloatArray, IntArray

LEAST_SCALED_JACOBIAN = 0.02
LARGEST_ASPECT = 2000.0
AREA_TOLERANCE = 0.01
"""Relative; chords of a coarse round edge cut off less, a gap or an overlap of blocks is more."""


@dataclass(frozen=True)
class MeshQuality:
    """Numbers of a mesh.

    Parameters
    ----------
    nodes, cells, edge_nodes : int
    scaled_jacobian : float
        Smallest sine of the angle between two sides in a corner of a cell; 1 for rectangles, negative for a corner
        that is turned inside out.
    aspect : float
        Largest ratio of the longest to the shortest side of a cell.
    jump : float
        Largest ratio of the extents of two neighbours, each from the middle of their common side to that of the
        opposite one.
    hanging_nodes : int
        Nodes in the middle of another cell's side or in the place of another node.
    boundaries : int
        Closed lines that bound the mesh; 1 for a body without holes.
    area : float
        Of all cells [m²].
    """

    nodes: int
    cells: int
    edge_nodes: int
    scaled_jacobian: float
    aspect: float
    jump: float
    hanging_nodes: int
    boundaries: int
    area: float


def inspect(mesh: BodyMesh) -> MeshQuality:
    """Measure a mesh.

    Parameters
    ----------
    mesh : BodyMesh

    Returns
    -------
    MeshQuality

    Raises
    ------
    ValueError
        If more than two cells share a side, or two neighbours do not turn the same way.
    """
    corners = mesh.points[mesh.cells]
    sides = np.roll(corners, -1, axis=1) - corners
    lengths = np.hypot(sides[..., 0], sides[..., 1])
    before = np.roll(sides, 1, axis=1)
    turn = before[..., 0] * sides[..., 1] - before[..., 1] * sides[..., 0]
    areas = cell_areas(mesh)
    inner, outer = _sides(mesh.cells)
    middles = corners + sides / 2
    across = np.roll(middles, -2, axis=1) - middles
    extents = np.hypot(across[..., 0], across[..., 1]).ravel()[inner]
    # Cells without extent have numbers too, infinite or NaN ones, which no bound lets pass.
    with np.errstate(divide="ignore", invalid="ignore"):
        scaled_jacobians = turn / (lengths * np.roll(lengths, 1, axis=1))
        aspects = lengths.max(axis=1) / lengths.min(axis=1)
        jumps = extents.max(axis=1) / extents.min(axis=1)
        hanging = _hanging(mesh, outer)
    return MeshQuality(
        nodes=len(mesh.points),
        cells=len(mesh.cells),
        edge_nodes=mesh.edge.size,
        scaled_jacobian=float(np.min(scaled_jacobians)),
        aspect=float(np.max(aspects)),
        jump=float(np.max(jumps, initial=1.0)),
        hanging_nodes=hanging,
        boundaries=_loops(mesh.cells, outer),
        area=float(areas.sum()),
    )


def sound(mesh: BodyMesh, shape: str, area: float) -> BodyMesh:
    """The mesh itself, if its quality allows a calculation.

    Parameters
    ----------
    mesh : BodyMesh
    shape : str
        Name of the shape, for messages.
    area : float
        Of the shape in closed form [m²].

    Returns
    -------
    BodyMesh

    Raises
    ------
    ValueError
        Naming the shape and every number that is out of bounds, with the bound and what to do.
    """
    quality = inspect(mesh)
    remedy = "let cells change more gently by rows, first_height and flank_columns, or make the contact edge narrower"
    faults = [
        text
        for wrong, text in (
            (
                not quality.scaled_jacobian > LEAST_SCALED_JACOBIAN,
                f"the smallest scaled Jacobian is {quality.scaled_jacobian:.3g}, must be above {LEAST_SCALED_JACOBIAN}",
            ),
            (
                not quality.aspect < LARGEST_ASPECT,
                f"the largest aspect of a cell is {quality.aspect:.4g}, must be below {LARGEST_ASPECT:g}",
            ),
            (quality.hanging_nodes > 0, f"{quality.hanging_nodes} nodes hang"),
            (quality.boundaries != 1, f"{quality.boundaries} closed lines bound it, must be 1"),
            (
                not abs(quality.area / area - 1) < AREA_TOLERANCE,
                f"its area is {quality.area:.4g} m², the shape's {area:.4g} m²",
            ),
        )
        if wrong
    ]
    if faults:
        raise ValueError(f"mesh of the {shape}: {'; '.join(faults)}; {remedy}")
    return mesh


def cell_areas(mesh: BodyMesh) -> FloatArray:
    """Areas of the cells [m²], shape (m,); negative for clockwise ones."""
    a, b = (mesh.points[mesh.cells[:, end]] - mesh.points[mesh.cells[:, end - 2]] for end in (2, 3))
    return (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2


def _sides(cells: IntArray) -> tuple[IntArray, IntArray]:
    """Places in the flattened cells of sides that two cells share, shape (s, 2), and of sides of one cell alone."""
    start, end = cells.ravel(), np.roll(cells, -1, axis=1).ravel()
    key = np.minimum(start, end) * (cells.max() + 1) + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    _, first, count = np.unique(key[order], return_index=True, return_counts=True)
    if count.max() > 2:
        raise ValueError(f"{np.count_nonzero(count > 2)} sides belong to more than two cells of the mesh")
    shared = first[count == 2]
    inner = np.stack([order[shared], order[shared + 1]], axis=1)
    if np.any(start[inner[:, 0]] != end[inner[:, 1]]):
        raise ValueError("neighbouring cells of the mesh turn in opposite ways, or lie on each other")
    return inner, order[first[count == 1]]


def _loops(cells: IntArray, outer: IntArray) -> int:
    """Number of closed lines that the outer sides make; 0 where they do not close."""
    start, end = cells.ravel()[outer], np.roll(cells, -1, axis=1).ravel()[outer]
    if np.unique(start).size != start.size or not np.array_equal(np.sort(start), np.sort(end)):
        return 0
    follower = dict(zip(start.tolist(), end.tolist(), strict=True))
    loops = 0
    while follower:
        loops += 1
        node = next(iter(follower))
        while node in follower:
            node = follower.pop(node)
    return loops


def _hanging(mesh: BodyMesh, outer: IntArray) -> int:
    """Boundary nodes that lie on a boundary side they do not belong to."""
    start, end = mesh.cells.ravel()[outer], np.roll(mesh.cells, -1, axis=1).ravel()[outer]
    origin, along = mesh.points[start], mesh.points[end] - mesh.points[start]
    length = np.hypot(along[:, 0], along[:, 1])
    found = 0
    for node in start:
        away = mesh.points[node] - origin
        share = (away[:, 0] * along[:, 0] + away[:, 1] * along[:, 1]) / length**2
        aside = np.abs(away[:, 0] * along[:, 1] - away[:, 1] * along[:, 0]) / length
        touches = (share > -1e-9) & (share < 1 + 1e-9) & (aside < 1e-9 * length)
        found += bool(np.any(touches & (start != node) & (end != node)))
    return found
