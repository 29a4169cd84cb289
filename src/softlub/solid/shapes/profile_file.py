"""A body whose contact edge was measured: the edge from a file below a rectangular block."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from softlub.solid.blocks import level, one_block, symmetric_positions
from softlub.solid.mesh import BodyMesh
from softlub.solid.mesh_quality import sound
from softlub.solid.shapes.density import MeshDensity, refuse_wide_edge
from softlub.solid.shapes.profile import EdgeProfile, read_edge
from softlub.units import Length, check


@dataclass(frozen=True)
class ProfileFile:
    """Block with a measured contact edge in the middle of its lower side.

    On either side of the edge the lower side goes on level to the side of the block.

    Parameters
    ----------
    file : str
        CSV file with the columns x and y and their units in the header, as ``x [mm],y [um]``; one point a row in
        their order along the edge.
    width : float
        Of the block [m].
    height : float
        From the lowest point of the edge to the held side [m].

    Raises
    ------
    ValueError
        If a length is not positive.
    """

    file: str
    width: Length
    height: Length

    def __post_init__(self) -> None:
        check(self)

    @cached_property
    def edge(self) -> EdgeProfile:
        """The measured edge.

        Raises
        ------
        ValueError
            If the file holds no contact edge, or one that does not fit the block. The message names the file.
        FileNotFoundError
            If there is no such file.
        """
        path = Path(self.file)
        edge = read_edge(path)
        refuse_wide_edge(str(path), edge.width, self.width)
        if edge.heights.max() >= self.height:
            raise ValueError(
                f"{path}: the contact edge rises {edge.heights.max():g} m above its lowest point, not less than the "
                f"body's height, {self.height:g} m; give the body a larger height"
            )
        return edge

    @property
    def area(self) -> float:
        """Area [m²]."""
        edge = self.edge
        below_flanks = (edge.heights[0] + edge.heights[-1]) * (self.width - edge.width) / 2
        return self.width * self.height - edge.area_below - float(below_flanks)

    def mesh(self, density: MeshDensity) -> BodyMesh:
        """One block of upright columns, even over the measured edge.

        Parameters
        ----------
        density : MeshDensity

        Returns
        -------
        BodyMesh

        Raises
        ------
        ValueError
            If the file cannot be used, or the cells would be too long for their width or too oblique.
        FileNotFoundError
            If there is no such file.
        """
        edge = self.edge
        x = edge.middle + symmetric_positions(
            edge.width, density.edge_nodes, self.width, density.flank_columns
        )
        bottom = np.stack([x, edge.at(x)], axis=1)
        top = level(x, self.height)
        first_height = density.height_at_edge(edge.width)
        mesh = one_block(bottom, top, first_height, density.rows, density.flank_columns)
        return sound(mesh, f"body with the edge of {self.file}", self.area)
