"""The rigid plate under the body: nodal contact forces in steady sliding, and their derivative.

The plate is level, at height d, and moves in +x; the body's holder stands still. Each node of the contact edge has
the gap g = y + u_y - d and carries the pressure of the law over the length w along the edge that it stands for in the
reference state: N = w p(g) upwards. In steady sliding every node slips, and slips one way: the plate drags it by μN
towards +x, without any state of sticking. The force follows the gap alone, so that the derivative has entries in the
columns of u_y only, and friction makes it unsymmetric.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from softlub.solid.plate_laws import HardContact, NormalLaw

if TYPE_CHECKING:
    from softlub.solid.mesh import BodyMesh

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PlateForces:
    """What the plate does to the nodes of the contact edge.

    Attributes
    ----------
    gap : ndarray, shape (k,)
        Between node and plate [m].
    pressure : ndarray, shape (k,)
        On the reference length [Pa].
    normal, shear : ndarray, shape (k,)
        Nodal forces on the body, upwards and along +x [N/m].
    stiffness : ndarray, shape (k,)
        -dN/dg [N/m²].
    friction : float
        μ, shear over normal at every node.
    """

    gap: FloatArray
    pressure: FloatArray
    normal: FloatArray
    shear: FloatArray
    stiffness: FloatArray
    friction: float

    @property
    def load(self) -> float:
        """W = Σ N [N/m]."""
        return float(self.normal.sum())

    def components(self) -> FloatArray:
        """Nodal forces as the edge's degrees of freedom are ordered, x0, y0, x1, y1, ... [N/m], shape (2k,)."""
        return np.column_stack([self.shear, self.normal]).ravel()


@dataclass(frozen=True, eq=False)
class PlateContact:
    """Contact of the body's edge with the plate in steady sliding.

    Parameters
    ----------
    law : NormalLaw, optional
        Pressure over the gap.
    friction : float, optional
        Coulomb's coefficient μ; the plate moves in +x, a negative one stands for motion in -x.

    Raises
    ------
    ValueError
        If the friction coefficient is not a finite number.
    """

    law: NormalLaw = field(default_factory=HardContact)
    friction: float = 0.0

    def __post_init__(self) -> None:
        if not np.isfinite(self.friction):
            raise ValueError(f"PlateContact: friction = {self.friction:g} must be a finite number")

    def forces(self, mesh: BodyMesh, displacement: FloatArray, height: float) -> PlateForces:
        """Contact forces on the edge nodes.

        Parameters
        ----------
        mesh : BodyMesh
        displacement : ndarray, shape (n, 2)
            Of all nodes [m].
        height : float
            Of the plate, d [m].

        Returns
        -------
        PlateForces
        """
        gap = mesh.points[mesh.edge, 1] + displacement[mesh.edge, 1] - height
        pressure, steepness = self.law.pressure_and_stiffness(gap)
        normal = mesh.edge_widths * pressure
        return PlateForces(
            gap, pressure, normal, self.friction * normal, mesh.edge_widths * steepness, self.friction
        )
