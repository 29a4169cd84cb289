"""The half cylinder of the source's chapters 3 and 5 as a body: round below, flat and held above."""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, pi

import numpy as np

from softlub.solid.blocks import (
    columns_between,
    even_positions,
    graded,
    join,
    level,
    transfinite,
)
from softlub.solid.mesh import BodyMesh, FloatArray
from softlub.solid.mesh_quality import sound
from softlub.solid.shapes.density import MeshDensity, refuse_wide_edge
from softlub.units import Length, check

TOP_SHARE = 0.4
"""Part of the held side that the columns above the contact edge end on."""
INNER_POINT = 0.55
"""Part of the outermost column, from below, up to which its cells go on along the round side."""
MEETING = 0.5
"""Where on the held side, from the columns' end to the corner, the blocks of either side meet."""
ON_TOP = 1e-12
"""Rounding of the height of held nodes, relative to the radius."""
SAME_PLACE = 1e-6
"""Distance of two nodes in shortest sides of a cell, below which they are one."""


@dataclass(frozen=True)
class HalfCylinder:
    """Half cylinder, held along its flat upper side.

    Parameters
    ----------
    radius : float
        R [m].
    edge_width : float
        Of the contact edge along x, the apex in its middle [m].

    Raises
    ------
    ValueError
        If a length is not positive or the contact edge is as wide as the body.
    """

    radius: Length
    edge_width: Length

    def __post_init__(self) -> None:
        check(self)
        refuse_wide_edge("HalfCylinder", self.edge_width, 2 * self.radius)

    @property
    def tip_radius(self) -> float:
        """R at the apex [m]."""
        return self.radius

    @property
    def area(self) -> float:
        """Area [m²]."""
        return pi * self.radius**2 / 2

    def mesh(self, density: MeshDensity) -> BodyMesh:
        """Columns above the contact edge, and on either side three blocks that meet in a point.

        Parameters
        ----------
        density : MeshDensity
            With more `flank_columns` than rows in the upper half of the body.

        Returns
        -------
        BodyMesh

        Raises
        ------
        ValueError
            If there are too few flank columns, or the cells would be too long for their width or too oblique.
        """
        x = even_positions(self.edge_width, density.edge_nodes)
        bottom = self._on_arc(np.arcsin(x / self.radius))
        top = level(x * (2 * TOP_SHARE * self.radius / self.edge_width), self.radius)
        first_height = density.height_at_edge(self.edge_width)
        middle = columns_between(bottom, top, first_height, density.rows)
        right = self._side_blocks(middle[:, -2:], density)
        left = [block[:, ::-1] * np.array([-1.0, 1.0]) for block in right]
        shortest = min(density.edge_spacing(self.edge_width), first_height)
        points, cells, nodes = join([middle, *right, *left], SAME_PLACE * shortest)
        held = np.flatnonzero(points[:, 1] >= self.radius * (1 - ON_TOP))
        return sound(BodyMesh(points, cells, nodes[0][0], held), "half cylinder", self.area)

    def _on_arc(self, angles: FloatArray) -> FloatArray:
        """Points of the round side by their angle from the apex."""
        # 1 - cos without the difference of near numbers.
        height = 2 * self.radius * np.sin(angles / 2) ** 2
        return np.stack([self.radius * np.sin(angles), height], axis=1)

    def _side_blocks(self, outermost: FloatArray, density: MeshDensity) -> list[FloatArray]:
        """Three blocks between the last column of the middle, the round and the held side, around one inner point.

        Parameters
        ----------
        outermost : ndarray, shape (rows + 1, 2, 2)
            The last two columns of the middle.
        density : MeshDensity

        Returns
        -------
        list of ndarray, shape (rows + 1, columns + 1, 2)
        """
        column = outermost[:, 1]
        depth = np.hypot(*(column - column[0]).T)
        upper = max(density.rows - int(np.flatnonzero(depth <= INNER_POINT * depth[-1])[-1]), 2)
        lower, along = density.rows - upper, density.flank_columns - upper
        if along < 1 or lower < 1:
            raise ValueError(
                f"HalfCylinder: {density.rows} rows and {density.flank_columns} flank columns leave a block on the "
                f"sides without cells; set rows to at least 3 and flank_columns to at least {upper + 1}"
            )
        widths = np.hypot(*(outermost[:, 1] - outermost[:, 0]).T)
        start = asin(self.edge_width / 2 / self.radius)
        angles = graded(widths[0] / self.radius, pi / 2 - start, density.flank_columns, even=upper)
        arc = self._on_arc(start + angles)
        meeting_top = column[-1] + MEETING * (arc[-1] - column[-1])
        centre = (column[lower] + arc[along] + meeting_top) / 3
        from_column = _straight(column[lower], centre, widths[lower], along)
        held = _straight(column[-1], meeting_top, widths[-1], along)
        first_height = density.height_at_edge(self.edge_width)
        to_centre = _straight(arc[along], centre, first_height, lower)
        from_centre = _straight(centre, meeting_top, np.inf, upper)
        # Between the heights at the contact edge and even ones, since nothing fine is needed in the corner.
        corner_height = float(np.sqrt(first_height * np.hypot(*(arc[-1] - meeting_top)) / lower))
        corner = _straight(arc[-1], meeting_top, corner_height, lower)
        return [
            transfinite(arc[: along + 1], from_column, column[: lower + 1], to_centre),
            transfinite(from_column, held, column[lower:], from_centre),
            transfinite(arc[along:], from_centre, to_centre, corner),
        ]


def _straight(start: FloatArray, end: FloatArray, first: float, cells: int) -> FloatArray:
    """Points on a line, shape (cells + 1, 2), the first cell of a given length, or all even where that is too long."""
    length = float(np.hypot(*(end - start)))
    return start + (end - start) * (graded(min(first, length), length, cells) / length)[:, None]
