"""Instruments' files that a study names: found, hashed and tried out before any job starts."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

PLACES = {"surface": "surfaces", "line": "surfaces", "body.shape": "shapes"}


class MeasuredFile(NamedTuple):
    """Where a file lies, and the hash of what it holds."""

    path: Path
    digest: str


def blocks_with_files(scene: Mapping[str, Any]) -> Iterator[tuple[str, str, Mapping[str, Any]]]:
    """Blocks of a canonical scene that name an instrument's file: place, folder of config/ where it may lie, block."""
    for place, folder in PLACES.items():
        block: Any = scene
        for key in place.split("."):
            block = (block or {}).get(key)
        if block and "file" in block:
            yield place, folder, block


def find(written: str, folders: Sequence[Path]) -> MeasuredFile:
    """The file that a study names: from the first of some folders that has it.

    Raises
    ------
    ValueError
        If none has it, or it cannot be opened.
    """
    for folder in folders:
        path = folder / Path(written).expanduser()
        if path.is_file():
            try:
                return MeasuredFile(path.resolve(), hashlib.sha256(path.read_bytes()).hexdigest())
            except OSError as error:
                raise ValueError(f"cannot be opened: {error.strerror}") from None
    looked = " or ".join(str(folder) for folder in folders)
    raise ValueError(f"no such file in {looked}")


def try_out(surface: Mapping[str, Any], file: MeasuredFile) -> None:
    """Read a measured surface, line or contact edge and prepare it as the study says.

    Parameters
    ----------
    surface : mapping
        Canonical block of the kind ``measured``, ``measured_line`` or ``profile``.
    file : MeasuredFile

    Raises
    ------
    ValueError
        With what the reader said.
    """
    options = {key: value for key, value in surface.items() if key not in ("kind", "file")}
    complaint = _complaint(surface["kind"], file, json.dumps(options, sort_keys=True))
    if complaint:
        raise ValueError(complaint)


@lru_cache(maxsize=64)
def _complaint(kind: str, file: MeasuredFile, options: str) -> str:
    """What is wrong with a file; empty where it can be used. A run reads its studies twice, the file once."""
    # The readers take a second or two to load, and most studies name no file.
    settings = {"file": str(file.path), **json.loads(options)}
    if kind == "profile":
        return _edge_complaint(settings)
    from softlub.surfaces.measurement import Measured, MeasuredLine
    from softlub.surfaces.preparation import prepare, prepare_line

    try:
        if kind == "measured":
            prepare(Measured(**settings))
        else:
            prepare_line(MeasuredLine(**settings))
    except (ValueError, OSError) as error:
        return str(error)
    return ""


def _edge_complaint(settings: Mapping[str, Any]) -> str:
    from softlub.solid.shapes.profile_file import ProfileFile

    try:
        # Reading is checking.
        _ = ProfileFile(**settings).edge
    except (ValueError, OSError) as error:
        return str(error)
    return ""
