"""Captions: what a figure shows, what stands in for what, and whether the source's statements hold for our numbers.

reStructuredText, as Snakemake's report reads it. Nothing in a caption is written beforehand but the description of the
drawing: values and verdicts are those of the checks.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import xarray as xr

from softlub.claims.evaluate import Judgement, evaluate
from softlub.claims.table import Claim
from softlub.claims.verdict import Word
from softlub.datasets.state import convergence, failures, flag_meanings, flagged

OF_THE_SOURCE = re.compile(r"ch\d+-")
"""How the name of a study of the source begins."""

HEADINGS: dict[Word, str] = {
    "reproduced": "Reproduced",
    "differs": "Differs",
    "not decidable": "Not decidable",
    "not computed": "Not computed",
    "missing": "No check",
}


def caption(
    figure: str,
    shows: str,
    dataset: xr.Dataset,
    claims: Sequence[Claim] = (),
    open_dataset: Callable[[str], xr.Dataset | None] = lambda study: None,
) -> str:
    """Caption of one figure.

    Parameters
    ----------
    figure : str
        Its name; the claims that name it are judged.
    shows : str
        One sentence on what the drawing shows.
    dataset : xarray.Dataset
        What was drawn.
    claims : sequence of Claim, optional
    open_dataset : callable, optional
        Study's name -> dataset or None; see `table.studies_of`.

    Returns
    -------
    str
        reStructuredText.
    """
    ours = str(dataset.attrs.get("study", ""))
    # A figure of one's own may have the name of one of the source's and yet show something else.
    about = [
        claim
        for claim in claims
        if figure in claim.figures and claim.kind != "figure" and (not ours or OF_THE_SOURCE.match(ours))
    ]
    title = str(dataset.attrs.get("title", "")).rstrip(".")
    parts = [f"**{escape(title)}.** {escape(shows)}" if title else escape(shows)]
    parts += [
        _state(dataset),
        escape(" ".join(part for part in (flagged(dataset), flag_meanings(dataset)) if part)),
        _domain(dataset, bool(about)),
        _stand_ins(dataset, ours),
    ]
    if about:
        parts.append("What the source says of it, and our numbers:")
        parts += [_statement(judgement, ours) for judgement in evaluate(about, open_dataset)]
    return "\n\n".join(part for part in parts if part) + "\n"


def _statement(judgement: Judgement, study: str) -> str:
    """A statement with its verdict, and the studies it was held against where they are not the figure's own."""
    claim, ours = judgement.claim, judgement.verdict
    value = f" {escape(_sentence(ours.value))}" if ours.value else ""
    reason = f" {escape(_sentence(ours.reason))}" if ours.reason else ""
    others = [name.strip() for name in claim.study.split(";") if name.strip() not in ("", study)]
    where = f"; computed from {', '.join(others)}" if others else ""
    return (
        f"- {escape(_sentence(claim.what))} **{HEADINGS[ours.verdict]}.**{value}{reason} "
        f"({escape(claim.id)}, line {claim.line}{escape(where)})"
    )


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:].rstrip(".") + "."


def _state(dataset: xr.Dataset) -> str:
    """How many points got there, and how the others are drawn."""
    if not failures(dataset):
        return escape(convergence(dataset))
    marks = "Crosses mark those that failed"
    gaps = "." if "stop_reason" in dataset else ", and curves have a gap there."
    return escape(f"{convergence(dataset)} {marks}{gaps}")


def _domain(dataset: xr.Dataset, compared: bool) -> str:
    """The domain in force, what it decides, and the source's where the figure is compared with the source."""
    if "half_domain" not in dataset or "hertz_half_width" not in dataset:
        return ""
    reach = dataset["half_domain"].values * 1e3
    widths = (dataset["half_domain"] / dataset["hertz_half_width"]).values
    if not np.isfinite(reach).all():
        return ""
    ours = f"Domain: {_listed(reach, '±')} mm, {_listed(widths)} Hertz half-widths"
    source = " (the source takes ±1 mm)" if compared else ""
    narrow = (
        " It hardly holds the contact: widen it, or lower the load." if np.nanmin(widths) < NARROW else ""
    )
    return escape(
        f"{ours}{source}.{narrow} It is a convention that decides friction and film where the fluid carries all of the "
        "load: for the contact of table 3-1 above some 0.1 m/s."
    )


NARROW = 2.0
"""Domain over the dry contact below which there is hardly an inlet."""
MOST_LISTED = 3


def _listed(values: np.ndarray, sign: str = "") -> str:
    """A few different values one by one, more of them as a range."""
    different = [f"{sign}{text}" for text in dict.fromkeys(f"{value:.3g}" for value in np.unique(values))]
    if len(different) > MOST_LISTED:
        return f"{different[0]} to {different[-1]}"
    return " and ".join(", ".join(different).rsplit(", ", 1))


def _stand_ins(dataset: xr.Dataset, study: str) -> str:
    """What stands in for what: in studies of the source for what it does not print."""
    stored = dataset.attrs.get("stand_ins")
    entries: Any = json.loads(stored) if isinstance(stored, str) and stored else stored
    if not entries:
        return ""
    pairs = entries.items() if isinstance(entries, dict) else [_stand_in(entry) for entry in entries]
    sentences = [(name, str(reason).rstrip(".")) for name, reason in pairs]
    listed = "; ".join(f"{name}: {reason}" if name else reason for name, reason in sentences)
    heading = "Stand-ins for what the source does not print" if OF_THE_SOURCE.match(study) else "Stand-ins"
    return f"{heading}: {escape(listed)}."


def _stand_in(entry: Any) -> tuple[str, str]:
    if not isinstance(entry, dict):
        return "", str(entry)
    name = str(entry.get("key", ""))
    return name, str(entry.get("reason", ""))


def escape(text: str) -> str:
    r"""Text that reStructuredText leaves as it is.

    Parameters
    ----------
    text : str

    Returns
    -------
    str
        With a backslash before every character that begins markup.
    """
    escaped = re.sub(r"([\\*`|])", r"\\\1", text)
    return re.sub(r"_(?=\W|$)", r"\\_", escaped)
