"""The soft solid: shapes, materials, finite elements, reduced stiffness.

The names below are loaded when they are first used: the study reader needs the parameters alone, and no elements.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from softlub.solid.body import Body
    from softlub.solid.compliance import MeshedCompliance
    from softlub.solid.equivalence import fit_coefficient
    from softlub.solid.mesh import BodyMesh
    from softlub.solid.reduced_stiffness import ReducedStiffness
    from softlub.solid.reduction import condense
    from softlub.solid.steps import run

__all__ = ["Body", "BodyMesh", "MeshedCompliance", "ReducedStiffness", "condense", "fit_coefficient", "run"]

_HOMES = {
    "Body": "body",
    "BodyMesh": "mesh",
    "MeshedCompliance": "compliance",
    "ReducedStiffness": "reduced_stiffness",
    "condense": "reduction",
    "fit_coefficient": "equivalence",
    "run": "steps",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
