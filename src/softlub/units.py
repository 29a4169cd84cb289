"""Units and bounds of parameters, as annotations that a study reader can build its checks from.

A parameter class is a plain frozen dataclass beside the physics that uses it. Each of its numbers is annotated
with the SI unit and the values that make sense; nothing here imports a unit library.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated, Any, get_args, get_type_hints


@dataclass(frozen=True)
class Unit:
    """SI unit of a number and the interval it must lie in.

    Parameters
    ----------
    symbol : str
        SI unit as pint reads it; ``"1"`` for a pure number.
    above, below : float, optional
        Open bounds.
    at_least, at_most : float, optional
        Closed bounds.
    """

    symbol: str
    above: float | None = None
    at_least: float | None = None
    below: float | None = None
    at_most: float | None = None

    def allows(self, value: float) -> bool:
        """Whether `value` (in the SI unit) lies within the bounds; NaN and infinities never do."""
        return (
            abs(value) < float("inf")
            and (self.above is None or value > self.above)
            and (self.at_least is None or value >= self.at_least)
            and (self.below is None or value < self.below)
            and (self.at_most is None or value <= self.at_most)
        )

    def allowed(self) -> str:
        """The bounds in words, for messages."""
        parts = [
            f"{words} {bound:g}"
            for words, bound in (
                ("above", self.above),
                ("at least", self.at_least),
                ("below", self.below),
                ("at most", self.at_most),
            )
            if bound is not None
        ]
        unit = "" if self.symbol == "1" else f" {self.symbol}"
        return (" and ".join(parts) + unit) if parts else f"any finite number{unit}"


def check(parameters: Any) -> None:
    """Hold every annotated number of a parameter object against its bounds.

    Parameters
    ----------
    parameters : dataclass instance
        Whatever is annotated with a `Unit` is checked; None passes, for what may be left out.

    Raises
    ------
    ValueError
        Naming the class, the field, its value and what is allowed.
    """
    kind: type = type(parameters)
    for name, unit in _units(kind):
        value = getattr(parameters, name)
        if value is not None and not unit.allows(value):
            raise ValueError(f"{type(parameters).__name__}: {name} = {value:g} must be {unit.allowed()}")


@lru_cache(maxsize=64)
def _units(parameter_class: type) -> tuple[tuple[str, Unit], ...]:
    """Fields of a class that carry a unit, also where None is allowed besides."""
    found = []
    for name, hint in get_type_hints(parameter_class, include_extras=True).items():
        for part in (hint, *get_args(hint)):
            found += [(name, unit) for unit in getattr(part, "__metadata__", ()) if isinstance(unit, Unit)]
    return tuple(found)


Length = Annotated[float, Unit("m", above=0)]
Height = Annotated[float, Unit("m", at_least=0)]
Pressure = Annotated[float, Unit("Pa", above=0)]
LineLoad = Annotated[float, Unit("N/m", above=0)]
Speed = Annotated[float, Unit("m/s", above=0)]
Viscosity = Annotated[float, Unit("Pa s", above=0)]
Wavevector = Annotated[float, Unit("1/m", above=0)]
HurstExponent = Annotated[float, Unit("1", above=0, at_most=1)]
PoissonRatio = Annotated[float, Unit("1", above=0, at_most=0.5)]
