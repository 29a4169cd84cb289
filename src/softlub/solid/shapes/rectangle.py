"""A rectangle whose whole lower side is the contact edge."""

from __future__ import annotations

from dataclasses import dataclass

from softlub.solid.blocks import even_positions, level, one_block
from softlub.solid.mesh import BodyMesh
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
        x = even_positions(self.width, density.edge_nodes)
        first_height = density.height_at_edge(self.width)
        mesh = one_block(level(x, 0), level(x, self.height), first_height, density.rows, 0)
        return sound(mesh, "rectangle", self.area)
