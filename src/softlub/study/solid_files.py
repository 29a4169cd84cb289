"""CSV files that a scene names, read where the study is read: their numbers take the file's place in the scene.

So what is in a file is part of the key of whatever is made of it, and a wrong file is refused before any job starts.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from softlub.study.kinds import RATE_INDEPENDENT
from softlub.study.messages import Problem, shown
from softlub.study.parts import model_of
from softlub.study.paths import get

FIT_DIGITS = 6
"""Digits kept of a fitted series, whose last ones are another machine's."""

Block = dict[str, Any]


def expanded(scene: Any, folders: Mapping[str, Sequence[Path]]) -> tuple[Any, list[Problem]]:
    """A copy of a raw scene with the numbers of every CSV file in place of its name.

    Parameters
    ----------
    scene : Any
        As it stands in the file, names of blocks resolved.
    folders : mapping
        Folder of the named blocks -> where files are looked for.

    Returns
    -------
    scene : Any
    problems : list of Problem
        One for each file that cannot be used; its block is left as it is.
    """
    scene = copy.deepcopy(scene)
    problems: list[Problem] = []
    for place, folder, key, read in PLACES:
        block = _at(scene, place)
        if key not in block:
            continue
        others = {name: value for name, value in block.items() if name != key}
        try:
            numbers = read(_found(block[key], folders[folder]), _at(scene, place.rpartition(".")[0]))
            if twice := [name for name in numbers if name in others]:
                raise ValueError(f"stands beside {', '.join(twice)}, which the file holds; keep one of them")
        except (ValueError, OSError) as error:
            problems.append(Problem(f"scene.{place}.{key}", str(error), shown(block[key])))
            continue
        block.pop(key)
        block.update(numbers)
    return scene, problems


def _at(scene: Any, place: str) -> Block:
    try:
        block = get(scene, place)
    except (KeyError, TypeError):
        return {}
    return block if isinstance(block, dict) else {}


def _found(written: Any, folders: Sequence[Path]) -> Path:
    if not isinstance(written, str) or not written:
        raise ValueError("must be the name of a CSV file")
    for folder in folders:
        path = folder / Path(written).expanduser()
        if path.is_file():
            return path
    raise ValueError(f"no such file in {' or '.join(str(folder) for folder in folders)}")


def _prony(path: Path, material: Block) -> Block:
    from softlub.solid.materials.prony_file import read_prony

    series = read_prony(path)
    return {"times": list(series.times), "terms": list(series.terms), "normalised": series.normalised}


def _dmta(path: Path, material: Block) -> Block:
    """The series that fits measured moduli best, with the volume as stiff as that of the material at rest."""
    from softlub.solid.materials.dmta import fit_prony, read_dmta

    series = fit_prony(read_dmta(path), _bulk_modulus(material)).series
    return {
        "times": [float(f"{time:.{FIT_DIGITS}g}") for time in series.times],
        "terms": [float(f"{term:.{FIT_DIGITS}g}") for term in series.terms],
        "normalised": series.normalised,
    }


def _bulk_modulus(material: Block) -> float:
    """K of a raw material at rest [Pa]; infinite where it is none, which is refused when the scene is checked."""
    rest: Any = material.get("hyperelastic")
    try:
        made = model_of(RATE_INDEPENDENT[rest["kind"]], "kind", rest["kind"]).model_validate(rest).build()
    except (KeyError, TypeError, ValueError):
        return math.inf
    return float(made.bulk_modulus)


PLACES: tuple[tuple[str, str, str, Callable[[Path, Block], Block]], ...] = (
    ("body.material.prony", "materials", "file", _prony),
    ("body.material.prony", "materials", "dmta", _dmta),
)
"""Block that may name a file, folder of config/ where the file may lie, key that names it, and what reads it."""
