"""A smooth wavy slider whose film ruptures and forms again, conserving mass (Jakobsson–Floberg–Olsson).

Film h(x) = h₀ [1 - ε cos(2πx/l - φ)] on 0 <= x <= B, flooded at x = 0, no pressure at either end. The first
wedge pressurises up to the rupture b, where p = dp/dx = 0; from there the film carries the flow v h(b)/2 at zero
pressure, in a part θ = h(b)/h of the gap. Where the gap narrows again it forms anew at f. Since the flow is one,
dp/dx = 6ηv (h - h(b))/h³ in both pressurised parts, and b and f are the roots of two scalar equations

    ∫_0^b (h - h(b))/h³ dx = 0,        ∫_f^B (h - h(b))/h³ dx = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

FloatArray = NDArray[np.float64]

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(80)


@dataclass(frozen=True)
class WavySlider:
    """Two wedges with a pocket between them: h = h₀ (1 - ε cos(2πx/l - φ)).

    Parameters
    ----------
    mean_separation : float
        h₀ [m].
    relative_amplitude : float
        ε in (0, 1).
    wavelength : float
        l [m].
    phase : float
        φ in (0, π): the first neck lies at x = φl/(2π).
    length : float
        B [m]: it ends within the second wedge, where the gap is narrower than at the rupture.
    viscosity : float
        η [Pa s].
    speed : float
        v of the wall [m/s].

    Raises
    ------
    ValueError
        If the second wedge is too short for the film to form again, or the slider reaches beyond it.
    """

    mean_separation: float
    relative_amplitude: float
    wavelength: float
    phase: float
    length: float
    viscosity: float
    speed: float

    def __post_init__(self) -> None:
        shortest = 2 * self.neck + self.wavelength - self.rupture_position
        longest = self.neck + self.wavelength
        if not shortest < self.length <= longest:
            raise ValueError(
                f"length {self.length:g} m must lie above {shortest:g} m and not beyond the neck at {longest:g} m"
            )

    def separation(self, position: FloatArray | float) -> FloatArray:
        """h [m] at positions in [0, B] [m]."""
        angle = 2 * np.pi * np.asarray(position) / self.wavelength - self.phase
        return self.mean_separation * (1 - self.relative_amplitude * np.cos(angle))

    @property
    def neck(self) -> float:
        """Where the first wedge is narrowest [m]."""
        return self.phase / (2 * np.pi) * self.wavelength

    @cached_property
    def rupture_position(self) -> float:
        """b [m]: behind the neck, before the gap is as wide as at the inlet."""
        return float(
            brentq(lambda b: self._rise(0.0, b, self.separation(b)), self.neck, 2 * self.neck, xtol=1e-16)
        )

    @cached_property
    def reformation_position(self) -> float:
        """f [m]: in the second wedge, where the gap is wider than at the rupture."""
        widest = self.neck + self.wavelength / 2
        return float(
            brentq(
                lambda f: self._rise(f, self.length, self.separation(self.rupture_position)),
                widest,
                2 * self.neck + self.wavelength - self.rupture_position,
                xtol=1e-16,
            )
        )

    def pressure(self, position: FloatArray) -> FloatArray:
        """p [Pa] at positions in [0, B] [m]."""
        film = self.separation(self.rupture_position)
        scale = 6 * self.viscosity * self.speed
        values = np.zeros(np.shape(position))
        for index, x in np.ndenumerate(position):
            if x < self.rupture_position:
                values[index] = scale * self._rise(0.0, x, film)
            elif x > self.reformation_position:
                values[index] = -scale * self._rise(x, self.length, film)
        return values

    def filling(self, position: FloatArray) -> FloatArray:
        """θ: part of the gap that is filled, one in the pressurised parts."""
        ruptured = (position > self.rupture_position) & (position < self.reformation_position)
        return np.where(ruptured, self.separation(self.rupture_position) / self.separation(position), 1.0)

    def _rise(self, start: float, stop: float, flow_film: FloatArray) -> float:
        """∫ (h - h_b)/h³ dx."""
        film = self.separation((start + stop) / 2 + (stop - start) / 2 * _POINTS)
        return float((stop - start) / 2 * _WEIGHTS @ ((film - flow_film) / film**3))
