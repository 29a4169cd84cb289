"""The triangular specimen of the source's chapters 5 and 6: two flanks, a round tip and a block above them."""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, cos, pi, sin, sqrt, tan
from typing import Annotated

import numpy as np

from softlub.solid.blocks import level, one_block, symmetric_positions
from softlub.solid.mesh import BodyMesh, FloatArray
from softlub.solid.mesh_quality import sound
from softlub.solid.shapes.density import MeshDensity, refuse_wide_edge
from softlub.units import Length, Unit, check

SPREAD = 2.8
"""How much wider the middle columns are at the held side than at the apex, so that they become no needles."""
SPREAD_DECAY = 0.4
"""Exponent of the distance from the middle with which the spreading falls."""


@dataclass(frozen=True)
class TriangularSpecimen:
    """Triangular specimen, held along the upper side of its block.

    The source prints tip radius, width and edge width; flank angle and block height are assumed.

    Parameters
    ----------
    tip_radius : float
        R of the tip [m].
    width : float
        Of the block [m].
    flank_angle : float
        Between flank and plate [rad].
    block_height : float
        Of the upright sides above the flanks [m].
    edge_width : float
        Of the contact edge along x, the apex in its middle [m].

    Raises
    ------
    ValueError
        If a length is not positive, the angle not between 0 and π/2, the tip's circle does not fit between the flanks
        or the contact edge is as wide as the body.
    """

    tip_radius: Length = 0.2e-3
    width: Length = 7.5e-3
    flank_angle: Annotated[float, Unit("rad", above=0, below=pi / 2)] = pi / 4
    block_height: Length = 1.5e-3
    edge_width: Length = 1e-3

    def __post_init__(self) -> None:
        check(self)
        if 2 * self._tangent_point >= self.width:
            raise ValueError(
                f"TriangularSpecimen: tip_radius = {self.tip_radius:g} m does not fit between the flanks: its circle "
                f"would be {2 * self._tangent_point:g} m wide in a body of width = {self.width:g} m; allowed is a "
                f"tip_radius below {self.width / 2 / sin(self.flank_angle):.6g} m"
            )
        refuse_wide_edge("TriangularSpecimen", self.edge_width, self.width)

    @property
    def _tangent_point(self) -> float:
        """x where the tip's circle meets the flank [m]."""
        return self.tip_radius * sin(self.flank_angle)

    @property
    def height(self) -> float:
        """From the apex to the held side [m]."""
        return float(self.profile(np.array([self.width / 2]))[0]) + self.block_height

    @property
    def area(self) -> float:
        """Area [m²]."""
        radius, tangent, half = self.tip_radius, self._tangent_point, self.width / 2
        cap = (
            radius * tangent
            - (tangent * sqrt(radius**2 - tangent**2) + radius**2 * asin(tangent / radius)) / 2
        )
        rise = radius * (1 - cos(self.flank_angle))
        flank = rise * (half - tangent) + (half - tangent) ** 2 * tan(self.flank_angle) / 2
        return 2 * (half * self.height - cap - flank)

    def profile(self, positions: FloatArray) -> FloatArray:
        """Height of the lower side above the apex.

        Parameters
        ----------
        positions : ndarray, shape (k,)
            x within the width of the body [m].

        Returns
        -------
        ndarray, shape (k,)
            y [m].
        """
        away = np.abs(positions)
        round_part = np.minimum(away, self._tangent_point)
        # R - √(R² - x²) without the difference of near numbers.
        tip = round_part**2 / (self.tip_radius + np.sqrt(self.tip_radius**2 - round_part**2))
        return tip + (away - round_part) * tan(self.flank_angle)

    def mesh(self, density: MeshDensity) -> BodyMesh:
        """One block of columns from the tip and the flanks to the held side.

        Parameters
        ----------
        density : MeshDensity

        Returns
        -------
        BodyMesh

        Raises
        ------
        ValueError
            If the cells would be too long for their width or too oblique.
        """
        x = symmetric_positions(self.edge_width, density.edge_nodes, self.width, density.flank_columns)
        bottom = np.stack([x, self.profile(x)], axis=1)
        top = level(self._top_positions(x), self.height)
        mesh = one_block(bottom, top, self._first_heights(x, density), density.rows, density.flank_columns)
        return sound(mesh, "triangular specimen", self.area)

    def _top_positions(self, x: FloatArray) -> FloatArray:
        """x of the columns' upper ends: the middle spreads at the cost of the sides."""
        return x * (SPREAD - (SPREAD - 1) * np.abs(2 * x / self.width) ** SPREAD_DECAY)

    def _first_heights(self, x: FloatArray, density: MeshDensity) -> FloatArray:
        """Height of the lowest cells: constant over the edge, rising towards the side of the body."""
        half, half_edge = self.width / 2, self.edge_width / 2
        at_edge, even = density.height_at_edge(self.edge_width), self.block_height / density.rows
        at_side = np.sqrt(at_edge * max(even, at_edge))
        # The power leaves the rows without a kink where the edge ends.
        out = np.clip((np.abs(x) - half_edge) / (half - half_edge), 0, 1) ** 1.5
        return at_edge * (at_side / at_edge) ** out
