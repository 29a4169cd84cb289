"""What a user reads when a study file is wrong: one message, all its problems, no traceback."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

LONGEST_VALUE = 60
"""Characters of a value that a message quotes."""


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong in a file.

    Parameters
    ----------
    key : str
        Where in the file, parts joined by dots; empty for the file as a whole.
    text : str
        What is wrong and what is allowed.
    value : str
        The offending value as quoted in the message; empty where there is none to show.
    """

    key: str
    text: str
    value: str = ""

    def __str__(self) -> str:
        place = " = ".join(part for part in (self.key, self.value) if part)
        return f"{place}: {self.text}" if place else self.text


class StudyError(Exception):
    """A study that cannot be used; its text is the whole message for the user.

    Parameters
    ----------
    where : str
        The file.
    problems : iterable of Problem
        Everything found wrong in it; equal ones are said once.
    """

    def __init__(self, where: str, problems: Iterable[Problem]) -> None:
        self.where = where
        self.problems = tuple(dict.fromkeys(problems))
        super().__init__(where, self.problems)

    def __str__(self) -> str:
        if len(self.problems) == 1:
            return f"{self.where}: {self.problems[0]}"
        lines = [
            f"{self.where}: {len(self.problems)} problems",
            *(f"  {problem}" for problem in self.problems),
        ]
        return "\n".join(lines)


def shown(value: Any) -> str:
    """A value as a message quotes it: short, texts in quotes, whole blocks left out."""
    if isinstance(value, (dict, list, tuple)):
        return "" if isinstance(value, dict) else _shortened(str(list(value)))
    if value is None:
        return "(empty)"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, (int, float)):
        return _shortened(f"{value:.12g}" if isinstance(value, float) else _digits(value))
    return f'"{_shortened(str(value))}"'


def _digits(value: int) -> str:
    # Python refuses to print integers of more than some thousand digits.
    return str(value) if value.bit_length() < 1000 else "an integer of more than 300 digits"


def _shortened(text: str) -> str:
    return text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 1] + "…"


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known word closest to a misspelt one, if any is close."""
    choices = {choice.lower(): choice for choice in known}
    found = difflib.get_close_matches(word.lower(), choices, n=1, cutoff=0.6)
    return choices[found[0]] if found else None


def did_you_mean(word: str, known: Sequence[str], what: str = "allowed") -> str:
    """Tail of a message about an unknown word: the nearest known one, then all of them."""
    close = nearest(word, known)
    hint = f"did you mean {close}? " if close else ""
    return f"{hint}{what}: {', '.join(known)}" if known else f"{hint}{what}: none"
