"""What `draft`, `standard` and `source` stand for: grids and domain.

Keys of nodes hold these numbers and not the name, so a panel is computed once whichever word asked for it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

AccuracyName = Literal["draft", "standard", "source"]
ACCURACIES: tuple[str, ...] = get_args(AccuracyName)


@dataclass(frozen=True)
class Accuracy:
    """Grids and domain of one level of accuracy.

    Parameters
    ----------
    spectral_order : int
        Polynomial order of the spectral elements.
    finite_volume_nodes, module_nodes : int
        Nodes of the finite volumes and of the source's modules.
    grid : {"graded", "even"}
        Spacing of those nodes.
    half_domain : float or None
        Half-width of the domain [m]; None leaves it to the problem: 64 Hertz half-widths or wider.
    surface_points : int
        Points along a side of the largest synthetic surface that is made.
    coarsened : bool
        Whether larger surfaces are made on as many points all the same, with the waves that those carry; else they
        are not made.
    averaged_points : int
        Points along a side of the largest surface that is made three times where a study names no number; larger
        ones are made once.
    contact_loads : int
        Loads of a rough contact from light to full contact.
    edge_nodes, mesh_rows, flank_columns : int
        Of a finite-element mesh: nodes of the contact edge, cells above it, cells to either side of it.
    """

    spectral_order: int
    finite_volume_nodes: int
    module_nodes: int
    grid: Literal["graded", "even"] = "graded"
    half_domain: float | None = None
    surface_points: int = 2048
    coarsened: bool = False
    averaged_points: int = 1024
    contact_loads: int = 20
    edge_nodes: int = 513
    mesh_rows: int = 11
    flank_columns: int = 30


PRESETS: dict[str, Accuracy] = {
    "draft": Accuracy(
        spectral_order=6,
        finite_volume_nodes=129,
        module_nodes=257,
        surface_points=256,
        coarsened=True,
        contact_loads=12,
        edge_nodes=129,
        mesh_rows=8,
        flank_columns=16,
    ),
    "standard": Accuracy(spectral_order=8, finite_volume_nodes=257, module_nodes=513),
    # The grid and the domain of the source's table 3-2, the largest surface of its table 4-2.
    "source": Accuracy(
        spectral_order=12,
        finite_volume_nodes=1025,
        module_nodes=1025,
        grid="even",
        half_domain=1e-3,
        surface_points=8192,
        averaged_points=8192,
    ),
}
