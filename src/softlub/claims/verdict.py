"""What a check returns, and the datasets that it is given."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, NamedTuple

import xarray as xr

Word = Literal["reproduced", "differs", "not decidable", "not computed", "missing"]
WORDS: tuple[Word, ...] = ("reproduced", "differs", "not decidable", "not computed", "missing")
"""Verdicts; ``missing`` is no check's answer, it means that there is none."""


class Verdict(NamedTuple):
    """One check's answer: our value in words, the verdict, and why."""

    value: str
    verdict: Word
    reason: str


class NotComputed(Exception):
    """What a check needs has not been computed; the message says what."""


class Datasets:
    """Datasets of studies, opened once and only when a check asks for them.

    Parameters
    ----------
    open_dataset : callable
        Study's name -> dataset, or None where it has not been computed.
    """

    def __init__(self, open_dataset: Callable[[str], xr.Dataset | None]) -> None:
        self._open = open_dataset
        self._held: dict[str, xr.Dataset | None] = {}

    def __call__(self, study: str) -> xr.Dataset:
        """Dataset of a study.

        Parameters
        ----------
        study : str

        Returns
        -------
        xarray.Dataset

        Raises
        ------
        NotComputed
            If there is none.
        """
        if study not in self._held:
            self._held[study] = self._open(study)
        dataset = self._held[study]
        if dataset is None:
            raise NotComputed(f"study {study} has not been computed")
        return dataset


Check = Callable[[Datasets], Verdict]
CHECKS: dict[str, Check] = {}
"""Every check, by the id of its row; filled as the chapters' files are imported."""


def check(*rows: str) -> Callable[[Check], Check]:
    """Register a function as the check of one or more rows."""

    def register(function: Check) -> Check:
        for row in rows:
            if row in CHECKS:
                raise ValueError(f"row {row} has two checks")
            CHECKS[row] = function
        return function

    return register


def judge(holds: bool, value: str, reason: str) -> Verdict:
    """Reproduced where the statement holds for our numbers, else differs."""
    return Verdict(value, "reproduced" if holds else "differs", reason)


def state(verdict: Word, reasons: dict[str, str]) -> None:
    """Register rows whose verdict needs no number of ours, each with its reason."""

    def constant(reason: str) -> Check:
        return lambda datasets: Verdict("", verdict, reason)

    for row, reason in reasons.items():
        check(row)(constant(reason))
