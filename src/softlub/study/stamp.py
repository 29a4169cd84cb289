"""What the datasets of all studies tell of themselves, and the revisions of the stages that made them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from softlub.study.nodes import digest
from softlub.study.parsed import Study

REVISIONS = {
    "panel": 2,
    "study": 2,
    "figure": 3,
    "law": 2,
    "topography": 2,
    "state": 1,
    "stiffness": 1,
    "equivalence": 1,
}
"""Raised when a stage's results change without a change of its spec: all its nodes are then computed anew."""


def stamp(study: Study, description: Mapping[str, Any]) -> dict[str, Any]:
    """Name, title, stand-ins and definition of a study, for its node's spec."""
    return {
        "study": study.name,
        "title": study.title,
        "stand_ins": [{"key": entry.key, "reason": entry.reason} for entry in study.stand_ins],
        "definition": dict(description),
        "definition_hash": digest(description),
    }


def plain(value: Any) -> Any:
    """A value as JSON knows it."""
    if isinstance(value, Mapping):
        return {str(key): plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    return value
