"""A study file as a whole, but for what its swept fields hold."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, model_validator

from softlub.study.accuracy import ACCURACIES
from softlub.study.base import StudyModel
from softlub.study.fields import Choice, Words
from softlub.study.figures import FigureEntry
from softlub.study.grid import Grid
from softlub.study.outputs import OUTPUTS
from softlub.study.scene import Scene
from softlub.study.solvers import Solver

_UNBUILT_KINDS = {
    "rough_contact": "rough contact is not taken into studies yet",
    "solid": "finite elements are not there yet",
    "equivalence": "finite elements are not there yet",
    "surface": "topographies are not taken into studies yet",
    "material": "only linear elasticity is there",
    "benchmark": "benchmarks have a folder of their own, benchmarks/",
}


class StandIn(StudyModel):
    """An input that the source does not print, and why this value stands in for it."""

    key: str
    reason: Annotated[str, Field(min_length=1)]


class StudyFile(StudyModel):
    """A study file."""

    title: str | None = None
    about: str | None = None
    kind: Annotated[str, Choice(("stribeck",), _UNBUILT_KINDS)] = "stribeck"
    scene: Scene
    grid: Grid
    solver: Solver = None
    accuracy: Annotated[str, Choice(ACCURACIES)] | None = None
    outputs: Annotated[tuple[str, ...], Words(tuple(OUTPUTS))] | None = None
    figures: list[FigureEntry] = Field(default_factory=list)
    stand_ins: list[StandIn] = Field(default_factory=list)

    @model_validator(mode="after")
    def _solver_is_given_once(self) -> StudyFile:
        if self.solver is not None and self.grid.solver is not None:
            raise ValueError("solver is given twice: as solver and as grid.solver; keep one")
        return self

    @model_validator(mode="after")
    def _figures_differ(self) -> StudyFile:
        names = [figure.name.lower() for figure in self.figures]
        twice = {name for name in names if names.count(name) > 1}
        if twice:
            raise ValueError(
                f"two figures have the name {', '.join(sorted(twice))}; give each a name of its own"
            )
        return self
