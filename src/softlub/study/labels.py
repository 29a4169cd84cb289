"""Labels of swept blocks: their name, and the options in which those of one name differ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any


def labels(heads: Sequence[str], blocks: Sequence[Mapping[str, Any]], own: Sequence[str | None]) -> list[str]:
    """One label an entry.

    Parameters
    ----------
    heads : sequence of str
        Name of each entry.
    blocks : sequence of mapping
        Options of each entry.
    own : sequence of str or None
        Label that the study file gives, which goes before.

    Returns
    -------
    list of str
        ``"exponential"``, ``"persson gamma=1"``, ``"persson gamma=0.45"``.
    """
    return [given or _label(index, heads, blocks) for index, given in enumerate(own)]


def _label(index: int, heads: Sequence[str], blocks: Sequence[Mapping[str, Any]]) -> str:
    fellows = [block for head, block in zip(heads, blocks, strict=True) if head == heads[index]]
    block = blocks[index]
    differing = [
        key for key, value in block.items() if any(fellow.get(key, value) != value for fellow in fellows)
    ]
    return " ".join([heads[index], *(f"{key}={_text(block[key])}" for key in differing)])


def _text(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
