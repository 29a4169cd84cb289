"""The drawings that a study may ask for, and what each needs; `softlub.figures` draws them.

The study layer keeps a list of its own because it must not import matplotlib; a test holds the two lists together.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from softlub.study.fields import Choice, JsonSchema, Quantity, Text, Words
from softlub.study.outputs import OUTPUTS, SCALARS
from softlub.units import Unit

SPEED = Quantity(Unit("m/s", above=0))
LOAD = Quantity(Unit("N/m", above=0))
LENGTH = Quantity(Unit("m", above=0))
FRICTION = Quantity(Unit("1", at_least=0))
STEADY_SLIDING = {"friction": FRICTION, "load": LOAD, "steps": Text()}
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
    kinds : tuple of str
        Kinds of studies whose datasets it draws.
    fields : bool
        Whether it draws pressures and separation over x, which are kept only when somebody needs them.
    maps, heights, topographies : bool
        Whether it draws maps of contact pressure and gap, heights of surfaces, or statistics and spectra of the
        surfaces of a rough contact: each is computed only when somebody needs it.
    mesh : bool
        Whether it draws all nodes of a finite-element body and its stress, which are kept only when somebody needs
        them.
    needs : str
        What must be swept: ``"solver"``, ``"field"`` (of the scene), ``"sample"``; empty for nothing.
    curves : int
        Curves over speed that it tells apart; 0 where it draws no such curves.
    options : mapping
        Option -> how it is read.
    """

    kinds: tuple[str, ...] = ("stribeck",)
    fields: bool = False
    maps: bool = False
    heights: bool = False
    topographies: bool = False
    mesh: bool = False
    needs: str = ""
    curves: int = 0
    options: Mapping[str, Reader] = field(default_factory=dict)


DRAWINGS: dict[str, Drawing] = {
    "stribeck": Drawing(curves=16, options={"variable": VARIABLE}),
    "load_share": Drawing(curves=8),
    "friction_and_separation": Drawing(curves=8),
    "profiles": Drawing(
        fields=True,
        options={
            "speed": SPEED,
            "load": LOAD,
            "amplify": Quantity(Unit("1", above=0)),
            "amplified": Text(),
        },
    ),
    "sweep_comparison": Drawing(fields=True, needs="solver", options={"speed": SPEED, "load": LOAD}),
    "module_comparison": Drawing(
        fields=True, needs="solver", options={"speed": SPEED, "load": LOAD, "solvers": MODULES}
    ),
    "parameter_study": Drawing(needs="field", curves=16),
    "regime_map": Drawing(
        needs="sample", options={"cells": Quantity(Unit("1", at_least=2, at_most=500), whole=True)}
    ),
    "sensitivity": Drawing(
        needs="sample", options={"bins": Quantity(Unit("1", at_least=2, at_most=500), whole=True)}
    ),
    "profile_stages": Drawing(kinds=("surface",)),
    "topography_map": Drawing(kinds=("surface",), heights=True),
    "self_affine_spectrum": Drawing(kinds=("surface",)),
    "surface_spectra": Drawing(kinds=("surface",)),
    "wavevector_spacing": Drawing(kinds=("surface",), heights=True, needs="field"),
    "spectra_and_heights": Drawing(kinds=("surface", "rough_contact"), topographies=True),
    "persson_separation": Drawing(kinds=("rough_contact",)),
    "area_and_separation": Drawing(kinds=("rough_contact",)),
    "contact_lines": Drawing(kinds=("rough_contact",), maps=True),
    "solver_comparison": Drawing(kinds=("rough_contact",)),
    "deflection": Drawing(kinds=("deflection",)),
    "mesh": Drawing(kinds=("solid",), mesh=True, options={"close_up": LENGTH}),
    "deformed_mesh": Drawing(
        kinds=("solid",), mesh=True, options={"friction": FRICTION, "load": LOAD, "close_up": LENGTH}
    ),
    "half_cylinder": Drawing(kinds=("solid",), mesh=True, options={"load": LOAD}),
    "reduced_against_full": Drawing(kinds=("solid",), options={"friction": FRICTION, "load": LOAD}),
    "matrix_entries": Drawing(kinds=("solid",), options={"friction": FRICTION, "load": LOAD}),
    "moduli": Drawing(kinds=("material",), options={"material": Text()}),
    "equivalent_shape": Drawing(kinds=("equivalence",), options=STEADY_SLIDING),
    "equivalent_against_full": Drawing(kinds=("equivalence",), options=STEADY_SLIDING),
}

NEEDS = {
    "solver": "several solvers: list them under grid.solver",
    "field": "a swept field of the scene, such as grid: {scene.body.material.young_modulus: [10 MPa, 20 MPa]}",
    "sample": "a designed sample: grid.sample",
}
