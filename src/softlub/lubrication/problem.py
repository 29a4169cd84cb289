"""One lubricated contact to be solved: body, contact law, lubricant, load, speed, domain."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from softlub.lubrication.film import Lubricant
from softlub.lubrication.hertz import HertzLine
from softlub.lubrication.meshed_body import MeshedBody
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
    body : HalfSpaceCylinder or MeshedBody
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
        that is wider: friction's tail falls like 1/x, so the domain is a convention of the result. A meshed body
        is as wide as its contact edge.

    Raises
    ------
    ValueError
        If a number is out of bounds, or a domain is asked of a meshed body.
    """

    body: HalfSpaceCylinder | MeshedBody
    law: ContactLaw
    lubricant: Lubricant
    load: LineLoad
    speed: Speed
    rms_roughness: Height = 0.0
    half_domain: Length | None = None

    def __post_init__(self) -> None:
        check(self)
        if self.half_domain is not None and isinstance(self.body, MeshedBody):
            raise ValueError(
                f"half_domain = {self.half_domain:g} m: the film of a meshed body reaches as far as its contact edge; "
                "leave half_domain out and mesh a wider edge"
            )

    def refuse_meshed(self, solver: str) -> None:
        """Stop a solver that knows half-spaces alone from taking a meshed body.

        Raises
        ------
        ValueError
            If the body is meshed.
        """
        if isinstance(self.body, MeshedBody):
            raise ValueError(
                f"the {solver} solver knows half-spaces alone; for a meshed body use finite_volume or auto"
            )

    @property
    def hertz(self) -> HertzLine:
        """The dry, smooth contact at this load."""
        return HertzLine(self.body.radius, self.body.modulus, self.load)

    @property
    def domain(self) -> float:
        """Half-width of the domain in force [m]."""
        if isinstance(self.body, MeshedBody):
            return float(np.max(np.abs(self.body.compliance.positions)))
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
