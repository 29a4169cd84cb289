"""Studies: from a study file to the plan of what is to be computed.

Nothing here solves anything or imports what does: the workflow imports this at every start. The names below are loaded
when they are first used: a job takes parts of a study's vocabulary and reads no study.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from softlub.study.messages import StudyError
    from softlub.study.nodes import Node, Plan, merge
    from softlub.study.parsed import Study
    from softlub.study.planning import plan
    from softlub.study.reader import load
    from softlub.study.selection import select, study_files

__all__ = ["Node", "Plan", "Study", "StudyError", "load", "merge", "plan", "select", "study_files"]

_HOMES = {
    "Node": "nodes",
    "Plan": "nodes",
    "Study": "parsed",
    "StudyError": "messages",
    "load": "reader",
    "merge": "nodes",
    "plan": "planning",
    "select": "selection",
    "study_files": "selection",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
