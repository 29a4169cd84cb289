"""What else than shapes and materials a scene can be made of, and the models that read all parts from a study file.

A new surface, law or solver is one more line here; shapes and materials have theirs in `softlub.study.kinds`.
"""

from __future__ import annotations

from dataclasses import MISSING, fields, is_dataclass
from functools import cache
from typing import Annotated, Any, ClassVar, Literal, Union, get_args, get_origin, get_type_hints

from pydantic import create_model, model_validator

from softlub.lubrication.film import Lubricant
from softlub.solid.materials.prony import PronySeries
from softlub.study import options, solid_options
from softlub.study.base import StudyModel
from softlub.study.fields import Choice, Quantity, Single, Tagged, Text
from softlub.study.kinds import ALTERNATIVES, field_names
from softlub.study.ranges import Series
from softlub.surfaces.measurement import Measured, MeasuredLine
from softlub.surfaces.spectrum import Smooth
from softlub.surfaces.synthetic import Synthetic, SyntheticLine
from softlub.units import Unit

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
MESH: type = solid_options.MeshOptions
STEPS: type = solid_options.StepOptions

PLATE_LAWS: dict[str, type] = {
    "hard": solid_options.HardContactOptions,
    **{word: part for word, part in LAWS.items() if word != "none"},
}
"""What a finite-element body meets: a smooth plate, or the asperity law of a rough one."""
FILES: dict[type, tuple[str, ...]] = {PronySeries: ("file", "dmta")}
"""Keys by which a part's numbers may be a CSV file's (softlub.study.solid_files)."""

UNBUILT_SHAPES = {"wiper": "the blade comes with the studies of chapter 7"}
UNBUILT_STIFFNESS = dict.fromkeys(("deformed", "auto"), "the film knows the undeformed body's stiffness only")
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
            self.build()
        return self

    def build(self) -> Any:
        """The part itself, with its own parts built."""
        assert self.part is not None
        values = {name: getattr(self, name) for name in field_names(self.part)}
        return self.part(
            **{
                name: value.build() if isinstance(value, PartModel) else value
                for name, value in values.items()
            }
        )


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


def field_type(hint: Any) -> Any:
    """A field's annotation as the study reader reads it."""
    if get_origin(hint) is Literal:
        return Annotated[str, Choice(get_args(hint))]
    if hint is str or set(get_args(hint)) == {str, int}:
        return Annotated[hint, Text(numbers=hint is not str)]
    if hint in ALTERNATIVES:
        return Annotated[Any, Tagged("kind", models_of(ALTERNATIVES[hint]), bare="name of a block")]
    if isinstance(hint, type) and is_dataclass(hint):
        return Annotated[Any, Single(model_of(hint), bare="block itself", files=FILES.get(hint, ()))]
    unit = unit_of(hint)
    if get_origin(hint) is tuple and unit is not None:
        return Annotated[tuple[float, ...], Series(unit)]
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
