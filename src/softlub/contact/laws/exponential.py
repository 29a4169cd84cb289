"""The exponential tail of Persson's theory as a law of its own (equation 3-11)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

import numpy as np

from softlub.contact.real_area import persson_area_ratio
from softlub.pressure_table import FloatArray, PressureTable, tabulate
from softlub.surfaces.spectrum import SelfAffine
from softlub.units import Pressure, Unit

PREFACTOR = 0.375
"""β₂ ε of equation 4-23 for fractal dimension 2.2: 0.5 · 0.75."""
KNOTS = np.geomspace(1e-4, 20.0, 340)
"""u/h_rms of the table; beyond both ends the table's own continuation is the law within 1e-8."""


@dataclass(frozen=True)
class ExponentialLaw:
    """p_s = 0.375 E* q_r h_rms exp(-u/h_rms) (equation 3-11), with Persson's area.

    The source's closed form, rounded from Persson's tail for H = 0.8; it holds for u > h_rms only and stays finite
    at u = 0, so that deep contact has no place for a heavy load.

    Parameters
    ----------
    spectrum : SelfAffine
        Roughness.
    modulus : float
        Plane-strain modulus E* [Pa].
    pressure_factor : float, optional
        As in `PerssonLaw`.
    """

    spectrum: SelfAffine
    modulus: Pressure
    pressure_factor: Annotated[float, Unit("1", above=0)] = 1.0

    @property
    def stiffness(self) -> float:
        """E* of the asperities, pressure_factor included [Pa]."""
        return self.pressure_factor * self.modulus

    @property
    def separation_range(self) -> tuple[float, float]:
        """Separations between which equation 3-11 stands for the theory [m]."""
        return self.spectrum.rms_roughness, float("inf")

    @cached_property
    def table(self) -> PressureTable:
        """Asperity pressure over mean separation."""
        roughness = self.spectrum.rms_roughness
        pressure = PREFACTOR * self.stiffness * self.spectrum.rolloff * roughness * np.exp(-KNOTS)
        return tabulate(KNOTS * roughness, pressure, -pressure / roughness)

    def area_ratio(self, pressure: FloatArray) -> FloatArray:
        """Real over nominal contact area (equation 3-32 in its erf form).

        Parameters
        ----------
        pressure : ndarray
            Asperity pressure [Pa].

        Returns
        -------
        ndarray
            A/A0, of the shape of `pressure`.
        """
        return persson_area_ratio(pressure, self.stiffness, self.spectrum.rms_slope)
