"""The table of claims, and the table and the page of what became of them."""

from __future__ import annotations

import csv
import io
import os
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from softlub.claims.verdict import WORDS

if TYPE_CHECKING:
    from softlub.claims.evaluate import Judgement


class Claim(NamedTuple):
    """One row of `config/claims.csv`: a figure, table, equation or statement of the source, as a fact."""

    id: str
    chapter: int
    line: int
    kind: str
    what: str
    quantity: str
    value: str
    unit: str
    figures: tuple[str, ...]
    study: str


def read_claims(path: str | os.PathLike[str]) -> list[Claim]:
    """Read the table of claims.

    Parameters
    ----------
    path : path-like
        CSV with the columns id, chapter, line, kind, what, quantity, value, unit, figure, study.

    Returns
    -------
    list of Claim

    Raises
    ------
    ValueError
        If an id stands twice.
    """
    with open(path, newline="", encoding="utf-8") as stream:
        claims = [_claim(row) for row in csv.DictReader(stream)]
    twice = [name for name, count in Counter(claim.id for claim in claims).items() if count > 1]
    if twice:
        raise ValueError(f"{path}: rows {', '.join(twice)} stand twice")
    return claims


def _claim(row: dict[str, str]) -> Claim:
    figures = tuple(name.strip() for name in row["figure"].split(";") if name.strip())
    plain = {name: row[name] for name in ("id", "kind", "what", "quantity", "value", "unit", "study")}
    return Claim(chapter=int(row["chapter"]), line=int(row["line"]), figures=figures, **plain)


def studies_of(figure: str, claims: Iterable[Claim]) -> tuple[str, ...]:
    """Studies whose datasets the caption of a figure reads.

    Parameters
    ----------
    figure : str
    claims : iterable of Claim

    Returns
    -------
    tuple of str
    """
    named = (claim.study.split(";") for claim in claims if figure in claim.figures)
    return tuple(dict.fromkeys(name.strip() for names in named for name in names if name.strip()))


COLUMNS = (
    "id",
    "kind",
    "line",
    "what",
    "quantity",
    "source_value",
    "unit",
    "our_value",
    "verdict",
    "reason",
    "study",
)


def write_judgements(judgements: Sequence[Judgement], path: str | os.PathLike[str]) -> None:
    """Write a row per claim as CSV.

    Parameters
    ----------
    judgements : sequence of Judgement
    path : path-like
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for judgement in judgements:
        claim, ours = judgement.claim, judgement.verdict
        writer.writerow(
            [
                *(claim.id, claim.kind, claim.line, claim.what, claim.quantity, claim.value, claim.unit),
                *(ours.value, ours.verdict, ours.reason, claim.study),
            ]
        )
    write_text(path, text.getvalue())


def write_page(judgements: Sequence[Judgement], path: str | os.PathLike[str]) -> None:
    """Write the page of all claims in Markdown: how many of each verdict, then a table a chapter.

    Parameters
    ----------
    judgements : sequence of Judgement
    path : path-like
    """
    counts = Counter(judgement.verdict.verdict for judgement in judgements)
    lines = [
        "# What the source claims, and what our numbers say",
        "",
        "Made by `snakemake claims` from `config/claims.csv` and the datasets of the studies; do not edit.",
        "A row is *reproduced* when the stated threshold holds for our numbers, *differs* when it does not,",
        "*not decidable* when the source prints too little to decide, *not computed* when there is nothing to",
        "compute or its study has not been run, *missing* when nobody has written a check.",
        "",
        "| verdict | rows |",
        "| --- | --- |",
        *(f"| {word} | {counts[word]} |" for word in WORDS),
    ]
    for chapter in sorted({judgement.claim.chapter for judgement in judgements}):
        lines += [
            "",
            f"## Chapter {chapter}",
            "",
            "| row | line | statement | source | ours | verdict | why |",
        ]
        lines += ["| --- | --- | --- | --- | --- | --- | --- |"]
        lines += [_page_row(item) for item in judgements if item.claim.chapter == chapter]
    write_text(path, "\n".join(lines) + "\n")


def _page_row(judgement: Judgement) -> str:
    claim, ours = judgement.claim, judgement.verdict
    source = f"{claim.value} {claim.unit}".strip() if claim.value else ""
    cells = (claim.id, str(claim.line), claim.what, source, ours.value, f"**{ours.verdict}**", ours.reason)
    return "| " + " | ".join(cell.replace("|", r"\|") for cell in cells) + " |"


def write_text(path: str | os.PathLike[str], text: str) -> None:
    """Write a text file whole or not at all."""
    target = Path(path)
    target.parent.mkdir(parents=True, exist_ok=True)
    partial = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        partial.write_text(text, encoding="utf-8")
        os.replace(partial, target)
    finally:
        partial.unlink(missing_ok=True)
