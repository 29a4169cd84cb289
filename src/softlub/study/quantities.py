"""Numbers with units, from a study file to SI: ``"10 MPa"`` -> 1e7.

A plain number is in SI already. Everything else that a reader could take in two ways is refused: decimal commas (pint
takes ``1,5 mm`` for 15 mm), NaN and infinities, units of another dimension, units without a number.
pint is imported when the first unit is met, since it costs more than the rest of the study layer together.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from softlub.units import Unit

NUMBER = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_NUMBER_AND_UNIT = re.compile(rf"({NUMBER})\s*(.*)", re.DOTALL)
_DECIMAL_COMMA = re.compile(r"[+-]?[0-9]*,[0-9]+")
_NOT_FINITE = re.compile(r"[+-]?\.?(?:nan|inf|infinity)\b", re.IGNORECASE)

DIMENSIONS = {
    "m": ("a length", "10 mm"),
    "Pa": ("a pressure", "10 MPa"),
    "N": ("a force", "1.3 N"),
    "N/m": ("a load per length", "100 N/m"),
    "m/s": ("a speed", "1.5 mm/s"),
    "Pa s": ("a viscosity", "0.1 Pa s"),
    "1/m": ("a wavevector", "1e4 1/m"),
    "s": ("a time", "0.5 ms"),
    "rad/s": ("an angular frequency", "1e4 rad/s"),
    "K": ("a temperature", "298.15 K"),
    "rad": ("an angle", "45 deg"),
    "1/Pa": ("a compressibility", "0.001 1/MPa"),
    "Pa/m": ("a stiffness per area", "1e14 Pa/m"),
    "1": ("a pure number", "0.8"),
}
"""What each SI unit measures, and how a user may write it."""

_MISTAKABLE = {
    "rad/s": (
        ("rad/s", "1/s", "s^-1", "s**-1"),
        "an angular frequency is 2π times the cycles that Hz counts",
    ),
    "K": (("K", "kelvin"), "other scales count from another zero"),
}
"""SI unit -> the ways of writing it that are taken, and why no other is: pint would get the others wrong."""

SIGNIFICANT_DIGITS = 14
"""Digits kept after a conversion: ``10 mm``, ``1 cm`` and ``0.01`` are the same number and give the same key."""


class QuantityError(ValueError):
    """A value that is not the number it should be.

    Parameters
    ----------
    text : str
        What is wrong and what is allowed.
    """


def read_quantity(value: Any, unit: Unit) -> float:
    """A number in SI from what stands in a study file.

    Parameters
    ----------
    value : int, float or str
        Plain number in SI (also as text), or a number with its unit.
    unit : Unit
        SI unit and bounds of the quantity.

    Returns
    -------
    float

    Raises
    ------
    QuantityError
        If the value is no finite number, has a unit of another dimension, or lies outside the bounds.
    """
    number = _number(value, unit)
    if not unit.allows(number):
        finite = abs(number) < float("inf")
        raise QuantityError(f"must be {unit.allowed()}" if finite else f"must be finite; {_allowed(unit)}")
    return number


def _number(value: Any, unit: Unit) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise QuantityError(f"is not a number; {_allowed(unit)}")
    if not isinstance(value, str):
        try:
            return float(value)
        except OverflowError:
            raise QuantityError(f"is too large; {_allowed(unit)}") from None
    return _text_to_number(value.strip(), unit)


def _text_to_number(text: str, unit: Unit) -> float:
    if _NOT_FINITE.match(text):
        raise QuantityError(f"is not a finite number; {_allowed(unit)}")
    if _DECIMAL_COMMA.match(text):
        raise QuantityError(f"has a comma; numbers have a decimal point and no separators; {_allowed(unit)}")
    match = _NUMBER_AND_UNIT.fullmatch(text)
    if match is None:
        raise QuantityError(f"does not begin with a number; {_allowed(unit)}")
    number, symbol = float(match[1]), match[2].strip()
    return number if not symbol else _converted(number, symbol, unit)


def _converted(number: float, symbol: str, unit: Unit) -> float:
    if unit.symbol in _MISTAKABLE and symbol not in _MISTAKABLE[unit.symbol][0]:
        raise QuantityError(f'"{symbol}" is not taken: {_MISTAKABLE[unit.symbol][1]}; {_allowed(unit)}')
    factor = _factor(symbol, unit.symbol)
    if factor is None:
        if unit.symbol == "Pa s" and _factor(symbol, "m^2/s") is not None:
            raise QuantityError(f'"{symbol}" is kinematic: multiply by the density; {_allowed(unit)}')
        raise QuantityError(f'"{symbol}" is not a unit of {_what(unit)}; {_allowed(unit)}')
    return number if factor == 1 else rounded(number * factor)


def rounded(number: float, digits: int = SIGNIFICANT_DIGITS) -> float:
    """The number with its last, accidental digits rounded off."""
    return float(f"{number:.{digits}g}")


@cache
def _factor(symbol: str, target: str) -> float | None:
    """Factor from a unit to the SI unit; None if there is no such unit or it measures something else."""
    registry = _registry()
    try:
        units = registry.parse_units(symbol)
        return float(
            registry.Quantity(1.0, units).to(registry.parse_units("" if target == "1" else target)).magnitude
        )
    # pint's parser lets errors of Python's tokenizer and arithmetic through; whatever it fails on is no unit.
    except Exception:
        return None


@cache
def _registry() -> Any:
    import pint

    return pint.UnitRegistry()


def _what(unit: Unit) -> str:
    return DIMENSIONS[unit.symbol][0]


def _allowed(unit: Unit) -> str:
    what, example = DIMENSIONS[unit.symbol]
    plain = "" if unit.symbol == "1" else f" or a plain number in {unit.symbol}"
    return f"allowed: {what}, {unit.allowed()}, such as {example}{plain}"
