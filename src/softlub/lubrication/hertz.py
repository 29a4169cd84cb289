"""The units of the lubricated contact: those of Hertz's dry line contact at the same load."""

from __future__ import annotations

from softlub.references.hertz_line import HertzLineContact


class HertzLine(HertzLineContact):
    """Dry contact of the smooth cylinder, with the dimensionless numbers built on it."""

    @property
    def gap_scale(self) -> float:
        """a²/R [m]: the unit of separation in the scaled problem."""
        return self.half_width**2 / self.radius

    def speed_number(self, viscosity: float, speed: float) -> float:
        """λ = 6ηvR²/(a³p0): the only number of the smooth isoviscous contact.

        Parameters
        ----------
        viscosity : float
            η [Pa s].
        speed : float
            v [m/s].
        """
        return 6 * viscosity * speed * self.radius**2 / (self.half_width**3 * self.peak_pressure)
