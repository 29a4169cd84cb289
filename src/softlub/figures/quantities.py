"""Axes of figures: a quantity's name, symbol and unit, and the SI prefix that suits its values."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from softlub.datasets.variables import VARIABLES

FloatArray = NDArray[np.float64]

PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
PREFIXED_UNITS = ("m", "Pa", "s", "N", "B")
"""Units that read better with a prefix; products of units keep powers of ten."""

SYMBOLS = {
    "friction_coefficient": "friction coefficient μ",
    "friction_coefficient_fluid": "fluid friction coefficient",
    "hersey_number": "Hersey number ηv",
    "separation_min": "smallest separation",
    "separation": "separation u",
    "fluid_pressure": "fluid pressure",
    "solid_pressure": "asperity pressure",
    "load_share_solid": "share of the load on asperities",
    "load": "load W",
    "speed": "speed v",
    "young_modulus": "E",
    "rms_roughness": "h_rms",
    "viscosity": "η",
    "radius": "R",
    "poisson_ratio": "ν",
    "hurst": "H",
    "x": "position x",
    "iterations": "iterations",
    "solver_seconds": "CPU time",
}
"""Short names on axes and in legends."""

UNITS = {"young_modulus": "Pa", "rms_roughness": "m", "viscosity": "Pa s", "radius": "m", "half_domain": "m"}
"""Units of inputs, which are no variables of a dataset."""


@dataclass(frozen=True)
class Quantity:
    """One axis: what it shows, in SI, and the power of ten of the unit that it is shown in.

    Parameters
    ----------
    name : str
        Name of the variable, for the data beside the figure.
    label : str
        Name on the axis.
    unit : str
        SI unit; ``"1"`` for a pure number.
    exponent : int
        Power of ten of the displayed unit.
    """

    name: str
    label: str
    unit: str
    exponent: int = 0

    @property
    def shown_unit(self) -> str:
        """Unit with its prefix, as the axis shows it; a dash for pure numbers."""
        if self.unit == "1":
            return "–"
        if self.unit.startswith("1/"):
            return f"1/{PREFIXES[-self.exponent]}{self.unit[2:]}"
        # The prefix of an area counts twice: 1e-12 m² are 1 µm².
        return PREFIXES[self.exponent // 2 if self.unit.endswith("²") else self.exponent] + self.unit

    @property
    def axis_label(self) -> str:
        """Label with the unit in brackets."""
        return f"{self.label} ({self.shown_unit})"

    def shown(self, values: ArrayLike) -> FloatArray:
        """Values [SI] in the displayed unit."""
        return np.asarray(values, dtype=float) / 10.0**self.exponent

    def text(self, value: float) -> str:
        """One value [SI] with its unit: ``"10 MPa"``."""
        best = quantity(self.name, value)
        unit = "" if best.unit == "1" else f" {best.shown_unit}"
        return f"{best.shown(value):.4g}{unit}"


def quantity(
    name: str, values: ArrayLike = 1.0, label: str | None = None, unit: str | None = None
) -> Quantity:
    """The axis of a variable, with the prefix that suits the largest of the values.

    Parameters
    ----------
    name : str
        A variable of the datasets or an input of a scene.
    values : array_like, optional
        What the axis has to show [SI].
    label, unit : str, optional
        Where the table of variables does not know them or is to be overruled.

    Returns
    -------
    Quantity
    """
    known = VARIABLES.get(name)
    unit = unit or UNITS.get(name) or (known.units if known else "1")
    label = label or SYMBOLS.get(name) or (known.long_name if known else name.replace("_", " "))
    return Quantity(name, label, unit, _exponent(values) if unit in PREFIXED_UNITS else 0)


def _exponent(values: ArrayLike) -> int:
    sizes = np.abs(np.asarray(values, dtype=float))
    sizes = sizes[np.isfinite(sizes) & (sizes > 0)]
    if sizes.size == 0:
        return 0
    # Rounding keeps 1e-6 m from becoming 1000 nm by the last bit of its logarithm.
    return int(np.clip(3 * np.floor(np.round(np.log10(sizes.max()), 9) / 3), min(PREFIXES), max(PREFIXES)))
