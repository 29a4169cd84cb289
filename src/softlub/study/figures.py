"""The figures of a study file: ``stribeck``, or ``{name: fig_3_15, draw: stribeck, …options}``."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

from pydantic_core import PydanticCustomError

from softlub.study.drawings import DRAWINGS, HEIGHT, Reader
from softlub.study.fields import Choice, Entry, JsonSchema, refusal
from softlub.study.messages import did_you_mean, shown

FILE_NAME = re.compile(r"[A-Za-z0-9_-]+")
"""Names that are safe as files on every machine and as wildcards of the workflow."""


@dataclass(frozen=True)
class Figure:
    """One figure of a study.

    Parameters
    ----------
    name : str
        Of its files.
    draw : str
        The drawing.
    options : mapping
        What the drawing is told, in SI.
    """

    name: str
    draw: str
    options: Mapping[str, Any] = field(default_factory=dict, hash=False)


def read_figure(value: Any) -> Figure:
    """A figure from its entry in the file, a refusal where that is none."""
    block = {"draw": value} if isinstance(value, str) else value
    if not isinstance(block, Mapping):
        raise refusal("must be the name of a drawing, or {name: …, draw: …}")
    if "draw" not in block:
        raise refusal(
            f"needs the key draw; {did_you_mean(str(block.get('name', '')), tuple(DRAWINGS), 'drawings')}"
        )
    draw = block["draw"]
    try:
        Choice(tuple(DRAWINGS)).read(draw)
    except PydanticCustomError as error:
        raise refusal(f"draw {shown(draw)} {error.message()}") from None
    name = block.get("name", draw)
    if not (isinstance(name, str) and FILE_NAME.fullmatch(name)):
        raise refusal(f"name {shown(name)} is no file name; use letters, digits, - and _ only")
    return Figure(name, draw, _options(draw, block))


@dataclass(frozen=True)
class _FigureEntry(Entry):
    def read(self, value: Any) -> Figure:
        """The figure, its options read."""
        return read_figure(value)

    def json_schema(self) -> JsonSchema:
        """The name of a drawing, or a block for one."""
        return {"anyOf": [{"enum": list(DRAWINGS)}, *(_block_schema(draw) for draw in DRAWINGS)]}


def options_of(draw: str) -> dict[str, Reader]:
    """Every option of a drawing and how it is read."""
    return {**DRAWINGS[draw].options, "height": HEIGHT}


def _options(draw: str, block: Mapping[str, Any]) -> dict[str, Any]:
    known = options_of(draw)
    options = {}
    for key, value in block.items():
        if key in ("name", "draw"):
            continue
        if key not in known:
            raise refusal(
                f"unknown option {key}; {did_you_mean(str(key), ('name', 'draw', *known), 'options')}"
            )
        try:
            options[key] = known[key].read(value)
        except PydanticCustomError as error:
            raise refusal(f"{key} {shown(value)} {error.message()}") from None
    return options


def _block_schema(draw: str) -> JsonSchema:
    properties = {
        "name": {"type": "string", "pattern": f"^{FILE_NAME.pattern}$"},
        "draw": {"const": draw},
        **{option: reader.json_schema() for option, reader in options_of(draw).items()},
    }
    return {"type": "object", "properties": properties, "required": ["draw"], "additionalProperties": False}


FigureEntry = Annotated[Figure, _FigureEntry()]
