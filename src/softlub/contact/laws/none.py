"""The law of surfaces that never touch: full film only."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softlub.pressure_table import EMPTY_TABLE, FloatArray, PressureTable


@dataclass(frozen=True)
class NoContact:
    """No asperity pressure at any separation."""

    @property
    def table(self) -> PressureTable:
        """A table without intervals."""
        return EMPTY_TABLE

    @property
    def separation_range(self) -> tuple[float, float]:
        """Every positive separation [m]."""
        return 0.0, float("inf")

    def area_ratio(self, pressure: FloatArray) -> FloatArray:
        """Zero everywhere."""
        return np.zeros_like(pressure)
