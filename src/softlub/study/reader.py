"""From a study file to a checked study."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from pydantic import ValidationError
from pydantic_core import PydanticCustomError

from softlub.study import parts, paths
from softlub.study.accuracy import ACCURACIES
from softlub.study.assembly import AnyFile, assembled
from softlub.study.blocks import Names
from softlub.study.checks import problems_of
from softlub.study.combinations import scenes_of
from softlub.study.decimal_commas import joined_again
from softlub.study.fields import refusal
from softlub.study.figure_checks import unmet_needs_of_file
from softlub.study.files import read_block
from softlub.study.grid import SWEPT, check_swept_key
from softlub.study.measured_files import MeasuredFile, blocks_with_files, find, try_out
from softlub.study.messages import Problem, StudyError, did_you_mean, shown
from softlub.study.models import FILES, KINDS, SCENES, CommonFile
from softlub.study.parsed import Study, Sweep
from softlub.study.size_checks import size_problems
from softlub.study.solvers import as_block
from softlub.study.sweeps import SceneReader, check_path, check_together, read_sampled, read_sweep

STUDY_NAME = re.compile(r"[A-Za-z0-9_-]+")

Raw = dict[str, Any]


def load(
    path: str | os.PathLike[str],
    accuracy: str | None = None,
    overrule: bool = False,
    config_dir: str | os.PathLike[str] | None = None,
) -> Study:
    """Read and check a study file.

    Parameters
    ----------
    path : path-like
        The study file; its stem is the study's name.
    accuracy : {"draft", "standard", "source"}, optional
        Accuracy where the file names none; standard by default.
    overrule : bool
        Whether `accuracy` goes before the file's own.
    config_dir : path-like, optional
        Folder with the named blocks. By default the one above `studies`, where the file lies in such a folder, else
        ``config``.

    Returns
    -------
    Study

    Raises
    ------
    StudyError
        With everything that is wrong in the file.
    """
    path = Path(path)
    if not STUDY_NAME.fullmatch(path.stem):
        raise StudyError(str(path), [Problem("", "rename the file: letters, digits, - and _ only")])
    if accuracy is not None and accuracy not in ACCURACIES:
        problem = Problem("accuracy", f"is unknown; {did_you_mean(accuracy, ACCURACIES)}", shown(accuracy))
        raise StudyError(str(path), [problem])
    reading = _Reading(path, read_block(path), Names(_config_dir(path, config_dir), path.parent))
    study = reading.study(accuracy, overrule)
    if reading.problems:
        raise StudyError(str(path), reading.problems)
    assert study is not None
    return study


def _config_dir(path: Path, given: str | os.PathLike[str] | None) -> Path:
    if given is not None:
        return Path(given)
    return path.parent.parent if path.resolve().parent.name == "studies" else Path("config")


class _Reading:
    """One file being read: what it holds, and what was found wrong so far."""

    def __init__(self, path: Path, raw: Raw, names: Names) -> None:
        self.path = path
        self.names = names
        self.raw, self.problems = joined_again(raw)
        raw = self.raw
        kind = raw.get("kind")
        # An unknown kind is refused where the file is read as a study of the first one.
        self.kind = kind if isinstance(kind, str) and kind in KINDS else KINDS[0]
        grid = raw.get("grid")
        self.grid: Raw = grid if isinstance(grid, dict) else {}
        self.swept = {key: entry for key, entry in self.grid.items() if str(key).startswith(SWEPT)}
        sample = self.grid.get("sample")
        ranges = sample.get("ranges") if isinstance(sample, dict) else None
        self.sampled: Raw = ranges if isinstance(ranges, dict) else {}
        self._drop_unsweepable()

    def _drop_unsweepable(self) -> None:
        """Refuse keys that cannot be swept whatever they hold; the rest is read without them."""
        for place, entries in (("grid", self.swept), ("grid.sample.ranges", self.sampled)):
            for key in list(entries):
                try:
                    check_swept_key(str(key))
                    check_path(
                        str(key), [other for other in (*self.swept, *self.sampled) if other is not key]
                    )
                    if isinstance(entries[key], list) and not entries[key]:
                        raise refusal("is empty; a swept field needs one value at least")
                except PydanticCustomError as error:
                    self._refuse(f"{place}.{key}", error.message(), None)
                    del entries[key]

    def study(self, accuracy: str | None, overrule: bool) -> Study | None:
        """The study, or None where its parts are wrong by themselves."""
        study = self._of_parts(accuracy, overrule)
        if study is not None:
            self.problems += size_problems(study)
        if study is not None and not self.problems:
            study = self._with_files(study)
        if self.problems or study is None:
            self.problems += unmet_needs_of_file(self.raw, KINDS)
        else:
            self.problems += problems_of(study)
        return study

    def _of_parts(self, accuracy: str | None, overrule: bool) -> Study | None:
        reader = self._scene_reader()
        file = self._file(reader)
        sweeps, ranges = self._varied(reader)
        self._check_stand_ins()
        if self.problems or file is None:
            return None
        chosen = accuracy if overrule and accuracy else file.accuracy or accuracy or "standard"
        return assembled(self.path.stem, file, sweeps, ranges, chosen, self.names)

    def _with_files(self, study: Study) -> Study:
        """The study with the instruments' files that it names, each found, hashed and tried out."""
        files: dict[str, MeasuredFile] = {}
        for scene in scenes_of(study):
            for place, folder, block in blocks_with_files(scene):
                written = block["file"]
                try:
                    files[written] = find(written, [self.path.parent, self.names.folder / folder])
                    try_out(block, files[written])
                except ValueError as error:
                    self._refuse(f"scene.{place}.file", str(error), written)
        return replace(study, files=files)

    def _scene_reader(self) -> SceneReader:
        """Reader of the file's scene, in which every swept field holds its first value."""
        scene, unknown = self.names.resolved(self.raw.get("scene"))
        self.problems += unknown
        for key, first in self._first_values().items():
            try:
                scene = paths.replaced(scene if scene is not None else {}, key.removeprefix(SWEPT), first)
            except KeyError:
                # What lies inside a block that was refused cannot be told right or wrong.
                if not any(str(key).startswith(f"{problem.key}.") for problem in unknown):
                    self._refuse(f"grid.{key}", "leads through something that has no fields", None)
                self.swept.pop(key, None)
                self.sampled.pop(key, None)
        scene, problems = self.names.resolved(scene)
        for problem in problems:
            if problem not in unknown:
                self.problems.append(replace(problem, key=f"grid.{problem.key}"))
        return SceneReader(scene, self.names, SCENES[self.kind])

    def _first_values(self) -> Raw:
        firsts: Raw = {}
        for key, entry in [*self.swept.items(), *self.sampled.items()]:
            if str(key).startswith(SWEPT):
                first = entry[0] if isinstance(entry, list) and entry else entry
                if isinstance(first, Mapping):
                    plain = {name: value for name, value in first.items() if name != "label"}
                    first = plain.get("from", plain)
                firsts[key] = first
        return firsts

    def _file(self, reader: SceneReader) -> AnyFile | None:
        grid: Any = self.raw.get("grid")
        if isinstance(grid, dict):
            grid = {key: entry for key, entry in grid.items() if not str(key).startswith(SWEPT)}
            if isinstance(grid.get("solver"), list):
                grid["solver"] = [as_block(entry) for entry in grid["solver"]]
        block = {**self.raw, **({"scene": reader.scene} if reader.scene is not None else {})}
        block |= {"grid": grid} if "grid" in self.raw else {}
        block |= {"solver": as_block(self.raw["solver"])} if "solver" in self.raw else {}
        try:
            file: AnyFile = FILES[self.kind].model_validate(_with_text_keys(block))
            return file
        except ValidationError as error:
            known = {problem.key for problem in self.problems}
            for entry in error.errors(include_url=False):
                problem = self._problem(entry)
                if problem.key not in known and not self._follows(problem):
                    self.problems.append(problem)
        return None

    def _follows(self, problem: Problem) -> bool:
        """Whether a key is missing only because the file that holds its number could not be used."""
        block = problem.key.rpartition(".")[0]
        unread = [f"{block}.{word}" for words in parts.FILES.values() for word in words]
        return problem.text.startswith("is missing") and any(known.key in unread for known in self.problems)

    def _problem(self, entry: Any) -> Problem:
        key = _dotted(entry["loc"])
        # Of what joins several keys of the file itself, no model around it has said the words without pydantic's.
        text = str(entry["ctx"]["error"] if entry["type"] == "value_error" else entry["msg"])
        for place, file in self.names.used.items():
            if key.startswith(f"{SWEPT}{place}.") and key not in (*self.swept, *self.sampled):
                text += f" (in {file})"
        if any(key == swept or key.startswith(f"{swept}.") for swept in [*self.swept, *self.sampled]):
            key = f"grid.{key}"
        # Where a key is missing or a rule joins several, the input is the whole block, which would say nothing.
        whole = text.startswith("is missing") or isinstance(entry["input"], CommonFile)
        return Problem(key, text, "" if whole else shown(entry["input"]))

    def _varied(self, reader: SceneReader) -> tuple[list[Sweep], Raw]:
        """Swept fields, and ranges of sampled ones; nothing where the scene itself is wrong."""
        try:
            reader.model.model_validate(reader.scene)
        except ValidationError:
            return [], {}
        firsts = {key.removeprefix(SWEPT): value for key, value in self._first_values().items()}
        sweeps: list[Sweep] = []
        ranges: Raw = {}
        for key, entry in self.swept.items():
            try:
                sweeps.append(read_sweep(key, entry, _without(firsts, key), reader))
            except PydanticCustomError as error:
                self._refuse(f"grid.{key}", error.message(), entry)
        for key, entry in self.sampled.items():
            if key != "load" and not str(key).startswith(SWEPT):
                continue
            try:
                path, bounds = read_sampled(key, entry, _without(firsts, key), reader)
                ranges[path] = bounds
            except PydanticCustomError as error:
                self._refuse(f"grid.sample.ranges.{key}", error.message(), None)
        if not self.problems:
            self._check_corners(sweeps, ranges, reader)
        return sorted(sweeps, key=lambda sweep: sweep.path), ranges

    def _check_corners(self, sweeps: list[Sweep], ranges: Raw, reader: SceneReader) -> None:
        extremes: dict[str, tuple[Any, ...]] = {
            sweep.path: (sweep.values[0], sweep.values[-1])
            if isinstance(sweep.values[0], float)
            else sweep.values
            for sweep in sweeps
        }
        extremes |= {path: (bounds.low, bounds.high) for path, bounds in ranges.items() if path != "load"}
        try:
            check_together(extremes, reader)
        except PydanticCustomError as error:
            self._refuse("grid", error.message(), None)

    def _check_stand_ins(self) -> None:
        entries = self.raw.get("stand_ins")
        for entry in entries if isinstance(entries, list) else []:
            key = entry.get("key") if isinstance(entry, dict) else None
            if isinstance(key, str) and not _stands_in(self.raw, key):
                self._refuse(
                    "stand_ins", "is no key of this file; write it as it stands, such as scene.lubricant", key
                )

    def _refuse(self, key: str, text: str, value: Any) -> None:
        self.problems.append(Problem(key, text, "" if value is None else shown(value)))


def _without(values: Raw, key: str) -> Raw:
    return {path: value for path, value in values.items() if path != key.removeprefix(SWEPT)}


def _with_text_keys(block: Any) -> Any:
    """Keys as text: YAML also makes numbers of them, and pydantic wants to name them."""
    if isinstance(block, dict):
        return {str(key): _with_text_keys(value) for key, value in block.items()}
    return [_with_text_keys(entry) for entry in block] if isinstance(block, list) else block


def _dotted(location: tuple[int | str, ...]) -> str:
    text = "".join(f"[{part + 1}]" if isinstance(part, int) else f".{part}" for part in location)
    return text.removeprefix(".")


def _stands_in(block: Any, key: str) -> bool:
    """Whether a dotted key leads somewhere in a block whose own keys may hold dots."""
    if isinstance(block, dict):
        return any(
            key == str(own) or (key.startswith(f"{own}.") and _stands_in(value, key[len(str(own)) + 1 :]))
            for own, value in block.items()
        )
    return False
