"""The scene of a study: body, surface, contact law, lubricant."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, model_validator

from softlub.solid.elements import ELEMENTS
from softlub.study import kinds, parts
from softlub.study.base import StudyModel
from softlub.study.fields import Choice, Quantity, Single, Tagged
from softlub.study.shear_strength import DEFAULT_SHEAR_STRENGTH, ShearStrength
from softlub.units import Unit

Shape = Annotated[
    Any,
    Tagged(
        "kind",
        parts.models_of({**kinds.SHAPES, **kinds.MESHED_SHAPES}),
        unbuilt=parts.UNBUILT_SHAPES,
        bare="name of a block in config/shapes",
    ),
]
Material = Annotated[
    Any,
    Tagged(
        "kind",
        parts.models_of(kinds.MATERIALS),
        default="linear_elastic",
        bare="name of a block in config/materials",
    ),
]
Surface = Annotated[
    Any,
    Tagged(
        "kind",
        parts.models_of(parts.SURFACES),
        bare="smooth, or the name of a block in config/surfaces",
    ),
]
Law = Annotated[
    Any,
    Tagged("name", parts.models_of(parts.LAWS, "name"), bare="name of a contact law"),
]
Lubricant = Annotated[
    Any, Single(parts.model_of(parts.LUBRICANT), bare="name of a block in config/lubricants")
]


MESH = parts.model_of(parts.MESH)
Mesh = Annotated[Any, Single(MESH, bare="block itself")]

DEFAULT_LAWS = {"smooth": "none", "self_affine": "persson", "measured": "boundary_element"}
"""Contact law of a surface's kind where the scene names none."""


ROUGHEST = 0.1
"""h_rms over the radius above which the roughness is the shape itself: a unit was forgotten."""


def lacks_heights(surface: Any) -> str:
    """What keeps a surface from being made, empty if nothing does."""
    missing = [
        name
        for name in ("size", "points")
        if surface.kind == "self_affine" and getattr(surface, name) is None
    ]
    needed = " and ".join(f"surface.{name}" for name in missing)
    return f"needs the surface itself and not only its spectrum; give {needed}" if missing else ""


STIFFNESSES = ("half_space", "initial")


class Body(StudyModel):
    """The soft body."""

    shape: Shape
    material: Material
    stiffness: Annotated[str, Choice(STIFFNESSES, parts.UNBUILT_STIFFNESS)] = "half_space"
    element: Annotated[str, Choice(tuple(ELEMENTS))] | None = None
    mesh: Mesh = None

    @model_validator(mode="after")
    def _stiffness_fits_shape(self) -> Body:
        kind = self.shape.kind
        if self.stiffness == "half_space" and kind not in kinds.SHAPES:
            raise ValueError(
                f"stiffness half_space knows the shapes {', '.join(kinds.SHAPES)}, and shape is {kind}; "
                "take stiffness: initial"
            )
        if self.stiffness != "half_space" and kind in kinds.SHAPES:
            raise ValueError(
                f"stiffness {self.stiffness} needs a shape of finite elements, and shape is {kind}; "
                f"allowed: {', '.join(kinds.MESHED_SHAPES)}"
            )
        if self.stiffness != "half_space" and kind not in kinds.ROUND_TIPS:
            raise ValueError(
                f"shape {kind} is flat, and no film builds up under it; allowed: {', '.join(kinds.ROUND_TIPS)}"
            )
        for name in ("element", "mesh"):
            if self.stiffness == "half_space" and getattr(self, name) is not None:
                raise ValueError(f"{name} is for bodies of finite elements; leave it out with half_space")
        return self

    def canonical(self) -> dict[str, Any]:
        """The body in SI; what only finite elements have stands in it for them alone."""
        whole = {
            "shape": self.shape.model_dump(),
            "material": self.material.model_dump(),
            "stiffness": self.stiffness,
        }
        if self.stiffness == "half_space":
            return whole
        mesh = MESH() if self.mesh is None else self.mesh
        return {**whole, "element": self.element or "mean_dilatation", "mesh": mesh.model_dump()}


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
        if law is not None and law.name == "boundary_element" and (lack := lacks_heights(self.surface)):
            raise ValueError(f"contact_law boundary_element {lack}")
        if law is not None and law.name in ("persson", "exponential") and self.surface.kind == "measured":
            raise ValueError(
                f"contact_law {law.name} needs a spectrum, and the surface is measured; "
                "take boundary_element, or fit a self_affine surface to it"
            )
        return self

    @model_validator(mode="after")
    def _domain_is_the_edge(self) -> Scene:
        if self.half_domain is not None and self.body.stiffness != "half_space":
            raise ValueError(
                "half_domain is for half-spaces: the film of a meshed body reaches as far as its contact edge; "
                "leave it out, and give body.shape a wider edge_width"
            )
        return self

    @model_validator(mode="after")
    def _surface_is_no_shape(self) -> Scene:
        height, shape = getattr(self.surface, "rms_roughness", None), self.body.shape
        if shape.kind == "cylinder" and height is not None and height > shape.radius * ROUGHEST:
            raise ValueError(
                f"surface.rms_roughness of {height:g} m is more than a tenth of body.shape.radius, "
                f"{shape.radius:g} m; check the units, a plain number is in m"
            )
        return self

    def canonical(self) -> dict[str, Any]:
        """The scene in SI with every default filled in, as nodes of the plan carry it; without shear strength."""
        name = DEFAULT_LAWS[self.surface.kind]
        law = self.contact_law or parts.model_of(parts.LAWS[name], "name", name)()
        return {
            "body": self.body.canonical(),
            "surface": self.surface.model_dump(),
            "contact_law": law.model_dump(),
            "lubricant": self.lubricant.model_dump(),
            "half_domain": self.half_domain,
        }
