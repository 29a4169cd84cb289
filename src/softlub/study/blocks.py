"""Names in a scene: a word that stands for a block of config/{shapes,materials,surfaces,lubricants}."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from dataclasses import MISSING, dataclass, field, fields
from pathlib import Path
from typing import Any

from softlub.study import kinds, parts
from softlub.study.files import read_block
from softlub.study.messages import Problem, StudyError, did_you_mean
from softlub.study.solid_files import expanded

PLACES: dict[str, tuple[str, dict[str, type], dict[str, str]]] = {
    "body.shape": ("shapes", {**kinds.SHAPES, **kinds.MESHED_SHAPES}, parts.UNBUILT_SHAPES),
    "body.material": ("materials", kinds.MATERIALS, {}),
    # After the material, which may be the block that holds it.
    "body.material.hyperelastic": ("materials", kinds.RATE_INDEPENDENT, {}),
    "surface": ("surfaces", parts.SURFACES, {}),
    "line": ("surfaces", parts.LINES, {}),
    "lubricant": ("lubricants", {}, {}),
}
"""Where a name may stand: folder of the blocks, kinds that need no block, kinds that are not built."""

NOTES = ("about", "stand_in")
"""Keys of a block that describe it and are no parameters."""


@dataclass
class Names:
    """Resolver of the names in a scene.

    Parameters
    ----------
    folder : Path
        The configuration's folder.
    study_folder : Path, optional
        Where the study file lies, whose CSV files go before those of the configuration.

    Attributes
    ----------
    used : dict of str to Path
        Place in the scene -> file of the block that was put there.
    stand_ins : dict of str to str
        Place in the scene -> why its block stands in for something unknown.
    """

    folder: Path
    study_folder: Path = Path()
    used: dict[str, Path] = field(default_factory=dict)
    stand_ins: dict[str, str] = field(default_factory=dict)

    def resolved(self, scene: Any) -> tuple[Any, list[Problem]]:
        """A copy of a raw scene with every name replaced by its block and every CSV file by its numbers.

        Parameters
        ----------
        scene : Any
            As it stands in the file, whatever that is.

        Returns
        -------
        scene : Any
            A name that has no block and a file that cannot be used are left as they are.
        problems : list of Problem
            One for each such name.
        """
        scene = copy.deepcopy(scene)
        problems: list[Problem] = []
        for place, holder, key in _places(scene):
            if isinstance(holder[key], str):
                try:
                    holder[key] = self.block(place, holder[key])
                except StudyError as error:
                    problems += error.problems
        if isinstance(scene, dict) and isinstance(scene.get("contact_law"), str):
            scene["contact_law"] = {"name": scene["contact_law"]}
        folders = {folder: (self.study_folder, self.folder / folder) for folder, _, _ in PLACES.values()}
        scene, unread = expanded(scene, folders)
        return scene, [*problems, *unread]

    def block(self, place: str, name: str) -> dict[str, Any]:
        """The block that a name stands for at a place of the scene."""
        folder, kinds, unbuilt = PLACES[place]
        files = {file.stem: file for file in sorted((self.folder / folder).glob("*.yaml"))}
        if name in files:
            block = read_block(files[name])
            self.used[place] = files[name]
            if "stand_in" in block:
                self.stand_ins[place] = str(block["stand_in"])
            return {key: value for key, value in block.items() if key not in NOTES}
        if name in kinds and not _required(kinds[name]):
            return {"kind": name}
        if name in unbuilt:
            raise _refused(place, name, f"is not yet built ({unbuilt[name]})")
        if name in kinds:
            needed = ", ".join(f"{key}: …" for key in _required(kinds[name]))
            raise _refused(place, name, f"needs its parameters: {{kind: {name}, {needed}}}")
        bare = [kind for kind, part in kinds.items() if not _required(part)]
        known = [*files, *bare]
        raise _refused(
            place, name, f"no block of this name in {self.folder / folder}; {did_you_mean(name, known)}"
        )


def _places(scene: Any) -> Iterator[tuple[str, dict[str, Any], str]]:
    for place in PLACES:
        *parents, key = place.split(".")
        holder = scene
        for parent in parents:
            holder = holder.get(parent) if isinstance(holder, dict) else None
        if isinstance(holder, dict) and key in holder:
            yield place, holder, key


def _required(part: type) -> list[str]:
    return [entry.name for entry in fields(part) if entry.default is MISSING]


def _refused(place: str, name: str, text: str) -> StudyError:
    return StudyError("", [Problem(f"scene.{place}", text, f'"{name}"')])
