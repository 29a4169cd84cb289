"""What the lubrication solvers ask of the parts they are given.

The solvers know nothing of where a compliance or a contact law came from; whatever has these members serves.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from softlub.pressure_table import PressureTable

FloatArray = NDArray[np.float64]


class ContactLaw(Protocol):
    """Asperity pressure over mean separation, and real contact area over asperity pressure."""

    @property
    def table(self) -> PressureTable:
        """Asperity pressure over mean separation, in the solvers' form."""
        ...

    @property
    def separation_range(self) -> tuple[float, float]:
        """Separations between which the law holds [m]; outside, the table goes on so that solvers find their way."""
        ...

    def area_ratio(self, pressure: FloatArray) -> FloatArray:
        """Real over nominal contact area A/A0 at given asperity pressures [Pa]."""
        ...


class Compliance(Protocol):
    """Gap of the elastic body over its total nodal pressure, on the nodes that it brings along.

    The separation is u = rigid_approach + base_gap + deflection(pressure).
    """

    @property
    def positions(self) -> FloatArray:
        """Node positions x [m], ascending, shape (n,)."""
        ...

    @property
    def widths(self) -> FloatArray:
        """Tributary widths of the nodes [m], shape (n,)."""
        ...

    @property
    def base_gap(self) -> FloatArray:
        """Gap of the unloaded body at zero rigid approach [m], shape (n,)."""
        ...

    def deflection(self, pressure: FloatArray) -> FloatArray:
        """Opening of the gap under the total nodal pressure [Pa], in m, shape (n,)."""
        ...

    def matrix(self) -> FloatArray:
        """Derivative of `deflection` by the pressures [m/Pa], shape (n, n)."""
        ...
