"""The scene of a study: body, surface, contact law, lubricant."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, model_validator

from softlub.study import parts
from softlub.study.base import StudyModel
from softlub.study.fields import Choice, Quantity, Single, Tagged
from softlub.study.shear_strength import DEFAULT_SHEAR_STRENGTH, ShearStrength
from softlub.units import Unit

Shape = Annotated[
    Any,
    Tagged(
        "kind",
        parts.models_of(parts.SHAPES),
        unbuilt=parts.UNBUILT_SHAPES,
        bare="name of a block in config/shapes",
    ),
]
Material = Annotated[
    Any,
    Tagged(
        "kind",
        parts.models_of(parts.MATERIALS),
        default="linear_elastic",
        unbuilt=parts.UNBUILT_MATERIALS,
        bare="name of a block in config/materials",
    ),
]
Surface = Annotated[
    Any,
    Tagged(
        "kind",
        parts.models_of(parts.SURFACES),
        unbuilt=parts.UNBUILT_SURFACES,
        bare="smooth, or the name of a block in config/surfaces",
    ),
]
Law = Annotated[
    Any,
    Tagged(
        "name", parts.models_of(parts.LAWS, "name"), unbuilt=parts.UNBUILT_LAWS, bare="name of a contact law"
    ),
]
Lubricant = Annotated[
    Any, Single(parts.model_of(parts.LUBRICANT), bare="name of a block in config/lubricants")
]


class Body(StudyModel):
    """The soft body."""

    shape: Shape
    material: Material
    stiffness: Annotated[str, Choice(("half_space",), parts.UNBUILT_STIFFNESS)] = "half_space"


class Scene(StudyModel):
    """What touches what."""

    body: Body
    surface: Surface
    contact_law: Law = None
    lubricant: Lubricant
    shear_strength: ShearStrength = Field(default=DEFAULT_SHEAR_STRENGTH)
    half_domain: Annotated[float, Quantity(Unit("m", above=0))] | None = None

    @model_validator(mode="after")
    def _law_fits_surface(self) -> Scene:
        law = self.contact_law
        if self.surface.kind == "smooth" and law is not None and law.name != "none":
            raise ValueError(
                f"contact_law {law.name} needs a rough surface, and the surface is smooth; "
                "leave contact_law out or give the surface a roughness"
            )
        return self

    def canonical(self) -> dict[str, Any]:
        """The scene in SI with every default filled in, as nodes of the plan carry it; without shear strength."""
        law = (
            self.contact_law
            or parts.model_of(
                parts.LAWS[name := "none" if self.surface.kind == "smooth" else "persson"], "name", name
            )()
        )
        return {
            "body": {
                "shape": self.body.shape.model_dump(),
                "material": self.body.material.model_dump(),
                "stiffness": self.body.stiffness,
            },
            "surface": self.surface.model_dump(),
            "contact_law": law.model_dump(),
            "lubricant": self.lubricant.model_dump(),
            "half_domain": self.half_domain,
        }
