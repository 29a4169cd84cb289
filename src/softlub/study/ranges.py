"""Grids of a study file: a value, an ascending list, or a range with a number of points."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from pydantic_core import PydanticCustomError

from softlub.study.fields import Entry, JsonSchema, Quantity, refusal
from softlub.study.messages import did_you_mean, shown
from softlub.units import Unit

RANGE_KEYS = ("from", "to", "points", "spacing")
SPACINGS = ("linear", "log")
MOST_POINTS = 10_000
_POINTS = Quantity(Unit("1", at_least=2, at_most=MOST_POINTS), whole=True)


@dataclass(frozen=True)
class Values(Entry):
    """Ascending values of one quantity: one value, a list, or a range."""

    unit: Unit

    def read(self, value: Any) -> tuple[float, ...]:
        """The values in SI."""
        quantity = Quantity(self.unit)
        if isinstance(value, Mapping):
            return read_range(value, quantity.read)
        entries = value if isinstance(value, list) else [value]
        if not entries:
            raise refusal("is empty; a grid needs one value at least")
        return ascending([read_entry(quantity.read, entry, i) for i, entry in enumerate(entries)])

    def json_schema(self) -> JsonSchema:
        """One value, a list of them, or a range."""
        quantity = Quantity(self.unit).json_schema()
        return {
            "anyOf": [
                *quantity["anyOf"],
                {"type": "array", "items": quantity, "minItems": 1},
                range_schema(quantity),
            ]
        }


@dataclass(frozen=True)
class Series(Entry):
    """A list of values of one quantity, in any order."""

    unit: Unit

    def read(self, value: Any) -> tuple[float, ...]:
        """The values in SI."""
        if not isinstance(value, (list, tuple)) or not value:
            raise refusal("must be a list of one value at least")
        return tuple(read_entry(Quantity(self.unit).read, entry, i) for i, entry in enumerate(value))

    def json_schema(self) -> JsonSchema:
        """A list that is not empty."""
        return {"type": "array", "items": Quantity(self.unit).json_schema(), "minItems": 1}


def read_entry(read: Callable[[Any], float], entry: Any, index: int) -> float:
    """One entry of a list; a refusal says which."""
    try:
        return read(entry)
    except PydanticCustomError as error:
        raise refusal(f"entry {index + 1}, {shown(entry) or 'a block'}, {error.message()}") from None


def ascending(values: list[float]) -> tuple[float, ...]:
    """The values, refused unless each is larger than the one before."""
    for before, after in pairwise(values):
        if not after > before:
            raise refusal(
                f"is not in ascending order: {after:g} follows {before:g}; sort it and drop repetitions"
            )
    return tuple(values)


def read_range(block: Mapping[str, Any], read: Callable[[Any], float]) -> tuple[float, ...]:
    """Values of ``{from, to, points, spacing}``, rounded to twelve digits so that every machine has the same."""
    low, high, spacing = range_bounds(block, read, RANGE_KEYS)
    try:
        points = int(_POINTS.read(block["points"]))
    except PydanticCustomError as error:
        raise refusal(f"points {shown(block['points'])} {error.message()}") from None
    steps = [i / (points - 1) for i in range(points)]
    if spacing == "log":
        between = [low * math.exp(math.log(high / low) * step) for step in steps]
    else:
        between = [low + (high - low) * step for step in steps]
    inner = [float(f"{value:.12g}") for value in between[1:-1]]
    return ascending([low, *inner, high])


def range_bounds(
    block: Mapping[str, Any], read: Callable[[Any], float], keys: tuple[str, ...]
) -> tuple[float, float, str]:
    """Ends and spacing of a range; `keys` are those that it must have, `spacing` apart."""
    for key in block:
        if key not in keys:
            raise refusal(f"has the unknown key {key}; {did_you_mean(str(key), keys)}")
    missing = [key for key in keys if key not in block and key != "spacing"]
    if missing:
        raise refusal(f"lacks {', '.join(missing)}; a range has {', '.join(keys)}")
    ends = []
    for key in ("from", "to"):
        try:
            ends.append(read(block[key]))
        except PydanticCustomError as error:
            raise refusal(f"{key} {shown(block[key])} {error.message()}") from None
    spacing = block.get("spacing", "linear")
    if spacing not in SPACINGS:
        raise refusal(f"spacing {spacing} is unknown; {did_you_mean(str(spacing), SPACINGS)}")
    low, high = ends
    if not low < high:
        raise refusal(f"from {low:g} must lie below to {high:g}")
    if spacing == "log" and not low > 0:
        raise refusal("spacing log needs from above 0")
    return low, high, spacing


def range_schema(quantity: JsonSchema, counted: bool = True) -> JsonSchema:
    """JSON schema of a range of some quantity."""
    points: JsonSchema = {"points": _POINTS.json_schema()} if counted else {}
    return {
        "type": "object",
        "properties": {"from": quantity, "to": quantity, "spacing": {"enum": list(SPACINGS)}, **points},
        "required": ["from", "to", *points],
        "additionalProperties": False,
    }
