"""One lubricated contact to be solved: body, contact law, lubricant, load, speed, domain."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from softlub.lubrication.film import Lubricant
from softlub.lubrication.hertz import HertzLine
from softlub.protocols import ContactLaw
from softlub.units import Height, Length, LineLoad, Pressure, Speed, check


@dataclass(frozen=True)
class HalfSpaceCylinder:
    """Parabolic body x²/(2R) whose deflection is that of an elastic half-space (equations 3-13, 3-14).

    Parameters
    ----------
    radius : float
        R [m].
    modulus : float
        Plane-strain modulus E* [Pa].
    """

    radius: Length
    modulus: Pressure

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True)
class Problem:
    """A lubricated line contact.

    Parameters
    ----------
    body : HalfSpaceCylinder
        The elastic body at rest.
    law : ContactLaw
        Asperity pressure over separation.
    lubricant : Lubricant
        The film.
    load : float
        W [N/m].
    speed : float
        v of the wall, in +x [m/s].
    rms_roughness : float
        h_rms [m]; 0 for smooth surfaces.
    half_domain : float, optional
        Half-width L of the domain -L <= x <= L [m]. By default 64 Hertz half-widths, or 20 √(2 R h_rms) where
        that is wider: friction's tail falls like 1/x, so the domain is a convention of the result.
    """

    body: HalfSpaceCylinder
    law: ContactLaw
    lubricant: Lubricant
    load: LineLoad
    speed: Speed
    rms_roughness: Height = 0.0
    half_domain: Length | None = None

    def __post_init__(self) -> None:
        check(self)

    @property
    def hertz(self) -> HertzLine:
        """The dry, smooth contact at this load."""
        return HertzLine(self.body.radius, self.body.modulus, self.load)

    @property
    def domain(self) -> float:
        """Half-width of the domain in force [m]."""
        if self.half_domain is not None:
            return self.half_domain
        return max(64 * self.hertz.half_width, 20 * float(np.sqrt(2 * self.body.radius * self.rms_roughness)))

    @property
    def speed_number(self) -> float:
        """λ = 6ηvR²/(a³p0)."""
        return self.hertz.speed_number(self.lubricant.viscosity, self.speed)

    def at(self, load: float | None = None, speed: float | None = None) -> Problem:
        """The same contact at another load or speed."""
        return replace(
            self, load=self.load if load is None else load, speed=self.speed if speed is None else speed
        )
