"""Time–temperature superposition after Williams, Landel and Ferry (section 5.6.1.3)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from softlub.solid.materials.prony import PronySeries
from softlub.units import Unit, check

LARGEST_EXPONENT = 300.0
"""lg a_T is not followed beyond this."""


@dataclass(frozen=True)
class WilliamsLandelFerry:
    """lg a_T = -K1 (T - T_ref)/(K2 + T - T_ref), with the decadic logarithm.

    Relaxation times at T are those at T_ref times a_T: a warmer material relaxes faster, and its moduli lie at higher
    frequencies.

    Parameters
    ----------
    first_constant : float
        K1.
    second_constant : float
        K2 [K].
    reference_temperature : float
        T_ref [K].

    Raises
    ------
    ValueError
        If a constant or the temperature is not above 0.
    """

    first_constant: Annotated[float, Unit("1", above=0)]
    second_constant: Annotated[float, Unit("K", above=0)]
    reference_temperature: Annotated[float, Unit("K", above=0)]

    def __post_init__(self) -> None:
        check(self)

    def shift_factor(self, temperature: float) -> float:
        """a_T.

        Parameters
        ----------
        temperature : float
            T [K].

        Raises
        ------
        ValueError
            If T lies at or below T_ref - K2, where the formula has its pole and nothing relaxes any more.
        """
        lowest = self.reference_temperature - self.second_constant
        if not lowest < temperature < float("inf"):
            raise ValueError(
                f"temperature {temperature:g} K must be finite and above {lowest:g} K = T_ref - K2, below which the "
                "shift of Williams, Landel and Ferry has no meaning"
            )
        above = temperature - self.reference_temperature
        # Just above the pole the factor exceeds every number.
        return float(10 ** min(-self.first_constant * above / (temperature - lowest), LARGEST_EXPONENT))

    def at_temperature(self, prony: PronySeries, temperature: float) -> PronySeries:
        """A series known at T_ref, at the temperature T [K]; refuses what `shift_factor` refuses."""
        return prony.slowed(self.shift_factor(temperature))
