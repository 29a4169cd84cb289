"""Which study files a run reads: those that are named, from the configuration or from anywhere."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from softlub.study.accuracy import ACCURACIES
from softlub.study.messages import Problem, StudyError, did_you_mean, shown

CONFIG_KEYS = ("studies", "accuracy", "study")


def study_files(config_dir: str | os.PathLike[str]) -> dict[str, Path]:
    """Every study of the configuration by its name.

    Parameters
    ----------
    config_dir : path-like

    Returns
    -------
    dict of str to Path

    Raises
    ------
    StudyError
        If two files have one stem.
    """
    found: dict[str, Path] = {}
    folder = Path(config_dir) / "studies"
    for file in sorted(file for suffix in ("yaml", "yml") for file in folder.glob(f"*.{suffix}")):
        if file.stem in found:
            raise StudyError(
                str(file),
                [Problem("", f"has the name of another study, {found[file.stem]}; rename one of them")],
            )
        found[file.stem] = file
    return found


def select(config: Mapping[str, Any], config_dir: str | os.PathLike[str]) -> list[Path]:
    """The study files that a run is asked for.

    Parameters
    ----------
    config : mapping
        ``studies``: names of files in config/studies; ``study``: the path of one file from anywhere, which then is
        the only one; ``accuracy``.
    config_dir : path-like

    Returns
    -------
    list of Path

    Raises
    ------
    StudyError
        If a name has no file, a path has another study's name, or a key or value is unknown.
    """
    where = f"{Path(config_dir) / 'config.yaml'} or --config"
    problems = [
        Problem(str(key), f"unknown key; {did_you_mean(str(key), CONFIG_KEYS, 'keys')}")
        for key in config
        if key not in CONFIG_KEYS
    ]
    accuracy = config.get("accuracy", "standard")
    if accuracy not in ACCURACIES:
        problems.append(
            Problem("accuracy", f"is unknown; {did_you_mean(str(accuracy), ACCURACIES)}", shown(accuracy))
        )
    if "study" in config and not str(config["study"] or "").strip():
        problems.append(Problem("study", "names no file; write --config study=PATH"))
    known = study_files(config_dir)
    names = config.get("studies", [])
    if "study" not in config and not (isinstance(names, list) and names):
        problems.append(Problem("studies", "must list the studies to be made, one or more", shown(names)))
    elif "study" not in config:
        problems += [
            Problem(
                "studies",
                f"no such file in {Path(config_dir) / 'studies'}; {did_you_mean(str(name), list(known))}",
                shown(name),
            )
            for name in names
            if name not in known
        ]
    if problems:
        raise StudyError(where, problems)
    if "study" in config:
        return [_from_anywhere(Path(str(config["study"])), known)]
    return [known[name] for name in dict.fromkeys(names)]


def _from_anywhere(path: Path, known: Mapping[str, Path]) -> Path:
    if not path.exists() and str(path) in known:
        return known[str(path)]
    namesake = known.get(path.stem)
    if namesake is not None and path.exists() and not path.samefile(namesake):
        raise StudyError(
            str(path), [Problem("", f"has the name of another study, {namesake}; rename your file")]
        )
    return path
