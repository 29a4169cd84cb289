"""Uniform tension of hyperelastic materials in plane strain, in closed form up to one scalar root.

A strip is stretched by λ along x, free along y and held along z: F = diag(λ, λ_y, 1), J = λ λ_y. With
W = W_iso(Ī1, Ī2) + K (J - 1)²/2, Ī1 = J^(-2/3) tr C, Ī2 = J^(-4/3) ((tr C)² - tr C²)/2 and W_i = ∂W_iso/∂Ī_i, the
principal Cauchy stresses are

    σ_k = (2/J) dev[(W_1 + Ī1 W_2) b̄_k - W_2 b̄_k²] + K (J - 1),   b̄_k = J^(-2/3) λ_k²,

dev subtracting the mean of the three (G. A. Holzapfel, Nonlinear Solid Mechanics (2000), section 6.4), and
λ_y follows from σ_y = 0. An incompressible material has λ_y = 1/λ and, if neo-Hookean, σ_x = G (λ² - λ^(-2)).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

FloatArray = NDArray[np.float64]

Slopes = Callable[[float, float], tuple[float, float]]
"""∂W_iso/∂Ī1 and ∂W_iso/∂Ī2 [Pa] over Ī1 and Ī2."""


def neo_hookean(c10: float) -> Slopes:
    """Slopes of W_iso = C10 (Ī1 - 3)."""
    return lambda first, second: (c10, 0.0)


def mooney_rivlin(c10: float, c01: float) -> Slopes:
    """Slopes of W_iso = C10 (Ī1 - 3) + C01 (Ī2 - 3)."""
    return lambda first, second: (c10, c01)


def yeoh(c10: float, c20: float, c30: float) -> Slopes:
    """Slopes of W_iso = C10 (Ī1 - 3) + C20 (Ī1 - 3)² + C30 (Ī1 - 3)³."""
    return lambda first, second: (c10 + 2 * c20 * (first - 3) + 3 * c30 * (first - 3) ** 2, 0.0)


def principal_stresses(slopes: Slopes, bulk_modulus: float, stretches: FloatArray) -> FloatArray:
    """Cauchy stresses along the principal directions.

    Parameters
    ----------
    slopes : callable
    bulk_modulus : float
        K [Pa]; 0 for the isochoric part alone.
    stretches : ndarray, shape (3,)
        Principal stretches.

    Returns
    -------
    ndarray, shape (3,)
        In Pa.
    """
    volume = float(np.prod(stretches))
    strain = stretches**2 * volume ** (-2 / 3)
    first = float(strain.sum())
    second = (first**2 - float((strain**2).sum())) / 2
    by_first, by_second = slopes(first, second)
    tension = (by_first + first * by_second) * strain - by_second * strain**2
    return 2 / volume * (tension - tension.mean()) + bulk_modulus * (volume - 1)


@dataclass(frozen=True)
class PlaneStrainTension:
    """State of a strip under uniform tension in plane strain.

    Parameters
    ----------
    slopes : callable
        Derivatives of the isochoric energy.
    bulk_modulus : float
        K [Pa].
    stretch : float
        λ along the strip.
    """

    slopes: Slopes
    bulk_modulus: float
    stretch: float

    @property
    def lateral_stretch(self) -> float:
        """λ_y of the free direction."""
        return float(
            brentq(
                lambda stretch: self._stresses(stretch)[1], 0.5 / self.stretch, 2 / self.stretch, xtol=1e-16
            )
        )

    @property
    def cauchy_stress(self) -> float:
        """σ_x [Pa]."""
        return float(self._stresses(self.lateral_stretch)[0])

    @property
    def held_stress(self) -> float:
        """σ_z in the direction that is held [Pa]."""
        return float(self._stresses(self.lateral_stretch)[2])

    @property
    def nominal_stress(self) -> float:
        """Force over reference area P = σ_x λ_y [Pa]."""
        lateral = self.lateral_stretch
        return float(self._stresses(lateral)[0]) * lateral

    @property
    def pressure(self) -> float:
        """K (J - 1): the mean stress [Pa]."""
        return self.bulk_modulus * (self.stretch * self.lateral_stretch - 1)

    def _stresses(self, lateral: float) -> FloatArray:
        return principal_stresses(self.slopes, self.bulk_modulus, np.array([self.stretch, lateral, 1.0]))


def incompressible_tension(shear_modulus: float, stretch: FloatArray) -> FloatArray:
    """Nominal stress G (λ - λ^(-3)) of an incompressible neo-Hookean strip in plane strain [Pa]."""
    return shear_modulus * (stretch - stretch**-3)
