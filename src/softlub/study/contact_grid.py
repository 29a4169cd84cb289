"""Grids of studies without a film: pressures of a rough contact, its solvers, swept fields of the scene."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

from pydantic import ConfigDict, Field, model_validator

from softlub.study import kinds, parts
from softlub.study.base import StudyModel
from softlub.study.fields import Quantity, Tagged
from softlub.study.grid import SWEPT_SCHEMA
from softlub.study.parts import PartModel
from softlub.study.ranges import Values
from softlub.units import Unit


class ContactSolverModel(PartModel):
    """Solver of a rough contact with its settings."""

    label: str | None = None

    @property
    def options(self) -> dict[str, Any]:
        """What tells it from others of its name, as its label says."""
        return {name: getattr(self, name) for name in kinds.field_names(self.part)} if self.part else {}


ContactSolver = Annotated[
    Any,
    Tagged(
        "name",
        {
            word: parts.model_of(part, "name", word, ContactSolverModel)
            for word, part in parts.CONTACT_SOLVERS.items()
        },
        bare="name of a solver of rough contact",
    ),
]


class SurfaceGrid(StudyModel):
    """Swept fields of the scene, which are read apart."""

    model_config = ConfigDict(json_schema_extra=SWEPT_SCHEMA)
    further_keys: ClassVar[str] = "any field of the scene as scene.…"


class DeflectionGrid(StudyModel):
    """Force on a sphere, and the grid that its deflection is computed on."""

    force: Annotated[float, Quantity(Unit("N", above=0))]
    points: Annotated[int, Quantity(Unit("1", at_least=3, at_most=1025), whole=True)] = 129

    @model_validator(mode="after")
    def _a_point_lies_on_the_axis(self) -> DeflectionGrid:
        if self.points % 2 == 0:
            raise ValueError(
                f"points {self.points} is even, and no point would lie on the axis; take an odd number"
            )
        return self


class ContactGrid(SurfaceGrid):
    """Nominal pressures, over E* h'_rms or in Pa, and solvers; swept fields of the scene are read apart."""

    further_keys: ClassVar[str] = "and any field of the scene as scene.…"
    normalised_pressure: Annotated[tuple[float, ...], Values(Unit("1", above=0))] | None = None
    pressure: Annotated[tuple[float, ...], Values(Unit("Pa", above=0))] | None = None
    solver: Annotated[list[ContactSolver], Field(min_length=1)] | None = None

    @model_validator(mode="after")
    def _pressure_is_given_once(self) -> ContactGrid:
        if self.normalised_pressure is not None and self.pressure is not None:
            raise ValueError("pressures are given twice: as normalised_pressure and as pressure; keep one")
        return self


def default_contact_solver() -> Any:
    """The solver of a rough contact where the study names none."""
    name = "conjugate_gradients"
    return parts.model_of(parts.CONTACT_SOLVERS[name], "name", name, ContactSolverModel)()
