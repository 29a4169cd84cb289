"""The grid of a study: loads, speeds, solvers, swept fields of the scene, or a designed sample of them."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

from pydantic import ConfigDict, Field, model_validator
from pydantic.config import JsonDict

from softlub.study.base import StudyModel
from softlub.study.fields import Quantity, refusal
from softlub.study.ranges import Values, range_schema
from softlub.study.solvers import Solver
from softlub.units import Unit

LOAD = Unit("N/m", above=0)
SPEED = Unit("m/s", above=0)
SWEPT = "scene."
"""How the key of a swept field of the scene begins."""

_ANY_QUANTITY = {"type": ["number", "string"]}


class Sample(StudyModel):
    """A Sobol design over ranges of the scene's fields and, where it is among them, the load."""

    points: Annotated[int, Quantity(Unit("1", at_least=1, at_most=500_000), whole=True)]
    seed: Annotated[int, Quantity(Unit("1", at_least=0, at_most=2**31 - 1), whole=True)] = 0
    ranges: Annotated[
        dict[str, Any], Field(json_schema_extra={"additionalProperties": range_schema(_ANY_QUANTITY, False)})
    ]

    @model_validator(mode="after")
    def _ranges_have_keys(self) -> Sample:
        if not self.ranges:
            raise ValueError(
                "ranges is empty; allowed: fields of the scene, such as scene.body.shape.radius, and load"
            )
        for key in self.ranges:
            if key != "load" and not key.startswith(SWEPT):
                raise ValueError(f"range {key}: unknown; allowed: fields of the scene, {SWEPT}…, and load")
        return self


SWEPT_SCHEMA: JsonDict = {
    "patternProperties": {
        "^scene\\.": {
            "anyOf": [
                {"type": "array", "minItems": 1, "items": {"type": ["number", "string", "object"]}},
                range_schema(_ANY_QUANTITY),
            ]
        }
    }
}
"""JSON schema of the swept fields of a scene."""


class Grid(StudyModel):
    """What is varied; swept fields of the scene are read apart, since their types are the scene's."""

    model_config = ConfigDict(json_schema_extra=SWEPT_SCHEMA)

    further_keys: ClassVar[str] = "and any field of the scene as scene.…"
    load: Annotated[tuple[float, ...], Values(LOAD)] | None = None
    speed: Annotated[tuple[float, ...], Values(SPEED)]
    solver: Annotated[list[Solver], Field(min_length=1)] | None = None
    sample: Sample | None = None

    @model_validator(mode="after")
    def _load_is_given_once(self) -> Grid:
        sampled = self.sample is not None and "load" in self.sample.ranges
        if sampled and self.load is not None:
            raise ValueError("load is given twice: as grid.load and as a range of the sample; keep one")
        if not sampled and self.load is None:
            raise ValueError("load is missing")
        if self.sample is not None and self.load is not None and len(self.load) > 1:
            raise ValueError("a sample takes one load, or a range of it among its ranges")
        return self


def check_swept_key(key: str) -> None:
    """Refuse what cannot be swept."""
    last = key.rpartition(".")[2]
    if last in ("kind", "name"):
        raise refusal(f"cannot be swept by itself; sweep {key.rpartition('.')[0]} and give whole blocks")
    if key == "scene.shear_strength" or key.startswith("scene.shear_strength."):
        raise refusal("cannot be swept yet; write one study for each, they share the panels")
    if key == "scene.body.stiffness":
        raise refusal("cannot be swept: no shape has both; write one study for each, or sweep scene.body")
