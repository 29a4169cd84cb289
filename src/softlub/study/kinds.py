"""Shapes and materials by the word that a study file uses, and how a checked block becomes one.

A new material or shape is one more line here. Jobs build bodies from this alone: reading and checking a study is not
theirs, and the libraries for it are not loaded.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any, get_type_hints

from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.solid.materials.material import RateIndependent
from softlub.solid.materials.mooney_rivlin import MooneyRivlin
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.solid.materials.wlf import WilliamsLandelFerry
from softlub.solid.materials.yeoh import Yeoh
from softlub.solid.shapes.cylinder import Cylinder
from softlub.solid.shapes.half_cylinder import HalfCylinder
from softlub.solid.shapes.profile_file import ProfileFile
from softlub.solid.shapes.rectangle import Rectangle
from softlub.solid.shapes.sphere import Sphere
from softlub.solid.shapes.strip import Strip
from softlub.solid.shapes.triangle import TriangularSpecimen

SHAPES: dict[str, type] = {"cylinder": Cylinder}
ROUND_SHAPES: dict[str, type] = {"sphere": Sphere}
MESHED_SHAPES: dict[str, type] = {
    "triangle": TriangularSpecimen,
    "half_cylinder": HalfCylinder,
    "rectangle": Rectangle,
    "strip": Strip,
    "profile": ProfileFile,
}
ROUND_TIPS = ("triangle", "half_cylinder", "profile")
"""Those of them that a film builds up under."""
RATE_INDEPENDENT: dict[str, type] = {
    "linear_elastic": LinearElastic,
    "neo_hookean": NeoHookean,
    "mooney_rivlin": MooneyRivlin,
    "yeoh": Yeoh,
}
MATERIALS: dict[str, type] = {**RATE_INDEPENDENT, "viscoelastic": Viscoelastic}
TIME_TEMPERATURE: type = WilliamsLandelFerry
ALTERNATIVES: dict[type, dict[str, type]] = {RateIndependent: RATE_INDEPENDENT}
"""Parts of a part that are one of several: a viscoelastic material's material at rest."""


def built(kinds: Mapping[str, type], block: Mapping[str, Any]) -> Any:
    """The part that a canonical block stands for.

    Parameters
    ----------
    kinds : mapping
        Word -> parameter class, such as `MATERIALS`.
    block : mapping
        With the word under ``kind``, in SI.

    Returns
    -------
    Any
        An instance of the class.

    Raises
    ------
    ValueError
        If the class refuses its parameters.
    """
    return _made(kinds[block["kind"]], block)


def field_names(part: type) -> list[str]:
    """Names of a parameter class's fields."""
    return [field.name for field in fields(part)]


@cache
def _hints(part: type) -> dict[str, Any]:
    # A sample makes tens of thousands of parts, and resolving annotations takes longer than that.
    return get_type_hints(part)


def _made(part: type, block: Mapping[str, Any]) -> Any:
    hints = _hints(part)
    return part(**{name: _value(hints[name], block[name]) for name in field_names(part) if name in block})


def _value(hint: Any, value: Any) -> Any:
    """A field's value: a part of its own, or a number, a word or several of them."""
    if hint in ALTERNATIVES:
        return built(ALTERNATIVES[hint], value)
    if isinstance(hint, type) and is_dataclass(hint):
        return _made(hint, value)
    return tuple(value) if isinstance(value, list) else value
