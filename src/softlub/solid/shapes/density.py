"""How fine a body is meshed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from softlub.units import Length, Unit, check

ROUNDING = 1e-9
"""Relative difference below which two lengths are the same."""

Count = Annotated[int, Unit("1", at_least=1)]


@dataclass(frozen=True)
class MeshDensity:
    """Numbers of nodes and cells of a block-structured mesh.

    Parameters
    ----------
    edge_nodes : int
        Nodes of the contact edge, evenly spaced in x; the apex is among them where their number is odd.
    rows : int
        Cells from the contact edge up to the holder.
    first_height : float, optional
        Height of the cells at the contact edge [m]; as wide as high where it is left out. Heights grow from there in
        a constant ratio.
    flank_columns : int
        Cells from either end of the contact edge to the side of the body.

    Raises
    ------
    ValueError
        If a number of nodes or cells is too small or a height is not positive.
    """

    edge_nodes: Annotated[int, Unit("1", at_least=3)] = 513
    rows: Annotated[int, Unit("1", at_least=2)] = 11
    first_height: Length | None = None
    flank_columns: Count = 30

    def __post_init__(self) -> None:
        check(self)

    def edge_spacing(self, edge_width: float) -> float:
        """Distance of neighbouring edge nodes along x [m]."""
        return edge_width / (self.edge_nodes - 1)

    def height_at_edge(self, edge_width: float) -> float:
        """Height of the cells at the contact edge [m]."""
        return self.edge_spacing(edge_width) if self.first_height is None else self.first_height


def refuse_wide_edge(shape: str, edge_width: float, width: float) -> None:
    """Refuse a contact edge that leaves nothing of the body on either side of it.

    Parameters
    ----------
    shape : str
        Name of the shape, for the message.
    edge_width, width : float
        Of the contact edge and of the body [m].

    Raises
    ------
    ValueError
        If the contact edge is as wide as the body but for rounding, or wider.
    """
    if edge_width >= width * (1 - ROUNDING):
        raise ValueError(
            f"{shape}: the contact edge, {edge_width:g} m wide, is not narrower than the body, {width:g} m; make the "
            "edge narrower or the body wider"
        )
