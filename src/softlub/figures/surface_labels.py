"""Names of rough surfaces in legends: by whatever tells them apart."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from softlub.figures.quantities import quantity

Inputs = dict[str, float]


class _Mark(NamedTuple):
    value: Callable[[Inputs], float]
    text: Callable[[float], str]


def _wavelength(value: float) -> str:
    axis = quantity("wavelength", value, unit="m")
    return rf"$\lambda_\mathrm{{s}}$ = {axis.shown(value):.3g} {axis.shown_unit}"


MARKS: tuple[_Mark, ...] = (
    _Mark(lambda known: known["hurst"], lambda value: f"H = {value:.3g}"),
    _Mark(lambda known: 2 * np.pi / known["cutoff"], _wavelength),
    _Mark(
        lambda known: known["rolloff"] / known["long_cutoff"],
        lambda value: rf"$\lambda_\mathrm{{L}}/\lambda_\mathrm{{r}}$ = {value:.3g}",
    ),
    _Mark(
        lambda known: known["size"] * known["long_cutoff"] / (2 * np.pi),
        lambda value: rf"$L/\lambda_\mathrm{{L}}$ = {value:.3g}",
    ),
    _Mark(lambda known: known["points"], lambda value: f"N = {value:.0f}"),
)
"""From what matters most to what matters least: Hurst exponent, both ends of the spectrum, size, grid."""


def surface_labels(everyone: Sequence[Inputs]) -> list[str]:
    """A name for each of some surfaces, of as few inputs as tell them apart.

    Parameters
    ----------
    everyone : sequence of dict
        Inputs of each surface, see `softlub.datasets.contact_curves.inputs`.

    Returns
    -------
    list of str
        Empty for a single surface.
    """
    if len(everyone) < 2:
        return ["" for _ in everyone]
    parts: list[list[str]] = [[] for _ in everyone]
    for mark in MARKS:
        try:
            texts = [mark.text(mark.value(known)) for known in everyone]
        except KeyError:
            continue
        told_apart = len({tuple(part) for part in parts})
        longer = [(*part, text) for part, text in zip(parts, texts, strict=True)]
        if len(set(longer)) > told_apart:
            parts = [list(part) for part in longer]
    if len({tuple(part) for part in parts}) < len(parts):
        return [", ".join([*part, f"no. {number}"]) for number, part in enumerate(parts, 1)]
    return [", ".join(part) for part in parts]
