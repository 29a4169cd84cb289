"""A soft body in plane strain: nodal forces of a displacement, and their derivative.

Bilinear quads with a volume change of their own (Simo, Taylor and Pister 1985). With F the deformation gradient,
P the isochoric part of the first Piola–Kirchhoff stress (the material's), J = det F, and v, V the deformed and
reference volumes of what shares one volume change (softlub.solid.elements), the nodal forces are

    f = ∫ P : ∂F/∂u dV + K (v/V - 1) h,    h = ∂v/∂u,

the derivative of the energy ∫ W_iso dV + Σ V K (v/V - 1)²/2. Their tangent is

    ∫ ∂F/∂u : ∂P/∂F : ∂F/∂u dV + (K/V) h hᵀ + p ∂²v/∂u²,    p = K (v/V - 1).

In the last term alone, p is taken from the volume as the latest change of displacement predicts it linearly,
v(u₀) + h(u₀)·(u - u₀): K is a thousand times the shear modulus, so that the curvature of v(u) over one Newton step
would swamp the shear stiffness and the iteration diverge. Evaluated twice at one displacement, the tangent is exact.

felupe supplies shape functions, quadrature and materials. Integrating in the plane only, over index maps made once
(softlub.solid.assembly), is what its SolidBodyNearlyIncompressible does in 0.55 of the time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

import felupe
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from softlub.solid.assembly import Assembly
from softlub.solid.elements import ELEMENTS, ElementInverted

if TYPE_CHECKING:
    from softlub.solid.mesh import BodyMesh

FloatArray = NDArray[np.float64]

SECOND_VOLUME_DERIVATIVE = np.array([[0.0, 1.0], [-1.0, 0.0]])
"""ε of ∂²J/∂F_iJ ∂F_kL = ε_ik ε_JL, which in the plane depends on no deformation."""


class BodyMaterial(Protocol):
    """What the body asks of a material."""

    @property
    def shear_modulus(self) -> float:
        """G [Pa], against hourglass modes."""
        ...

    @property
    def bulk_modulus(self) -> float:
        """K [Pa] of the volumetric energy K (J - 1)²/2."""
        ...

    def element_material(self) -> Any:
        """felupe material of the isochoric part: ``gradient([F, state])``, ``hessian([F, state])``, the state empty."""
        ...


@runtime_checkable
class RemembersStrain(Protocol):
    """Element material whose stress depends on the strains of earlier increments."""

    def begin_increment(self, duration: float) -> None:
        """Set the duration [s] of the increment that follows."""
        ...

    def accept(self) -> None:
        """Take the last evaluation as the increment's end."""
        ...

    def checkpoint(self) -> Any:
        """The history so far."""
        ...

    def restore(self, checkpoint: Any) -> None:
        """Go back to a history."""
        ...


@dataclass(frozen=True, eq=False)
class Evaluation:
    """What the last displacement gave; arrays end in (points q or groups g, elements m)."""

    element_displacement: FloatArray  # (4, 2, m)
    deformation_gradient: FloatArray  # (3, 3, q, m)
    stress: FloatArray  # isochoric, (3, 3, q, m)
    volume_gradient: FloatArray  # h, (4, 2, g, m)
    volume_change: FloatArray  # v/V - 1, (g, m)
    lagged_pressure: FloatArray  # (g, m)


class Body:
    """Finite elements of a body, held nodes included.

    Parameters
    ----------
    mesh : BodyMesh
    material : BodyMaterial
    element : str, optional
        One of `softlub.solid.elements.ELEMENTS`.

    Raises
    ------
    ValueError
        If there is no such element.

    Attributes
    ----------
    evaluations, assemblies : int
        Forces and tangents made so far.
    """

    def __init__(self, mesh: BodyMesh, material: BodyMaterial, element: str = "mean_dilatation") -> None:
        if element not in ELEMENTS:
            raise ValueError(f"Body: element = {element!r} must be one of {', '.join(ELEMENTS)}")
        self.mesh = mesh
        self.material = material
        self.element = ELEMENTS[element]
        self.evaluations = 0
        self.assemblies = 0
        self._material = material.element_material()
        self._bulk_modulus = material.bulk_modulus
        self._assembly = Assembly(mesh.cells, len(mesh.points))
        region = felupe.RegionQuad(
            felupe.Mesh(mesh.points, mesh.cells, "quad"),
            quadrature=felupe.GaussLegendre(order=self.element.quadrature_order, dim=2),
        )
        self._gradients: FloatArray = region.dhdX  # (4, 2, q, m)
        self._areas: FloatArray = region.dV  # (q, m)
        self._weighted: FloatArray = region.dhdX * region.dV
        self._volumes = self.element.pooled(self._areas)  # (g, m)
        self._no_state = np.zeros((0, *self._areas.shape))
        self._hourglass = material.shear_modulus * self.element.hourglass_stiffness(
            mesh.points[mesh.cells].transpose(1, 2, 0), self._gradients, self._areas
        )
        self._volume_curvature = self.element.pooled(
            np.einsum("JL,aJqm,bLqm->abqm", SECOND_VOLUME_DERIVATIVE, self._weighted, self._gradients)
        )
        self._last = self._evaluate(np.zeros((4, 2, len(mesh.cells))), None)

    def forces(self, displacement: FloatArray) -> FloatArray:
        """Internal nodal forces.

        Parameters
        ----------
        displacement : ndarray, shape (n, 2)
            Of all nodes [m].

        Returns
        -------
        ndarray, shape (2n,)
            What the nodes must be pushed with, at 2 node + component [N/m].

        Raises
        ------
        ElementInverted
            Naming the element and where it is; the state stays that of the last evaluation.
        """
        element_displacement = displacement[self.mesh.cells].transpose(1, 2, 0)
        self._last = last = self._evaluate(element_displacement, self._last)
        self.evaluations += 1
        forces = np.einsum("iJqm,aJqm->aim", last.stress[:2, :2], self._weighted)
        pressure = self._bulk_modulus * last.volume_change
        forces += np.einsum("gm,aigm->aim", pressure, last.volume_gradient)
        forces += np.einsum("abm,bim->aim", self._hourglass, element_displacement)
        return self._assembly.vector(forces)

    def tangent(self) -> csr_matrix:
        """Derivative of the nodal forces at the last displacement (the lagged pressure: see the module).

        Returns
        -------
        csr_matrix, shape (2n, 2n)
            Symmetric [N/m²]; its pattern is the same every time.
        """
        last = self._last
        self.assemblies += 1
        moduli = self._material.hessian([last.deformation_gradient, self._no_state])[0][:2, :2, :2, :2]
        half = np.einsum("aJqm,iJkLqm->aikLqm", self._weighted, moduli)
        stiffness = np.einsum("aikLqm,bLqm->aibkm", half, self._gradients)
        push = last.volume_gradient * (self._bulk_modulus / self._volumes)
        stiffness += np.einsum("aigm,bkgm->aibkm", push, last.volume_gradient)
        curvature = np.einsum("gm,abgm->abm", last.lagged_pressure, self._volume_curvature)
        stiffness[:, 0, :, 1] += curvature
        stiffness[:, 1, :, 0] -= curvature
        stiffness[:, 0, :, 0] += self._hourglass
        stiffness[:, 1, :, 1] += self._hourglass
        return self._assembly.matrix(stiffness)

    def tangent_at(self, displacement: FloatArray) -> csr_matrix:
        """Exact derivative of the nodal forces at a displacement, no pressure lagging behind.

        Parameters
        ----------
        displacement : ndarray, shape (n, 2)
            Of all nodes [m].

        Returns
        -------
        csr_matrix, shape (2n, 2n)
            As `tangent` returns it.
        """
        self.forces(displacement)
        self.forces(displacement)
        return self.tangent()

    def stress(self) -> FloatArray:
        """Cauchy stress at the last displacement, mean over each element.

        Returns
        -------
        ndarray, shape (m, 3, 3)
            Stress [Pa]; tension is positive.
        """
        last = self._last
        ratio = np.linalg.det(last.deformation_gradient.transpose(2, 3, 0, 1))
        isochoric = np.einsum("iJqm,kJqm->ikqm", last.stress, last.deformation_gradient) / ratio
        mean = np.einsum("ikqm,qm->mik", isochoric, self._areas) / self._areas.sum(axis=0)[:, None, None]
        pressure = self._bulk_modulus * np.mean(last.volume_change, axis=0)
        return mean + pressure[:, None, None] * np.eye(3)

    def begin_increment(self, duration: float) -> None:
        """Set the duration [s] of the increment that follows; nothing to a material without memory."""
        if isinstance(self._material, RemembersStrain):
            self._material.begin_increment(duration)

    def accept(self) -> None:
        """Take the last displacement as the increment's end."""
        if isinstance(self._material, RemembersStrain):
            self._material.accept()

    def checkpoint(self) -> tuple[Evaluation, Any]:
        """All that the past has left behind, for `restore`."""
        remembers = isinstance(self._material, RemembersStrain)
        return self._last, self._material.checkpoint() if remembers else None

    def restore(self, checkpoint: tuple[Evaluation, Any]) -> None:
        """Go back to a checkpoint, as if nothing had been evaluated since."""
        self._last, history = checkpoint
        if isinstance(self._material, RemembersStrain):
            self._material.restore(history)

    def _evaluate(self, element_displacement: FloatArray, before: Evaluation | None) -> Evaluation:
        slope = np.einsum("aim,aJqm->iJqm", element_displacement, self._gradients)
        # J - 1 without forming J: at small strain the difference of the two would be mostly rounding.
        growth = slope[0, 0] + slope[1, 1] + slope[0, 0] * slope[1, 1] - slope[0, 1] * slope[1, 0]
        self._refuse_inverted(growth)
        deformation_gradient = np.zeros((3, 3, *growth.shape))
        deformation_gradient[:2, :2] = slope
        for i in range(3):
            deformation_gradient[i, i] += 1
        volume_gradient = self._volume_gradient(deformation_gradient)
        volume_change = self.element.pooled(growth * self._areas) / self._volumes
        predicted = volume_change
        if before is not None:
            step = element_displacement - before.element_displacement
            opened = np.einsum("aigm,aim->gm", before.volume_gradient, step)
            predicted = before.volume_change + opened / self._volumes
        return Evaluation(
            element_displacement,
            deformation_gradient,
            self._material.gradient([deformation_gradient, self._no_state])[0],
            volume_gradient,
            volume_change,
            self._bulk_modulus * predicted,
        )

    def _volume_gradient(self, deformation_gradient: FloatArray) -> FloatArray:
        """h = ∫ ∂J/∂F : ∂F/∂u dV, shape (4, 2, g, m)."""
        f = deformation_gradient
        cofactor = np.stack([np.stack([f[1, 1], -f[1, 0]]), np.stack([-f[0, 1], f[0, 0]])])
        return self.element.pooled(np.einsum("iJqm,aJqm->aiqm", cofactor, self._weighted))

    def _refuse_inverted(self, growth: FloatArray) -> None:
        sound = growth > -1
        if np.all(sound):
            return
        worst = int(np.argmin(sound.all(axis=0)))
        x, y = self.mesh.points[self.mesh.cells[worst]].mean(axis=0)
        raise ElementInverted(f"element {worst} near x = {x:.3g} m, y = {y:.3g} m is turned inside out")
