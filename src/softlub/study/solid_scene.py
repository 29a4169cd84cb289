"""Scenes of finite-element bodies: what is pressed on a plate and slid, and materials by themselves."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, model_validator

from softlub.solid.elements import ELEMENTS
from softlub.study import kinds, parts
from softlub.study.base import StudyModel
from softlub.study.fields import Choice, Quantity, Single, Tagged
from softlub.study.scene import DEFAULT_LAWS, MESH, Material, Mesh, Surface, lacks_heights
from softlub.units import Unit

MeshedShape = Annotated[
    Any,
    Tagged(
        "kind",
        parts.models_of(kinds.MESHED_SHAPES),
        unbuilt=parts.UNBUILT_SHAPES,
        bare="name of a block in config/shapes",
    ),
]
PlateLaw = Annotated[
    Any, Tagged("name", parts.models_of(parts.PLATE_LAWS, "name"), bare="hard, or name of a contact law")
]
STEPS = parts.model_of(parts.STEPS)
Steps = Annotated[Any, Single(STEPS, bare="block itself")]
TimeTemperature = Annotated[Any, Single(parts.model_of(kinds.TIME_TEMPERATURE), bare="block itself")]


class MeshedBody(StudyModel):
    """A body of finite elements."""

    shape: MeshedShape
    material: Material
    element: Annotated[str, Choice(tuple(ELEMENTS))] = "mean_dilatation"
    mesh: Mesh = Field(default_factory=MESH)

    @model_validator(mode="after")
    def _element_can_keep_its_volume(self) -> MeshedBody:
        if refused := locks(self.material, self.element):
            raise ValueError(refused)
        return self

    def canonical(self) -> dict[str, Any]:
        """The body in SI."""
        return {
            "shape": self.shape.model_dump(),
            "material": self.material.model_dump(),
            "element": self.element,
            "mesh": self.mesh.model_dump(),
        }


def locks(material: Any, element: str) -> str:
    """Why an element cannot follow a material; empty where it can."""
    relaxing = material.kind == "viscoelastic"
    poisson_ratio = getattr(material.hyperelastic if relaxing else material, "poisson_ratio", 0.0)
    where = "material.hyperelastic" if relaxing else "material"
    if element == "full_integration" and poisson_ratio >= 0.5:
        return (
            f"{where}.poisson_ratio = {poisson_ratio:g} keeps every volume, and element full_integration locks; "
            "allowed with it: mean_dilatation, reduced_integration, or a poisson_ratio below 0.5"
        )
    return ""


class SolidScene(StudyModel):
    """A body pressed on a plate and slid over it; without a surface the plate is smooth."""

    body: MeshedBody
    surface: Surface = Field(
        default_factory=lambda: parts.model_of(parts.SURFACES["smooth"], "kind", "smooth")()
    )
    contact_law: PlateLaw = None
    friction: Annotated[float, Quantity(Unit("1", at_least=0, at_most=5))] = 0.0
    steps: Steps = Field(default_factory=STEPS)

    @model_validator(mode="after")
    def _law_fits_surface(self) -> SolidScene:
        law, surface = self.contact_law, self.surface
        if surface.kind == "smooth":
            if law is not None and law.name != "hard":
                raise ValueError(
                    f"contact_law {law.name} needs a rough surface, and the surface is smooth; give scene.surface, "
                    "or take hard"
                )
            return self
        if law is not None and law.name == "hard":
            raise ValueError("contact_law hard knows no roughness; leave out surface, or take persson")
        name = DEFAULT_LAWS[surface.kind] if law is None else law.name
        if name == "boundary_element" and (lack := lacks_heights(surface)):
            raise ValueError(f"contact_law boundary_element {lack}")
        if name in ("persson", "exponential") and surface.kind == "measured":
            raise ValueError(
                f"contact_law {name} needs a spectrum, and the surface is measured; take boundary_element"
            )
        return self

    def canonical(self) -> dict[str, Any]:
        """The scene in SI with every default filled in, but for the mesh that the accuracy sets."""
        name = "hard" if self.surface.kind == "smooth" else DEFAULT_LAWS[self.surface.kind]
        law = self.contact_law or parts.model_of(parts.PLATE_LAWS[name], "name", name)()
        return {
            "body": self.body.canonical(),
            "surface": self.surface.model_dump(),
            "contact_law": law.model_dump(),
            "friction": self.friction,
            "steps": self.steps.model_dump(),
        }


class EquivalenceScene(SolidScene):
    """The same with a viscoelastic body, whose hyperelastic equivalent is sought."""

    @model_validator(mode="after")
    def _material_relaxes(self) -> EquivalenceScene:
        material = self.body.material
        kind = material.kind
        if kind == "viscoelastic" and material.hyperelastic.kind == "neo_hookean":
            return self
        found = f"viscoelastic on {material.hyperelastic.kind}" if kind == "viscoelastic" else kind
        raise ValueError(
            f"body.material is {found}; an equivalent hyperelastic body (equations 5-17 and 5-18) is sought for a "
            "viscoelastic material on neo_hookean only"
        )


class MaterialBody(StudyModel):
    """A material, and the shape whose reduced stiffness is asked for where one is."""

    material: Material
    shape: MeshedShape = None
    element: Annotated[str, Choice(tuple(ELEMENTS))] = "mean_dilatation"
    mesh: Mesh = Field(default_factory=MESH)

    @model_validator(mode="after")
    def _element_can_keep_its_volume(self) -> MaterialBody:
        if self.shape is not None and (refused := locks(self.material, self.element)):
            raise ValueError(refused)
        return self


class MaterialScene(StudyModel):
    """A viscoelastic material by itself."""

    body: MaterialBody
    time_temperature: TimeTemperature = None

    @model_validator(mode="after")
    def _material_relaxes(self) -> MaterialScene:
        kind = self.body.material.kind
        if kind != "viscoelastic":
            raise ValueError(
                f"body.material is {kind}, whose moduli depend on no frequency; allowed: viscoelastic"
            )
        return self

    def canonical(self) -> dict[str, Any]:
        """The scene in SI with every default filled in, but for the mesh that the accuracy sets."""
        body = self.body
        own = (
            {}
            if body.shape is None
            else {
                "shape": body.shape.model_dump(),
                "element": body.element,
                "mesh": body.mesh.model_dump(),
            }
        )
        shift = self.time_temperature
        return {
            "body": {"material": body.material.model_dump(), **own},
            "surface": None,
            "time_temperature": None if shift is None else shift.model_dump(),
        }
