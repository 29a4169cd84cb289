"""The lubricant and what its film does where the gap opens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from softlub.units import Viscosity, check

Cavitation = Literal["reynolds", "mass_conserving"]


@dataclass(frozen=True)
class Lubricant:
    """Newtonian lubricant of constant viscosity and density (equation 3-2).

    Parameters
    ----------
    viscosity : float
        η [Pa s].
    cavitation : {"reynolds", "mass_conserving"}
        What holds where the film breaks. ``reynolds``: complementarity p_f >= 0 with a vanishing gradient at
        the rupture (Swift–Stieber); the source names it after Gümbel. ``mass_conserving``: p_f >= 0
        complementary to the void fraction (Jakobsson–Floberg–Olsson), which also finds where the film forms again.
    """

    viscosity: Viscosity
    cavitation: Cavitation = "reynolds"

    def __post_init__(self) -> None:
        check(self)
        if self.cavitation not in get_args(Cavitation):
            raise ValueError(
                f"Lubricant: cavitation {self.cavitation!r} must be one of {', '.join(get_args(Cavitation))}"
            )
