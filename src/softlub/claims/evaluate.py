"""Every claim judged by its check."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from importlib import import_module
from typing import NamedTuple

import xarray as xr

from softlub.claims.table import Claim
from softlub.claims.verdict import CHECKS, Datasets, NotComputed, Verdict

CHAPTERS = (
    "chapter2",
    "chapter3",
    "chapter3_profiles",
    "chapter3_modules",
    "chapter3_equations",
    "chapter3_elasticity",
    "chapter4",
    "chapter4_tables",
    "chapter4_theory",
    "chapter4_solver",
    "chapter4_validation",
    "chapter4_contact",
    "chapter4_spectrum",
    "chapter4_heights",
    "chapter5",
    "chapter5_matrix",
    "chapter5_materials",
    "chapter5_equivalence",
)
"""Files of checks."""


class Judgement(NamedTuple):
    """A claim and what became of it."""

    claim: Claim
    verdict: Verdict


def evaluate(claims: Iterable[Claim], open_dataset: Callable[[str], xr.Dataset | None]) -> list[Judgement]:
    """Judge claims.

    Parameters
    ----------
    claims : iterable of Claim
    open_dataset : callable
        Study's name -> its dataset, or None where it has not been computed.

    Returns
    -------
    list of Judgement
        In the order of the claims. A row without a check is ``missing``; a figure's row is judged by the claims
        that name the figure.
    """
    for chapter in CHAPTERS:
        import_module(f"softlub.claims.{chapter}")
    datasets = Datasets(open_dataset)
    claims = list(claims)
    judged = {claim.id: _judge(claim, datasets) for claim in claims}
    return [Judgement(claim, _figure_verdict(claim, claims, judged) or judged[claim.id]) for claim in claims]


def _judge(claim: Claim, datasets: Datasets) -> Verdict:
    if claim.id not in CHECKS:
        return Verdict("", "missing", "no check has been written for this row")
    try:
        return CHECKS[claim.id](datasets)
    except NotComputed as missing:
        return Verdict("", "not computed", str(missing))


def _figure_verdict(claim: Claim, claims: Sequence[Claim], judged: dict[str, Verdict]) -> Verdict | None:
    """Verdict of a figure without a check of its own: that of the statements made about it.

    The source prints no numbers for its curves, so that nothing else can be held against them.
    """
    if claim.kind != "figure" or claim.id in CHECKS or claim.id not in claim.figures:
        return None
    about = [other.id for other in claims if claim.id in other.figures and other.kind != "figure"]
    by_word: dict[str, list[str]] = {}
    for row in about:
        by_word.setdefault(judged[row].verdict, []).append(row)
    counts = "; ".join(f"{word}: {', '.join(rows)}" for word, rows in sorted(by_word.items()))
    reason = f"the source prints no data of this figure; judged by what it says about it ({counts})"
    if "differs" in by_word:
        mixed = "in part: " if "reproduced" in by_word else ""
        return Verdict("", "differs", f"{mixed}{reason}")
    if "reproduced" in by_word and not by_word.keys() & {"not computed", "missing"}:
        return Verdict("", "reproduced", reason)
    if by_word.keys() & {"not computed", "missing"}:
        return Verdict("", "not computed", reason)
    return Verdict("", "not decidable", reason)
