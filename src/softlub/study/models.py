"""Study files as a whole, one model a kind of study, but for what their swept fields hold."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, model_validator

from softlub.study.accuracy import ACCURACIES
from softlub.study.base import StudyModel
from softlub.study.contact_grid import ContactGrid, ContactSolver, DeflectionGrid, SurfaceGrid
from softlub.study.contact_scene import ContactScene, DeflectionScene, SurfaceScene
from softlub.study.fields import Choice, Words
from softlub.study.figures import FigureEntry
from softlub.study.grid import Grid
from softlub.study.outputs import CONTACT_OUTPUTS, OUTPUTS, SOLID_OUTPUTS, SURFACE_OUTPUTS
from softlub.study.ranges import Values
from softlub.study.scene import Scene
from softlub.study.solid_grid import Datum, EquivalenceGrid, MaterialGrid, SolidGrid
from softlub.study.solid_scene import EquivalenceScene, MaterialScene, SolidScene
from softlub.study.solvers import Solver
from softlub.units import Unit

KINDS = ("stribeck", "rough_contact", "surface", "deflection", "solid", "equivalence", "material")
COMPARED = ("reduced", "constrained", "half_space")
_UNBUILT_KINDS = {
    "benchmark": "benchmarks have a folder of their own, benchmarks/",
}


class StandIn(StudyModel):
    """An input that the source does not print, and why this value stands in for it."""

    key: str
    reason: Annotated[str, Field(min_length=1)]


class CommonFile(StudyModel):
    """What every study file may hold."""

    title: str | None = None
    about: str | None = None
    kind: Annotated[str, Choice(KINDS, _UNBUILT_KINDS)] = "stribeck"
    accuracy: Annotated[str, Choice(ACCURACIES)] | None = None
    figures: list[FigureEntry] = Field(default_factory=list)
    stand_ins: list[StandIn] = Field(default_factory=list)

    @model_validator(mode="after")
    def _figures_differ(self) -> CommonFile:
        names = [figure.name.lower() for figure in self.figures]
        twice = {name for name in names if names.count(name) > 1}
        if twice:
            raise ValueError(
                f"two figures have the name {', '.join(sorted(twice))}; give each a name of its own"
            )
        return self

    @model_validator(mode="after")
    def _solver_is_given_once(self) -> CommonFile:
        own, swept = getattr(self, "solver", None), getattr(getattr(self, "grid", None), "solver", None)
        if own is not None and swept is not None:
            raise ValueError("solver is given twice: as solver and as grid.solver; keep one")
        return self


class StudyFile(CommonFile):
    """A study of a lubricated contact over load and speed."""

    scene: Scene
    grid: Grid
    solver: Solver = None
    outputs: Annotated[tuple[str, ...], Words(tuple(OUTPUTS))] | None = None


class RoughContactFile(CommonFile):
    """A study of rough surfaces under load."""

    scene: ContactScene
    grid: ContactGrid = Field(default_factory=ContactGrid)
    solver: ContactSolver = None
    outputs: Annotated[tuple[str, ...], Words(tuple(CONTACT_OUTPUTS))] | None = None
    gap_thresholds: Annotated[tuple[float, ...], Values(Unit("m", above=0))] = ()


class SurfaceFile(CommonFile):
    """A study of surfaces and lines by themselves."""

    scene: SurfaceScene
    grid: SurfaceGrid = Field(default_factory=SurfaceGrid)
    outputs: Annotated[tuple[str, ...], Words(tuple(SURFACE_OUTPUTS))] | None = None


class DeflectionFile(CommonFile):
    """A study of the half-space's deflection under a sphere, by several methods."""

    scene: DeflectionScene
    grid: DeflectionGrid


class SolidFile(CommonFile):
    """A study of a body pressed on a plate and slid, by finite elements and by what stands for them."""

    scene: SolidScene
    grid: SolidGrid
    compare: Annotated[tuple[str, ...], Words(COMPARED)] = ("reduced",)
    datum: Datum = ()
    outputs: Annotated[tuple[str, ...], Words(SOLID_OUTPUTS)] | None = None

    @model_validator(mode="after")
    def _datum_is_known(self) -> SolidFile:
        if "half_space" in self.compare and not self.datum:
            raise ValueError(
                "compare has half_space, whose deflection is known up to a constant; give datum, the distance from "
                "the load's middle at which it is 0, such as datum: [10 mm, 1 m]"
            )
        if self.datum and "half_space" not in self.compare:
            raise ValueError(
                "datum is that of half_space, which is not among compare; add it or leave out datum"
            )
        return self


class EquivalenceFile(CommonFile):
    """A study of a viscoelastic body and of the hyperelastic one that takes its shape."""

    scene: EquivalenceScene
    grid: EquivalenceGrid
    outputs: Annotated[tuple[str, ...], Words(SOLID_OUTPUTS)] | None = None


class MaterialFile(CommonFile):
    """A study of a material's moduli over frequency."""

    scene: MaterialScene
    grid: MaterialGrid

    @model_validator(mode="after")
    def _has_what_it_needs(self) -> MaterialFile:
        if self.grid.stiffness_frequency and self.scene.body.shape is None:
            raise ValueError("grid.stiffness_frequency asks for reduced stiffnesses; give scene.body.shape")
        if self.grid.temperature and self.scene.time_temperature is None:
            raise ValueError(
                "grid.temperature needs constants of the shift; give scene.time_temperature: "
                "{first_constant: …, second_constant: …, reference_temperature: …}"
            )
        return self


FILES: dict[str, Any] = {
    "stribeck": StudyFile,
    "rough_contact": RoughContactFile,
    "surface": SurfaceFile,
    "deflection": DeflectionFile,
    "solid": SolidFile,
    "equivalence": EquivalenceFile,
    "material": MaterialFile,
}
SCENES: dict[str, Any] = {
    "stribeck": Scene,
    "rough_contact": ContactScene,
    "surface": SurfaceScene,
    "deflection": DeflectionScene,
    "solid": SolidScene,
    "equivalence": EquivalenceScene,
    "material": MaterialScene,
}
"""Model of a file and of its scene, by the kind of study."""
