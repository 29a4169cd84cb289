"""The plane slider: a film that narrows linearly from inlet to outlet, without pressure at both ends.

With h(x) = h₁ + (h₂ - h₁) x/B the Reynolds equation integrates to p = 6ηvB (h₁ - h)(h - h₂)/(h² (h₁² - h₂²)).
See e.g. B. J. Hamrock, S. R. Schmid, B. O. Jacobson, Fundamentals of Fluid Film Lubrication, chapter 8.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class LinearSlider:
    """Plane slider of unit width.

    Parameters
    ----------
    inlet : float
        h₁ at x = 0 [m]; more than `outlet`.
    outlet : float
        h₂ at x = B [m].
    length : float
        B [m].
    viscosity : float
        η [Pa s].
    speed : float
        v of the wall [m/s].
    """

    inlet: float
    outlet: float
    length: float
    viscosity: float
    speed: float

    def separation(self, position: FloatArray) -> FloatArray:
        """h [m] at positions in [0, B] [m]."""
        return self.inlet + (self.outlet - self.inlet) * position / self.length

    def pressure(self, position: FloatArray) -> FloatArray:
        """p [Pa] at positions in [0, B] [m]."""
        film = self.separation(position)
        scale = 6 * self.viscosity * self.speed * self.length / (self.inlet**2 - self.outlet**2)
        return scale * (self.inlet - film) * (film - self.outlet) / film**2

    @property
    def load(self) -> float:
        """∫ p dx = 6ηvB²/(h₁ - h₂)² [ln(h₁/h₂) - 2(h₁ - h₂)/(h₁ + h₂)] [N/m]."""
        fall = self.inlet - self.outlet
        bracket = np.log(self.inlet / self.outlet) - 2 * fall / (self.inlet + self.outlet)
        return float(6 * self.viscosity * self.speed * (self.length / fall) ** 2 * bracket)

    @property
    def friction(self) -> float:
        """Drag on the moving wall, ηvB/(h₁ - h₂) [4 ln(h₁/h₂) - 6(h₁ - h₂)/(h₁ + h₂)] [N/m]."""
        fall = self.inlet - self.outlet
        bracket = 4 * np.log(self.inlet / self.outlet) - 6 * fall / (self.inlet + self.outlet)
        return float(self.viscosity * self.speed * self.length / fall * bracket)
