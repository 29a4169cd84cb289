"""Isochoric responses as felupe's elements evaluate them.

A response is asked for its own stress and for that of a step of a viscoelastic material, which adds to it, at a
fixed history, the potential ½ J^(-2/3) M : C with a symmetric tensor M at every point:

    W = factor · W_iso(F) + ½ J^(-2/3) M : (FᵀF)

Since the neo-Hookean energy is itself of this form, M = G I, its step costs as much as the material alone.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.solid.materials.metric_energy import metric_elasticity, metric_stress

FloatArray = NDArray[np.float64]


class IsochoricResponse(ABC):
    """A felupe material without state, of which only the isochoric part is evaluated.

    Deformation gradients have the shape (3, 3, quadrature points, cells), all results likewise.
    """

    x: Sequence[FloatArray] = (np.eye(3), np.zeros(0))

    @abstractmethod
    def stress(
        self, deformation: FloatArray, factor: float = 1.0, metric: FloatArray | None = None
    ) -> FloatArray:
        """First Piola–Kirchhoff stress ∂W/∂F [Pa].

        Parameters
        ----------
        deformation : ndarray, shape (3, 3, q, c)
            F.
        factor : float, optional
            Multiplies the response's own energy.
        metric : ndarray, shape (3, 3, q, c), optional
            M [Pa], symmetric; none without it.

        Returns
        -------
        ndarray, shape (3, 3, q, c)
        """

    @abstractmethod
    def elasticity(
        self, deformation: FloatArray, factor: float = 1.0, metric: FloatArray | None = None
    ) -> FloatArray:
        """Derivative ∂²W/∂F∂F of the stress [Pa], shape (3, 3, 3, 3, q, c); parameters as in `stress`."""

    def gradient(self, x: Sequence[Any]) -> list[Any]:
        """What felupe asks for: the stress at [F, state variables], and the state variables as they are."""
        return [self.stress(x[0]), x[-1]]

    def hessian(self, x: Sequence[Any]) -> list[FloatArray]:
        """What felupe asks for: the elasticity at [F, state variables]."""
        return [self.elasticity(x[0])]


class IsochoricNeoHooke(IsochoricResponse):
    """W_iso = (G/2) (J^(-2/3) tr C - 3).

    Parameters
    ----------
    shear_modulus : float
        G [Pa].
    """

    def __init__(self, shear_modulus: float) -> None:
        self.shear_modulus = shear_modulus

    def stress(
        self, deformation: FloatArray, factor: float = 1.0, metric: FloatArray | None = None
    ) -> FloatArray:
        """First Piola–Kirchhoff stress; see `IsochoricResponse`."""
        return metric_stress(deformation, factor * self.shear_modulus, metric)

    def elasticity(
        self, deformation: FloatArray, factor: float = 1.0, metric: FloatArray | None = None
    ) -> FloatArray:
        """Derivative of the stress; see `IsochoricResponse`."""
        return metric_elasticity(deformation, factor * self.shear_modulus, metric)


class IsochoricEnergy(IsochoricResponse):
    """A response given by its energy, which felupe differentiates with tensortrax.

    Parameters
    ----------
    energy : callable
        Isochoric energy over C and the constants, in tensortrax's functions.
    constants : float
        Keyword arguments of the energy [Pa].
    """

    def __init__(self, energy: Callable[..., Any], **constants: float) -> None:
        from felupe.constitution.tensortrax import Hyperelastic

        self._material = Hyperelastic(energy, **constants)

    def stress(
        self, deformation: FloatArray, factor: float = 1.0, metric: FloatArray | None = None
    ) -> FloatArray:
        """First Piola–Kirchhoff stress; see `IsochoricResponse`."""
        own = self._material.gradient([deformation, None])[0]
        if factor != 1.0:
            own *= factor
        return own if metric is None else own + metric_stress(deformation, 0.0, metric)

    def elasticity(
        self, deformation: FloatArray, factor: float = 1.0, metric: FloatArray | None = None
    ) -> FloatArray:
        """Derivative of the stress; see `IsochoricResponse`."""
        own = self._material.hessian([deformation, None])[0]
        if factor != 1.0:
            own *= factor
        return own if metric is None else own + metric_elasticity(deformation, 0.0, metric)
