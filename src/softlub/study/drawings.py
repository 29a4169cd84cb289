"""The drawings that a study may ask for, and what each needs; `softlub.figures` draws them.

The study layer keeps a list of its own because it must not import matplotlib; a test holds the two lists together.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from softlub.study.fields import Choice, JsonSchema, Quantity, Words
from softlub.study.outputs import OUTPUTS, SCALARS
from softlub.units import Unit

SPEED = Quantity(Unit("m/s", above=0))
HEIGHT = Quantity(Unit("1", above=1, at_most=20))
"""Of a figure [inch]; every drawing has it."""
VARIABLE = Choice(tuple(name for group in SCALARS for name in OUTPUTS[group]))
MODULES = Words(("bml", "mehl", "ehl", "spectral", "finite_volume", "auto"))


class Reader(Protocol):
    """How an option is read and described."""

    def read(self, value: Any) -> Any:
        """The option's value, or a refusal."""
        ...

    def json_schema(self) -> JsonSchema:
        """What may be written."""
        ...


@dataclass(frozen=True)
class Drawing:
    """What a drawing needs of its study.

    Parameters
    ----------
    fields : bool
        Whether it draws pressures and separation over x, which are kept only when somebody needs them.
    needs : str
        What must be swept: ``"solver"``, ``"field"`` (of the scene), ``"sample"``; empty for nothing.
    options : mapping
        Option -> how it is read.
    """

    fields: bool = False
    needs: str = ""
    options: Mapping[str, Reader] = field(default_factory=dict)


DRAWINGS: dict[str, Drawing] = {
    "stribeck": Drawing(options={"variable": VARIABLE}),
    "load_share": Drawing(),
    "friction_and_separation": Drawing(),
    "profiles": Drawing(fields=True, options={"speed": SPEED, "amplify": Quantity(Unit("1", above=0))}),
    "sweep_comparison": Drawing(fields=True, needs="solver", options={"speed": SPEED}),
    "module_comparison": Drawing(fields=True, needs="solver", options={"speed": SPEED, "solvers": MODULES}),
    "parameter_study": Drawing(needs="field"),
    "regime_map": Drawing(
        needs="sample", options={"cells": Quantity(Unit("1", at_least=2, at_most=500), whole=True)}
    ),
    "sensitivity": Drawing(
        needs="sample", options={"bins": Quantity(Unit("1", at_least=2, at_most=500), whole=True)}
    ),
}

NEEDS = {
    "solver": "several solvers: list them under grid.solver",
    "field": "a swept field of the scene, such as grid: {scene.body.material.young_modulus: [10 MPa, 20 MPa]}",
    "sample": "a designed sample: grid.sample",
}
