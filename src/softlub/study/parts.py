"""What a scene can be made of: the parameter classes beside the physics, by the word that a study file uses.

A new material, shape, surface or law is one more line here.
"""

from __future__ import annotations

from dataclasses import MISSING, fields
from functools import cache
from typing import Annotated, Any, ClassVar, Literal, Union, get_args, get_origin, get_type_hints

from pydantic import create_model, model_validator

from softlub.lubrication.film import Lubricant
from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.solid.shapes.cylinder import Cylinder
from softlub.solid.shapes.sphere import Sphere
from softlub.study import options
from softlub.study.base import StudyModel
from softlub.study.fields import Choice, Quantity, Text
from softlub.surfaces.measurement import Measured, MeasuredLine
from softlub.surfaces.spectrum import Smooth
from softlub.surfaces.synthetic import Synthetic, SyntheticLine
from softlub.units import Unit

SHAPES: dict[str, type] = {"cylinder": Cylinder}
ROUND_SHAPES: dict[str, type] = {"sphere": Sphere}
MATERIALS: dict[str, type] = {"linear_elastic": LinearElastic}
SURFACES: dict[str, type] = {"self_affine": Synthetic, "measured": Measured, "smooth": Smooth}
LINES: dict[str, type] = {"self_affine_line": SyntheticLine, "measured_line": MeasuredLine}
LAWS: dict[str, type] = {
    "none": options.NoContactOptions,
    "exponential": options.ExponentialOptions,
    "persson": options.PerssonOptions,
    "boundary_element": options.BoundaryElementOptions,
}
CONTACT_SOLVERS: dict[str, type] = {
    "conjugate_gradients": options.ContactOptions,
    "polonsky_keer": options.PolonskyKeerOptions,
}
SOLVERS: dict[str, type] = {
    "auto": options.AutoOptions,
    "spectral": options.SpectralOptions,
    "finite_volume": options.FiniteVolumeOptions,
    "bml": options.ModuleOptions,
    "mehl": options.MixedModuleOptions,
    "ehl": options.ModuleOptions,
}
LUBRICANT: type = Lubricant

_MESHED = "meshed shapes come with the finite-element body"
UNBUILT_SHAPES = dict.fromkeys(("half_cylinder", "triangle", "wiper", "profile"), _MESHED)
UNBUILT_MATERIALS = dict.fromkeys(
    ("neo_hooke", "mooney_rivlin", "hyperelastic", "viscoelastic"), "only linear elasticity is there"
)
UNBUILT_STIFFNESS = dict.fromkeys(("initial", "deformed", "auto"), "meshed bodies are not there yet")
UNBUILT_KEYS: dict[type, dict[str, str]] = {
    Lubricant: {"flow_factor": "the film flows as between smooth walls"},
}
"""Keys of the design that this version does not know yet, and what it does instead."""

ABSENT_KEYS: dict[type, dict[str, str]] = {
    Smooth: dict.fromkeys(
        [entry.name for entry in fields(Synthetic)],
        "a smooth surface has none; take a surface of the kind self_affine",
    ),
}
"""Keys of a part's alternatives that it cannot have itself."""


class PartModel(StudyModel):
    """A block of a study file that holds the parameters of one part."""

    part: ClassVar[type | None] = None

    @model_validator(mode="after")
    def _parameters_agree(self) -> PartModel:
        """Let the part itself check what concerns several of its parameters."""
        if self.part is not None:
            self.part(**{name: getattr(self, name) for name in field_names(self.part)})
        return self


@cache
def model_of(part: type, tag: str = "", word: str = "", base: type[PartModel] = PartModel) -> Any:
    """Model of a study file's block from a parameter class.

    Parameters
    ----------
    part : type
        Dataclass whose fields carry their units.
    tag, word : str
        Key and word that tell the block from its alternatives; empty where there are none.
    base : type
        Model that the new one extends.

    Returns
    -------
    type
        A pydantic model with the class's fields, checks and defaults.
    """
    hints = get_type_hints(part, include_extras=True)
    entries: dict[str, Any] = {tag: (Literal[word], word)} if tag else {}
    for field in fields(part):
        default = ... if field.default is MISSING else field.default
        entries[field.name] = (field_type(hints[field.name]), default)
    name = f"{part.__name__}{word.title().replace('_', '')}" if tag == "name" else part.__name__
    model = create_model(name, __base__=base, __doc__=(part.__doc__ or "").split("\n", 1)[0], **entries)
    model.part = part
    model.unbuilt_keys = UNBUILT_KEYS.get(part, {})
    model.absent_keys = ABSENT_KEYS.get(part, {})
    return model


def models_of(parts: dict[str, type], tag: str = "kind") -> dict[str, Any]:
    """Models of the alternatives for one place of a scene, by their word."""
    return {word: model_of(part, tag, word) for word, part in parts.items()}


def field_names(part: type) -> list[str]:
    """Names of a parameter class's fields."""
    return [field.name for field in fields(part)]


def field_type(hint: Any) -> Any:
    """A field's annotation as the study reader reads it."""
    if get_origin(hint) is Literal:
        return Annotated[str, Choice(get_args(hint))]
    if hint is str or set(get_args(hint)) == {str, int}:
        return Annotated[hint, Text(numbers=hint is not str)]
    unit = unit_of(hint)
    if unit is not None and get_origin(hint) is Annotated:
        whole = get_args(hint)[0] is int
        return Annotated[int if whole else float, Quantity(unit, whole)]
    if type(None) in get_args(hint):
        kinds = tuple(argument for argument in get_args(hint) if argument is not type(None))
        return field_type(Union[kinds]) | None  # noqa: UP007 (as many as there are)
    raise TypeError(f"no way to read a field of type {hint}")


def unit_of(hint: Any) -> Unit | None:
    """Unit that an annotation carries, also inside an optional one."""
    own = [extra for extra in getattr(hint, "__metadata__", ()) if isinstance(extra, Unit)]
    inner = [unit for unit in (unit_of(argument) for argument in get_args(hint)) if unit is not None]
    return next(iter([*own, *inner]), None)
