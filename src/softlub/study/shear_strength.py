"""Shear strength of the real contact as a study file gives it: part of the modulus, a stress, or a table.

It is no part of the scene that a panel solves: friction's solid part is applied afterwards (equation 3-32).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic_core import PydanticCustomError

from softlub.study.fields import Entry, JsonSchema, Quantity, refusal
from softlub.study.messages import did_you_mean
from softlub.study.quantities import NUMBER
from softlub.study.ranges import ascending, read_entry
from softlub.units import Unit

DEFAULT_SHEAR_STRENGTH = {"modulus_fraction": 0.1}
"""The source's tenth of the modulus."""

_PART_OF_MODULUS = re.compile(rf"({NUMBER})\s*E")
_FRACTION = Quantity(Unit("1", at_least=0))
_STRESS = Quantity(Unit("Pa", at_least=0))
_OVER = {"speed": Quantity(Unit("m/s", above=0)), "load": Quantity(Unit("N/m", above=0))}
_TABLE_KEYS = ("over", "at", "value")
_FORMS = (
    "allowed: a part of the modulus such as 0.1 E, a stress such as 1 MPa, "
    "or a table {over: speed, at: […], value: […]}"
)


@dataclass(frozen=True)
class _ShearStrengthEntry(Entry):
    def read(self, value: Any) -> dict[str, Any]:
        """One of ``{modulus_fraction}``, ``{value}``, ``{table: {over, at, value}}``, in SI."""
        if isinstance(value, Mapping):
            return {"table": _table(value.get("table", value) if len(value) == 1 else value)}
        if value == "calibrated":
            raise refusal(f"is not yet built: no measured friction is read; {_FORMS}")
        if isinstance(value, str) and (match := _PART_OF_MODULUS.fullmatch(value.strip())):
            return {"modulus_fraction": _FRACTION.read(match[1])}
        try:
            return {"value": _STRESS.read(value)}
        except PydanticCustomError as error:
            raise refusal(f"{error.message().split('; allowed')[0]}; {_FORMS}") from None

    def json_schema(self) -> JsonSchema:
        """A number, a text, or a table."""
        entries = {"type": "array", "minItems": 2, "items": {"type": ["number", "string"]}}
        table = {
            "type": "object",
            "properties": {"over": {"enum": list(_OVER)}, "at": entries, "value": entries},
            "required": list(_TABLE_KEYS),
            "additionalProperties": False,
        }
        wrapped = {
            "type": "object",
            "properties": {"table": table},
            "required": ["table"],
            "additionalProperties": False,
        }
        text = {"type": "string", "pattern": rf"^\s*{NUMBER}"}
        return {"anyOf": [{"type": "number", "minimum": 0}, text, table, wrapped]}


def _table(block: Any) -> dict[str, Any]:
    if not isinstance(block, Mapping):
        raise refusal(_FORMS)
    for key in block:
        if key not in _TABLE_KEYS:
            raise refusal(f"has the unknown key {key}; {did_you_mean(str(key), _TABLE_KEYS)}")
    over = block.get("over")
    if not isinstance(over, str) or over not in _OVER:
        raise refusal(f"over {over} is unknown; {did_you_mean(str(over), tuple(_OVER))}")
    at, value = (block.get(key) for key in ("at", "value"))
    if not (isinstance(at, list) and isinstance(value, list) and len(at) == len(value) >= 2):
        raise refusal("needs lists at and value of one length, two entries or more")
    positions = ascending([read_entry(_OVER[over].read, entry, i) for i, entry in enumerate(at)])
    stresses = [read_entry(_STRESS.read, entry, i) for i, entry in enumerate(value)]
    return {"over": over, "at": list(positions), "value": stresses}


ShearStrength = Annotated[dict[str, Any], _ShearStrengthEntry()]
