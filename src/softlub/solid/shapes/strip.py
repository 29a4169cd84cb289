"""A layer bonded to the holder, wider than its contact edge."""

from __future__ import annotations

from dataclasses import dataclass

from softlub.solid.blocks import level, one_block, symmetric_positions
from softlub.solid.mesh import BodyMesh
from softlub.solid.mesh_quality import sound
from softlub.solid.shapes.density import MeshDensity, refuse_wide_edge
from softlub.units import Length, check


@dataclass(frozen=True)
class Strip:
    """Flat layer, bonded to the holder along its upper side.

    Parameters
    ----------
    thickness : float
        Along y [m].
    width : float
        Along x [m].
    edge_width : float
        Of the contact edge, in the middle of the lower side [m].

    Raises
    ------
    ValueError
        If a length is not positive or the contact edge is as wide as the strip.
    """

    thickness: Length
    width: Length
    edge_width: Length

    def __post_init__(self) -> None:
        check(self)
        refuse_wide_edge("Strip", self.edge_width, self.width)

    @property
    def area(self) -> float:
        """Area [m²]."""
        return self.width * self.thickness

    def mesh(self, density: MeshDensity) -> BodyMesh:
        """Columns even over the contact edge and wider away from it, rows that grow with depth.

        Parameters
        ----------
        density : MeshDensity

        Returns
        -------
        BodyMesh

        Raises
        ------
        ValueError
            If the cells would be too long for their width.
        """
        x = symmetric_positions(self.edge_width, density.edge_nodes, self.width, density.flank_columns)
        first_height = density.height_at_edge(self.edge_width)
        bottom, top = level(x, 0), level(x, self.thickness)
        mesh = one_block(bottom, top, first_height, density.rows, density.flank_columns)
        return sound(mesh, "strip", self.area)
