"""Contact of rough surfaces: deterministic solvers, Persson's theory, contact laws.

The names of the deterministic solver are loaded when they are first used: contact laws must not wait for it.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from softlub.contact.displacement_control import solve_at_approach, solve_at_mean_gap
    from softlub.contact.load_sweep import descend, sweep
    from softlub.contact.polonsky_keer import solve_polonsky_keer
    from softlub.contact.rough_contact import RoughContact, solve
    from softlub.contact.solution import ContactSolution

__all__ = [
    "ContactSolution",
    "RoughContact",
    "descend",
    "solve",
    "solve_at_approach",
    "solve_at_mean_gap",
    "solve_polonsky_keer",
    "sweep",
]

_HOMES = {
    "ContactSolution": "solution",
    "RoughContact": "rough_contact",
    "descend": "load_sweep",
    "solve": "rough_contact",
    "solve_at_approach": "displacement_control",
    "solve_at_mean_gap": "displacement_control",
    "solve_polonsky_keer": "polonsky_keer",
    "sweep": "load_sweep",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
