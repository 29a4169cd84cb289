"""Swept and sampled fields of the scene: every entry is put into the scene and read with it."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from typing import Any

from pydantic import ValidationError
from pydantic_core import PydanticCustomError

from softlub.study import paths
from softlub.study.blocks import Names
from softlub.study.fields import Quantity, refusal
from softlub.study.grid import LOAD, SWEPT
from softlub.study.labels import labels
from softlub.study.messages import shown
from softlub.study.parsed import Range, Sweep
from softlub.study.ranges import ascending, range_bounds, read_entry, read_range
from softlub.study.scene import Scene

MOST_CORNERS = 4096
"""Combinations of extreme values that are checked together."""


class SceneReader:
    """Reads the scene of a file with some of its fields replaced.

    Parameters
    ----------
    scene : Any
        Raw scene, its names resolved.
    names : Names
        Resolver for names among the replacements.
    model : type
        Model of the scene.
    """

    def __init__(self, scene: Any, names: Names, model: Any = Scene) -> None:
        self.scene = scene
        self.names = names
        self.model = model

    def raw(self, values: Mapping[str, Any]) -> Any:
        """The raw scene with values put at their paths; a refusal where that cannot be."""
        scene = self.scene
        for path, value in values.items():
            try:
                scene = paths.replaced(scene, path, value)
            except KeyError:
                raise refusal(f"{path.rpartition('.')[0]} has no fields that could be swept") from None
        scene, problems = self.names.resolved(scene)
        if problems:
            raise refusal("; ".join(problem.text for problem in problems))
        return scene

    def canonical(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The canonical scene with values put at their paths; a refusal where it is none."""
        try:
            canonical: dict[str, Any] = self.model.model_validate(self.raw(values)).canonical()
            return canonical
        except ValidationError as error:
            raise refusal(
                "; ".join(_told(entry, values) for entry in error.errors(include_url=False))
            ) from None

    def number(self, path: str, value: Any, others: Mapping[str, Any]) -> float:
        """A number of the scene [SI] as it is read at its place."""
        read = paths.get(self.canonical({**others, path: value}), path)
        if isinstance(read, bool) or not isinstance(read, (int, float)):
            raise refusal("is no number; ranges are for numbers")
        return float(read)


def _told(entry: Any, values: Mapping[str, Any]) -> str:
    place = ".".join(str(part) for part in entry["loc"])
    return str(entry["msg"]) if place in values else f"{place}: {entry['msg']}".removeprefix(": ")


def check_path(key: str, others: Iterable[str]) -> None:
    """Refuse a key that lies inside another, or whose dimension would be another's."""
    for other in others:
        if key.startswith(f"{other}."):
            raise refusal(f"cannot be swept together with {other}, which it lies inside of")
        if key.rpartition(".")[2] == other.rpartition(".")[2]:
            raise refusal(f"has the same last part as {other}; both would be one dimension of the dataset")


def read_sweep(key: str, raw: Any, others: Mapping[str, Any], reader: SceneReader) -> Sweep:
    """One swept field.

    Parameters
    ----------
    key : str
        ``scene.…`` as in the file.
    raw : Any
        List of entries, or a range.
    others : mapping
        Path -> a value for each other swept field, since they may stand in the grid alone.
    reader : SceneReader

    Returns
    -------
    Sweep
    """
    path = key.removeprefix(SWEPT)
    if isinstance(raw, Mapping):
        numbers = read_range(raw, lambda value: reader.number(path, value, others))
        return Sweep(path, numbers, numbers)
    if not isinstance(raw, list):
        raise refusal("needs a list of values, or a range {from, to, points, spacing}")
    own = [entry.get("label") if isinstance(entry, Mapping) else None for entry in raw]
    if not all(label is None or isinstance(label, str) for label in own):
        raise refusal("has a label that is no text")
    bare = [_without_label(entry) for entry in raw]
    values = [
        read_entry(lambda value: paths.get(reader.canonical({**others, path: value}), path), entry, i)
        for i, entry in enumerate(bare)
    ]
    if all(isinstance(value, (int, float)) for value in values):
        numbers = ascending([float(value) for value in values])
        return Sweep(path, numbers, numbers)
    return Sweep(path, tuple(values), _distinct(_words(bare, values, own)))


def _words(entries: list[Any], values: list[Any], own: list[str | None]) -> list[str]:
    if not all(isinstance(value, Mapping) for value in values):
        return [str(value) for value in values]
    heads = [
        entry if isinstance(entry, str) else str(value.get("name") or value.get("kind") or "entry")
        for entry, value in zip(entries, values, strict=True)
    ]
    return labels(heads, values, own)


def _distinct(words: list[str]) -> tuple[str, ...]:
    for index, word in enumerate(words):
        if word in words[:index]:
            raise refusal(f"has {word} twice; drop one, or give each a label")
    return tuple(words)


def _without_label(entry: Any) -> Any:
    if isinstance(entry, Mapping) and "label" in entry:
        return {key: value for key, value in entry.items() if key != "label"}
    return entry


def read_sampled(key: str, raw: Any, others: Mapping[str, Any], reader: SceneReader) -> tuple[str, Range]:
    """Path and range of one sampled field, or of the load."""
    if not isinstance(raw, Mapping):
        raise refusal(f"{shown(raw)} is no range; a range has from, to, spacing")
    keys = ("from", "to", "spacing")
    if key == "load":
        return key, Range(*range_bounds(raw, Quantity(LOAD).read, keys))
    path = key.removeprefix(SWEPT)
    return path, Range(*range_bounds(raw, lambda value: reader.number(path, value, others), keys))


def check_together(extremes: Mapping[str, tuple[Any, ...]], reader: SceneReader) -> None:
    """Read the scene at the corners of everything varied: parameters that only clash together clash there.

    Parameters
    ----------
    extremes : mapping
        Path -> first and last number, or all blocks, as canonical values.
    reader : SceneReader
    """
    for corner in itertools.islice(itertools.product(*extremes.values()), MOST_CORNERS):
        try:
            reader.canonical(dict(zip(extremes, corner, strict=True)))
        except PydanticCustomError as error:
            shown_values = ", ".join(
                f"{SWEPT}{path} = {shown(value) or 'a block'}"
                for path, value in zip(extremes, corner, strict=True)
            )
            raise refusal(f"{shown_values} do not go together: {error.message()}") from None
