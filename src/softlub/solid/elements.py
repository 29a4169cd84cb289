"""Kinds of four-node plane-strain elements: where they are integrated and over what the volume change is averaged.

A nearly incompressible body locks when every quadrature point keeps its volume: four constraints an element are more
than its nodes can follow. The kinds differ in how they relax that; the rest of the element is one (softlub.solid.body).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

HOURGLASS_PATTERN = np.array([1.0, -1.0, 1.0, -1.0])
"""Nodal signs of the mode ξη, which one point in the middle does not see."""


class ElementInverted(RuntimeError):
    """An element is turned inside out, so that its material has no stress."""


class ElementKind(Protocol):
    """What the body asks of a kind of element."""

    @property
    def quadrature_order(self) -> int:
        """Order of the Gauss–Legendre rule as felupe counts it: 0 is one point, 1 is two by two."""
        ...

    def pooled(self, point_values: FloatArray) -> FloatArray:
        """Sums (..., g, m) of point values (..., q, m) over what shares one volume change."""
        ...

    def hourglass_stiffness(self, nodes: FloatArray, gradients: FloatArray, areas: FloatArray) -> FloatArray:
        """Nodal stiffness of each component per unit shear modulus, shape (4, 4, m).

        Parameters
        ----------
        nodes : ndarray, shape (4, 2, m)
            Reference positions [m].
        gradients : ndarray, shape (4, 2, q, m)
            Of the shape functions [1/m].
        areas : ndarray, shape (q, m)
            Of the quadrature points [m²].
        """
        ...


@dataclass(frozen=True)
class MeanDilatation:
    """Two by two points, one volume change an element: the mean dilatation of Nagtegaal, Parks and Rice.

    J. C. Nagtegaal, D. M. Parks, J. R. Rice, Comput. Methods Appl. Mech. Eng. 4 (1974) 153; in finite deformation
    J. C. Simo, R. L. Taylor, K. S. Pister, ibid. 51 (1985) 177.
    """

    quadrature_order: ClassVar[int] = 1

    def pooled(self, point_values: FloatArray) -> FloatArray:
        """Sum over the element, kept as one group."""
        return point_values.sum(axis=-2, keepdims=True)

    def hourglass_stiffness(self, nodes: FloatArray, gradients: FloatArray, areas: FloatArray) -> FloatArray:
        """None: two by two points see every mode."""
        return np.zeros((4, 4, nodes.shape[-1]))


@dataclass(frozen=True)
class FullIntegration:
    """Two by two points, each with its own volume change: locks when nearly incompressible, for comparison."""

    quadrature_order: ClassVar[int] = 1

    def pooled(self, point_values: FloatArray) -> FloatArray:
        """Each point by itself."""
        return point_values

    def hourglass_stiffness(self, nodes: FloatArray, gradients: FloatArray, areas: FloatArray) -> FloatArray:
        """None: two by two points see every mode."""
        return np.zeros((4, 4, nodes.shape[-1]))


@dataclass(frozen=True)
class ReducedIntegration:
    """One point in the middle, and a weak spring against the mode that it does not see.

    D. P. Flanagan, T. Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679. The hourglass mode's amplitude is
    γ·u with γ = (Γ - (Γ·X) ∂N/∂X)/4, Γ the alternating signs: zero for every linear displacement, so that neither
    rigid motion nor the patch test feels the spring, and the spring turns with the body. Its stiffness is
    `factor` times (4/3) G A Σ|∂N/∂X|², which at `factor` 1 is what two by two points give a rectangle
    of area A with the energy G|∂u/∂X|²/2.

    Parameters
    ----------
    factor : float, optional
        Part of the full stiffness; small, so that bending stays soft.
    """

    quadrature_order: ClassVar[int] = 0
    factor: float = 0.05

    def pooled(self, point_values: FloatArray) -> FloatArray:
        """The one point."""
        return point_values

    def hourglass_stiffness(self, nodes: FloatArray, gradients: FloatArray, areas: FloatArray) -> FloatArray:
        """factor (4/3) A Σ|∂N/∂X|² γ γᵀ."""
        middle = gradients[:, :, 0]
        moments = np.einsum("a,ajm->jm", HOURGLASS_PATTERN, nodes)
        mode = (HOURGLASS_PATTERN[:, None] - np.einsum("jm,ajm->am", moments, middle)) / 4
        stiffness = self.factor * (4 / 3) * areas[0] * np.einsum("ajm,ajm->m", middle, middle)
        return stiffness * mode[:, None] * mode[None]


ELEMENTS: dict[str, ElementKind] = {
    "mean_dilatation": MeanDilatation(),
    "reduced_integration": ReducedIntegration(),
    "full_integration": FullIntegration(),
}
"""Kinds by the names a study may write."""
