"""Scenes without a film: a surface alone, and a surface pressed on an elastic half-space."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import model_validator

from softlub.study import kinds, parts
from softlub.study.base import StudyModel
from softlub.study.fields import Choice, Tagged
from softlub.study.scene import Material, lacks_heights

_ROUGH = {kind: part for kind, part in parts.SURFACES.items() if kind != "smooth"}
_BARE = "name of a block in config/surfaces"

RoughSurface = Annotated[Any, Tagged("kind", parts.models_of(_ROUGH), bare=_BARE)]
Line = Annotated[Any, Tagged("kind", parts.models_of(parts.LINES), bare=_BARE)]


class PressedBody(StudyModel):
    """The elastic half-space, which has a material and no shape."""

    material: Material


class ContactScene(StudyModel):
    """A rough surface, and what it is pressed on; without a body pressures are known over E* alone."""

    surface: RoughSurface
    body: PressedBody | None = None
    boundary: Annotated[str, Choice(("periodic", "free"))] | None = None

    @model_validator(mode="after")
    def _surface_can_be_made(self) -> ContactScene:
        if lack := lacks_heights(self.surface):
            raise ValueError(f"rough contact {lack}")
        return self

    def canonical(self) -> dict[str, Any]:
        """The scene in SI with every default filled in."""
        return {
            "body": None if self.body is None else {"material": self.body.material.model_dump()},
            "surface": self.surface.model_dump(),
            "boundary": self.boundary,
        }


class RoundBody(StudyModel):
    """An elastic sphere."""

    shape: Annotated[Any, Tagged("kind", parts.models_of(kinds.ROUND_SHAPES))]
    material: Material


class DeflectionScene(StudyModel):
    """A sphere pressed on a smooth plate."""

    body: RoundBody

    def canonical(self) -> dict[str, Any]:
        """The scene in SI with every default filled in."""
        return {
            "body": {"shape": self.body.shape.model_dump(), "material": self.body.material.model_dump()},
            "surface": None,
        }


class SurfaceScene(StudyModel):
    """A surface, a line, or one of each."""

    surface: RoughSurface = None
    line: Line = None

    @model_validator(mode="after")
    def _surface_can_be_made(self) -> SurfaceScene:
        if self.surface is None and self.line is None:
            raise ValueError("holds nothing; give a surface, a line or both")
        if self.surface is not None and (lack := lacks_heights(self.surface)):
            raise ValueError(f"a study of a surface {lack}")
        return self

    def canonical(self) -> dict[str, Any]:
        """The scene in SI with every default filled in."""
        return {
            name: None if part is None else part.model_dump()
            for name, part in (("surface", self.surface), ("line", self.line))
        }
