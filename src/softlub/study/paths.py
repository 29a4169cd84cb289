"""Fields of a nested block by their dotted path."""

from __future__ import annotations

import copy
from typing import Any


def get(block: Any, path: str) -> Any:
    """The value at a path; KeyError where there is none."""
    for key in path.split("."):
        block = block[key]
    return block


def replaced(block: Any, path: str, value: Any) -> Any:
    """A copy of the block with the value at a path set; blocks on the way are made where they are missing.

    Parameters
    ----------
    block : Any
        Nested dicts.
    path : str
        Keys joined by dots.
    value : Any

    Returns
    -------
    Any

    Raises
    ------
    KeyError
        If the path leads through something that holds no keys.
    """
    changed = copy.deepcopy(block)
    place = changed
    *parents, last = path.split(".")
    for key in parents:
        if not isinstance(place, dict):
            raise KeyError(key)
        if place.get(key) is None:
            place[key] = {}
        place = place[key]
    if not isinstance(place, dict):
        raise KeyError(last)
    place[last] = value
    return changed
