"""A rectangle whose whole lower side is the contact edge."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softlub.solid.blocks import block_cells, columns_between, even_positions, graded
from softlub.solid.mesh import BodyMesh, FloatArray
from softlub.solid.mesh_quality import sound
from softlub.solid.shapes.density import MeshDensity
from softlub.units import Length, check


@dataclass(frozen=True)
class Rectangle:
    """Rectangle held along its upper side.

    Parameters
    ----------
    width, height : float
        Along x and y [m].

    Raises
    ------
    ValueError
        If a length is not positive.
    """

    width: Length
    height: Length

    def __post_init__(self) -> None:
        check(self)

    @property
    def area(self) -> float:
        """Area [m²]."""
        return self.width * self.height

    def mesh(self, density: MeshDensity) -> BodyMesh:
        """Even columns, rows that grow away from the contact edge.

        Parameters
        ----------
        density : MeshDensity
            Without use of `flank_columns`.

        Returns
        -------
        BodyMesh

        Raises
        ------
        ValueError
            If the cells would be too long for their width.
        """
        positions = even_positions(self.width, density.edge_nodes)
        mesh = layered(positions, self.height, density.height_at_edge(self.width), density.rows, 0)
        return sound(mesh, "rectangle", self.area)


def layered(
    positions: FloatArray, height: float, first_height: float, rows: int, flank_columns: int
) -> BodyMesh:
    """Upright columns in rows of equal height, held along the upper side.

    Parameters
    ----------
    positions : ndarray, shape (k,)
        x of the columns [m].
    height, first_height : float
        Of the body and of its lowest row [m].
    rows : int
    flank_columns : int
        Cells on either side that do not belong to the contact edge.

    Returns
    -------
    BodyMesh
    """
    bottom = np.stack([positions, np.zeros_like(positions)], axis=1)
    top = np.stack([positions, np.full_like(positions, height)], axis=1)
    shares = np.broadcast_to(graded(first_height, height, rows) / height, (positions.size, rows + 1))
    nodes = columns_between(bottom, top, shares)
    lowest, highest = np.arange(positions.size), np.arange(positions.size) + rows * positions.size
    edge = lowest[flank_columns : positions.size - flank_columns]
    return BodyMesh(nodes.reshape(-1, 2), block_cells(positions.size - 1, rows), edge, highest)
