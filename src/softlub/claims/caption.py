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
from softlub.datasets.variables import FLAG_EXPLANATIONS, FLAGS

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
        _state_of_points(dataset),
        _flagged_points(dataset),
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


def _state_of_points(dataset: xr.Dataset) -> str:
    """How many of the points asked for converged, by solver where there are several."""
    if "converged" not in dataset:
        return ""
    if "stop_reason" in dataset:
        return escape(_state_of_bodies(dataset))
    flags = dataset["flags"] if "flags" in dataset else xr.zeros_like(dataset["converged"], dtype=int)
    asked = (flags.astype(int) & FLAGS["not_attempted"]) == 0
    failed = asked & ~dataset["converged"].astype(bool)
    if not bool(failed.any()):
        return f"All {int(asked.sum())} points converged."
    counts = f"{int(failed.sum())} of {int(asked.sum())} points did not converge"
    if "solver" in dataset.dims:
        each = [
            f"{label}: {int(failed.isel(solver=i).sum())} of {int(asked.isel(solver=i).sum())}"
            for i, label in enumerate(dataset["solver"].values)
        ]
        counts += f" ({'; '.join(each)})"
    return escape(f"{counts}; crosses mark them, and curves have a gap there.")


def _state_of_bodies(dataset: xr.Dataset) -> str:
    """How many finite-element bodies were taken through all of their steps, and which increments were given up."""
    done = dataset["converged"].astype(bool)
    count, failed = done.size, int((~done).sum())
    cut = int(dataset["rejected_increments"].sum()) if "rejected_increments" in dataset else 0
    tried = f" {cut} increments that did not converge were tried again in smaller ones." if cut else ""
    tried += _too_wide(dataset)
    if not failed:
        who = "The body" if count == 1 else f"All {count} bodies"
        return f"{who} got to the end of {'its' if count == 1 else 'their'} steps.{tried}"
    reasons = sorted(
        {str(reason).rstrip(".") for reason in dataset["stop_reason"].values.ravel() if str(reason)}
    )
    whose = "its" if failed == 1 else "their"
    return (
        f"{failed} of {count} bodies did not get to the end of {whose} steps ({'; '.join(reasons)}); crosses mark "
        f"them.{tried}"
    )


def _too_wide(dataset: xr.Dataset) -> str:
    """In how many bodies the contact goes beyond the nodes that can touch."""
    beyond = int((dataset["reaches_edge_end"] == 1).sum()) if "reaches_edge_end" in dataset else 0
    if not beyond:
        return ""
    return (
        f" In {beyond} of {dataset['converged'].size} bodies the contact reaches an end of the contact edge, beyond "
        "which nothing can touch the plate: pressures and displacements there are wrong; widen the contact edge."
    )


def _flagged_points(dataset: xr.Dataset) -> str:
    """How many of the converged points carry which flag, at which speeds, and what that means."""
    if "flags" not in dataset or "converged" not in dataset:
        return ""
    converged = dataset["converged"].astype(bool)
    # Converged points carry neither not_converged nor not_attempted.
    flags = dataset["flags"].astype(int).where(converged, 0).astype(int)
    each = {name: (flags & bit) > 0 for name, bit in FLAGS.items()}
    raised = {name: where for name, where in each.items() if bool(where.any())}
    if not raised:
        return ""
    counts = ", ".join(f"{name} {int(where.sum())}{_speeds(where)}" for name, where in raised.items())
    meanings = " ".join(f"{name}: {FLAG_EXPLANATIONS[name]}." for name in raised)
    return escape(
        f"{int((flags > 0).sum())} of {int(converged.sum())} converged points are flagged: {counts}. {meanings}"
    )


def _speeds(where: xr.DataArray) -> str:
    """At which speeds any point is marked."""
    if "speed" not in where.dims:
        return ""
    speed = where["speed"].values[where.any([name for name in where.dims if name != "speed"]).values]
    # Through a float, since 100 reads better than 1e+02.
    low, high = (f"{float(f'{value:.2g}'):g}" for value in (speed.min(), speed.max()))
    return f" (v = {low} m/s)" if low == high else f" (v from {low} to {high} m/s)"


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
