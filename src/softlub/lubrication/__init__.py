"""The lubricated line contact: problem, solvers, friction, sweeps over load and speed.

The names below are loaded when they are first used: the study reader needs the parameters alone.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from softlub.lubrication.face import solve, sweep
    from softlub.lubrication.film import Lubricant
    from softlub.lubrication.meshed_body import MeshedBody
    from softlub.lubrication.problem import HalfSpaceCylinder, Problem
    from softlub.lubrication.result import LubricatedContact

__all__ = ["HalfSpaceCylinder", "Lubricant", "LubricatedContact", "MeshedBody", "Problem", "solve", "sweep"]

_HOMES = {
    "HalfSpaceCylinder": "problem",
    "LubricatedContact": "result",
    "Lubricant": "film",
    "MeshedBody": "meshed_body",
    "Problem": "problem",
    "solve": "face",
    "sweep": "face",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
