"""A pad with one pocket, whose film ruptures at the pocket's entry and forms again inside it, conserving mass.

The film is h_l on the lands and h_p > h_l in the pocket, the pressure p_a at both ends and never below zero. Lands and
full pocket carry the flow q = vh/2 - h³p'/(12η), the ruptured part q = vhθ/2 with θ its filling, the same q everywhere:

    first land:   q = v h_l/2 + h_l³ p_a/(12η B₁)            (p falls from p_a to 0)
    second land:  q = v h_l/2 + h_l³ (p₂ - p_a)/(12η B₃)     (from p₂ to p_a), hence p₂ = p_a (1 + B₃/B₁)
    full pocket:  q = v h_p/2 - h_p³ p₂/(12η L)              (from 0 to p₂ over L)

which gives the length L of the full part, and θ = 2q/(v h_p). Jakobsson–Floberg–Olsson conditions; the bearing is
that of M. Fowell, A. V. Olver, A. D. Gosman, H. A. Spikes, I. Pegg, J. Tribol. 129 (2007) 336, with parallel lands.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Pocket:
    """Parallel pad with a pocket that the film fills in part.

    Parameters
    ----------
    land_film : float
        h_l [m].
    pocket_film : float
        h_p [m].
    first_land, pocket_length, second_land : float
        B₁, B₂, B₃ [m].
    ambient_pressure : float
        p_a above the cavitation pressure [Pa].
    viscosity : float
        η [Pa s].
    speed : float
        v of the wall [m/s].

    Raises
    ------
    ValueError
        If the film does not rupture within the pocket: too slow, or ambient pressure too high.
    """

    land_film: float
    pocket_film: float
    first_land: float
    pocket_length: float
    second_land: float
    ambient_pressure: float
    viscosity: float
    speed: float

    def __post_init__(self) -> None:
        if not (0 < self.filling < 1 and self.full_length < self.pocket_length):
            raise ValueError(
                "the film does not rupture in this pocket; raise the speed or lower the ambient pressure"
            )

    @property
    def flow(self) -> float:
        """Volume flow q [m²/s]."""
        pushed = self.land_film**3 * self.ambient_pressure / (12 * self.viscosity * self.first_land)
        return self.speed * self.land_film / 2 + pushed

    @property
    def filling(self) -> float:
        """θ of the ruptured part."""
        return 2 * self.flow / (self.speed * self.pocket_film)

    @property
    def exit_pressure(self) -> float:
        """p₂ at the end of the pocket [Pa]."""
        return self.ambient_pressure * (1 + self.second_land / self.first_land)

    @property
    def full_length(self) -> float:
        """L: the part of the pocket behind the reformation [m]."""
        deficit = self.speed * self.pocket_film / 2 - self.flow
        return self.pocket_film**3 * self.exit_pressure / (12 * self.viscosity * deficit)

    @property
    def rupture_position(self) -> float:
        """Where the film ruptures: the entry of the pocket [m]."""
        return self.first_land

    @property
    def reformation_position(self) -> float:
        """Where the film forms again [m]."""
        return self.first_land + self.pocket_length - self.full_length

    def separation(self, position: FloatArray) -> FloatArray:
        """h [m] at positions in [0, B₁ + B₂ + B₃] [m]."""
        inside = (position > self.first_land) & (position < self.first_land + self.pocket_length)
        return np.where(inside, self.pocket_film, self.land_film)

    def pressure(self, position: FloatArray) -> FloatArray:
        """p [Pa] at positions in [0, B₁ + B₂ + B₃] [m]."""
        pocket_end = self.first_land + self.pocket_length
        corners = [
            0.0,
            self.rupture_position,
            self.reformation_position,
            pocket_end,
            pocket_end + self.second_land,
        ]
        return np.interp(
            position, corners, [self.ambient_pressure, 0.0, 0.0, self.exit_pressure, self.ambient_pressure]
        )
