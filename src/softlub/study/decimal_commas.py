"""Decimal commas inside braces: YAML reads ``{radius: 3,5 mm}`` as ``radius: 3`` and a key ``5 mm`` without a value."""

from __future__ import annotations

import re
from typing import Any

from softlub.study.messages import Problem

_BEFORE = re.compile(r"[+-]?[0-9]+")
_AFTER = re.compile(r"[0-9]")


def joined_again(block: Any, place: str = "") -> tuple[Any, list[Problem]]:
    """A copy of a block with such numbers put together, so that nothing else is found wrong because of them.

    Parameters
    ----------
    block : Any
        As it stands in the file, whatever that is.
    place : str
        Where it stands, for the messages.

    Returns
    -------
    block : Any
    problems : list of Problem
        One for each number.
    """
    problems: list[Problem] = []
    if isinstance(block, list):
        entries = [joined_again(entry, f"{place}[{index + 1}]") for index, entry in enumerate(block)]
        return [entry for entry, _ in entries], [problem for _, found in entries for problem in found]
    if not isinstance(block, dict):
        return block, problems
    whole: dict[Any, Any] = {}
    before: Any = None
    for key, value in block.items():
        if value is None and _is_rest(key) and _is_start(whole.get(before)):
            start = whole[before]
            whole[before] = f"{start}.{key}"
            text = f"a decimal comma? numbers have a decimal point: {start}.{key}"
            problems.append(Problem(_below(place, before), text, f"{start},{key}"))
            before = None
            continue
        whole[key], found = joined_again(value, _below(place, key))
        problems += found
        before = key
    return whole, problems


def _is_rest(key: Any) -> bool:
    return isinstance(key, (str, int)) and _AFTER.match(str(key)) is not None


def _is_start(value: Any) -> bool:
    is_text = isinstance(value, (str, int)) and not isinstance(value, bool)
    return is_text and _BEFORE.fullmatch(str(value)) is not None


def _below(place: str, key: Any) -> str:
    return f"{place}.{key}".removeprefix(".")
