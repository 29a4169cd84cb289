"""Laws of normal contact with the plate: pressure over the gap, and how fast it rises as the gap closes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Protocol

import numpy as np
from numpy.typing import NDArray

from softlub.units import Unit

if TYPE_CHECKING:
    from softlub.pressure_table import PressureTable

FloatArray = NDArray[np.float64]


class NormalLaw(Protocol):
    """Pressure of the plate on a node over the gap between them."""

    def pressure_and_stiffness(self, gap: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Pressure p [Pa] and -dp/dgap [Pa/m] at given gaps [m], any sign."""
        ...


@dataclass(frozen=True)
class HardContact:
    """No pressure until the gap is closed, then a spring too stiff to matter.

    Parameters
    ----------
    penalty : float, optional
        Pressure per penetration [Pa/m]; 1e14 lets 0.36 MPa sink in by 3.6 nm.
    """

    penalty: Annotated[float, Unit("Pa/m", above=0)] = 1e14

    def pressure_and_stiffness(self, gap: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Pressure p [Pa] and -dp/dgap [Pa/m].

        Parameters
        ----------
        gap : ndarray
            Gap between node and plate, negative in penetration [m].
        """
        stiffness = np.where(gap < 0, self.penalty, 0.0)
        return -stiffness * gap, stiffness


@dataclass(frozen=True, eq=False)
class PressureClearance:
    """The asperities' pressure over the mean separation, as rough contact gives it (section 6.4 of the source).

    Parameters
    ----------
    table : PressureTable
        It goes on linearly below its first knot, through zero gap into penetration, with the slope it has there.
    """

    table: PressureTable

    def pressure_and_stiffness(self, gap: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Pressure p [Pa] and -dp/dgap [Pa/m].

        Parameters
        ----------
        gap : ndarray
            Gap between node and plate, any sign [m].
        """
        from softlub.pressure_table import evaluate  # compiled code, which only those who need it load

        pressure, slope = evaluate(self.table, gap)
        return pressure, -slope
