"""The body as its contact edge feels it: reduced stiffness at the initial or at a deformed state (section 5.3).

The tangent stiffness of all free degrees of freedom is condensed onto those of the contact edge. About the base
state, where the edge carries the nodal forces F0,

    K_r (u - u0) = F - F0    (equation 5-3),

exact for small steps: the error falls in proportion to the step of the load. The contact with the plate is no part of
the body, so it is released of itself; `with_contact` keeps it, for figure 5-10. K_r of a
viscoelastic body at a frequency is that of the elastic one with the storage modulus there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike
from scipy import linalg, sparse

from softlub.protocols import FloatArray
from softlub.solid.dissection import IntArray
from softlub.solid.reduction import condense

if TYPE_CHECKING:
    import xarray as xr

    from softlub.solid.body import Body

COMPONENTS = ("x", "y")
OUT_OF_BALANCE = 1e-3
"""Largest force on a node off the edge, over the largest on the edge, in a base state that counts as in balance."""


@dataclass(frozen=True, eq=False)
class ReducedStiffness:
    """Tangent stiffness of a body's k edge nodes about a base state.

    Parameters
    ----------
    positions : ndarray, shape (k,)
        x of the edge nodes in the base state [m].
    widths : ndarray, shape (k,)
        Length along x that each stands for in the reference state [m].
    stiffness : ndarray, shape (2k, 2k)
        K_r, ordered x0, y0, x1, y1, … [N/m²].
    base_gap : ndarray, shape (k,)
        Height above the lowest edge node in the base state [m].
    base_force : ndarray, shape (k, 2)
        F0, what the edge nodes are pushed with in the base state [N/m].
    base_displacement : ndarray, shape (k, 2)
        u0, from the reference to the base state with the holder at rest [m].

    Raises
    ------
    ValueError
        If the shapes do not fit together.
    """

    positions: FloatArray
    widths: FloatArray
    stiffness: FloatArray
    base_gap: FloatArray
    base_force: FloatArray
    base_displacement: FloatArray

    def __post_init__(self) -> None:
        count = self.positions.size
        wanted = {
            "widths": (count,),
            "stiffness": (2 * count, 2 * count),
            "base_gap": (count,),
            "base_force": (count, 2),
            "base_displacement": (count, 2),
        }
        for name, shape in wanted.items():
            found = getattr(self, name).shape
            if found != shape:
                raise ValueError(
                    f"ReducedStiffness: {name} of shape {found} must be {shape} for {count} nodes"
                )

    @classmethod
    def of(
        cls,
        body: Body,
        displacement: FloatArray | None = None,
    ) -> ReducedStiffness:
        """Condense a body, which is left as it was.

        Parameters
        ----------
        body : Body
        displacement : ndarray, shape (n, 2), optional
            Base state of all nodes [m], in balance with forces on the edge alone; by default the initial state.

        Raises
        ------
        ValueError
            If the displacement has another shape or nodes off the edge carry forces.
        SingularInteriorError
            If a part of the body is not held.
        """
        mesh = body.mesh
        base = np.zeros_like(mesh.points) if displacement is None else np.asarray(displacement, dtype=float)
        if base.shape != mesh.points.shape:
            raise ValueError(
                f"a displacement of shape {base.shape} does not fit nodes of {mesh.points.shape}"
            )
        forces, tangent = _tangent_at(body, base)
        if displacement is not None:
            _check_balance(forces, mesh.free_dofs, mesh.edge_dofs)
        free = mesh.free_dofs
        kept = np.searchsorted(free, mesh.edge_dofs)
        place = (mesh.points + base)[mesh.edge]
        return cls(
            positions=place[:, 0],
            widths=mesh.edge_widths,
            stiffness=condense(tangent[free][:, free], kept),
            base_gap=place[:, 1] - place[:, 1].min(),
            base_force=forces[mesh.edge_dofs].reshape(-1, 2),
            base_displacement=base[mesh.edge],
        )

    def with_contact(self, stiffness: FloatArray, friction: float = 0.0) -> ReducedStiffness:
        """The matrix as it is where the contact with the plate is not released, as in the source's figure 5-10.

        A node that moves up by du opens its gap and is pushed by N' du less, N' = -dN/dg, and in steady sliding dragged
        by μN' du less. Only kept degrees of freedom meet these, so that adding them before the condensation or
        afterwards is the same.

        Parameters
        ----------
        stiffness : ndarray, shape (k,)
            N' of every node in the base state, as `PlateForces.stiffness` gives it [N/m²].
        friction : float, optional
            μ.

        Returns
        -------
        ReducedStiffness
        """
        along, upwards = np.arange(0, 2 * self.positions.size, 2), np.arange(1, 2 * self.positions.size, 2)
        whole = self.stiffness.copy()
        whole[upwards, upwards] += stiffness
        whole[along, upwards] += friction * stiffness
        return replace(self, stiffness=whole)

    @cached_property
    def _factors(self) -> tuple[FloatArray, FloatArray]:
        factors: tuple[FloatArray, FloatArray] = linalg.lu_factor(self.stiffness)
        return factors

    def response(self, forces: FloatArray) -> FloatArray:
        """K_r⁻¹ times changes of the nodal forces.

        Parameters
        ----------
        forces : ndarray, shape (2k,) or (2k, m)
            Ordered as `stiffness` [N/m].

        Returns
        -------
        ndarray
            Changes of the displacement, of the same shape [m].
        """
        moved: FloatArray = linalg.lu_solve(self._factors, forces)
        return moved

    def displacement(self, nodal_forces: ArrayLike) -> FloatArray:
        """Elastic displacement from the base state under given nodal forces (equation 5-3).

        Parameters
        ----------
        nodal_forces : array_like, shape (k, 2)
            What the edge nodes are pushed with, all of it: the base state's part is subtracted here [N/m].

        Returns
        -------
        ndarray, shape (k, 2)
            u - u0, with the holder at rest [m].

        Raises
        ------
        ValueError
            If there is not one force of two components for every edge node.
        """
        forces = np.asarray(nodal_forces, dtype=float)
        if forces.shape != self.base_force.shape:
            raise ValueError(
                f"nodal forces of shape {forces.shape} do not fit {self.positions.size} edge nodes: give them as "
                f"{self.base_force.shape}, one row (x, y) a node"
            )
        change = forces - self.base_force
        return self.response(change.ravel()).reshape(-1, 2)

    def dataset(self) -> xr.Dataset:
        """As a dataset, over ``node`` and ``component`` (x, y); `from_dataset` takes it back."""
        import xarray as xr

        from softlub.datasets.store import describe

        count = self.positions.size
        both = ("node", "component")
        return describe(
            xr.Dataset(
                {
                    "stiffness": (
                        (*both, "node_pushed", "component_pushed"),
                        self.stiffness.reshape(count, 2, count, 2),
                    ),
                    "base_gap": ("node", self.base_gap),
                    "node_width": ("node", self.widths),
                    "nodal_force": (both, self.base_force),
                    "displacement": (both, self.base_displacement),
                },
                coords={
                    "x": ("node", self.positions),
                    "component": list(COMPONENTS),
                    "component_pushed": list(COMPONENTS),
                },
            )
        )

    @classmethod
    def from_dataset(cls, dataset: xr.Dataset) -> ReducedStiffness:
        """Out of what `dataset` made."""
        count = dataset.sizes["node"]
        return cls(
            positions=dataset["x"].values,
            widths=dataset["node_width"].values,
            stiffness=dataset["stiffness"].values.reshape(2 * count, 2 * count),
            base_gap=dataset["base_gap"].values,
            base_force=dataset["nodal_force"].values,
            base_displacement=dataset["displacement"].values,
        )


def _tangent_at(body: Body, displacement: FloatArray) -> tuple[FloatArray, sparse.csr_array]:
    """Nodal forces and exact tangent of a state; the body forgets that it was asked."""
    before = body.checkpoint()
    try:
        tangent = sparse.csr_array(body.tangent_at(displacement))
        return body.forces(displacement), tangent
    finally:
        body.restore(before)


def _check_balance(forces: FloatArray, free: IntArray, edge: IntArray) -> None:
    """Refuse a base state in which more than the edge is loaded."""
    off_edge = np.setdiff1d(free, edge)
    largest = float(np.max(np.abs(forces[off_edge]), initial=0.0))
    on_edge = float(np.max(np.abs(forces[edge])))
    if largest > OUT_OF_BALANCE * on_edge:
        raise ValueError(
            f"the base state is out of balance: {largest:.3g} N/m on degree of freedom "
            f"{off_edge[np.argmax(np.abs(forces[off_edge]))]} off the contact edge, at most {on_edge:.3g} N/m on it; "
            "give a converged state"
        )
