"""A study as it is planned: read, checked, in SI."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from softlub.study.figures import Figure
from softlub.study.measured_files import MeasuredFile


@dataclass(frozen=True)
class Sweep:
    """A swept field of the scene.

    Parameters
    ----------
    path : str
        Keys from the scene down, joined by dots.
    values : tuple
        Numbers in SI, words, or canonical blocks.
    labels : tuple
        Coordinate of the dataset: the numbers themselves, else words.
    """

    path: str
    values: tuple[Any, ...] = field(hash=False)
    labels: tuple[Any, ...]

    @property
    def dimension(self) -> str:
        """Name of the dataset's dimension: the last part of the path."""
        return self.path.rpartition(".")[2]


@dataclass(frozen=True)
class Range:
    """Ends of a sampled field [SI], drawn evenly in the value or in its logarithm."""

    low: float
    high: float
    spacing: str


@dataclass(frozen=True)
class Sample:
    """A Sobol design over ranges: path in the scene, or ``load``, to range."""

    points: int
    seed: int
    ranges: Mapping[str, Range] = field(hash=False)


@dataclass(frozen=True)
class StandIn:
    """An input that the source does not print, and why this value stands in for it."""

    key: str
    reason: str


@dataclass(frozen=True)
class Pressures:
    """Nominal pressures of a rough contact.

    Parameters
    ----------
    over : {"slope", "pascal"}
        Whether `values` are p/(E* h'_rms) or p [Pa].
    values : tuple of float
    """

    over: str
    values: tuple[float, ...]


@dataclass(frozen=True)
class Study:
    """A validated study.

    Parameters
    ----------
    name : str
        Stem of its file.
    title : str
    scene : dict
        Canonical scene [SI]; a swept field holds its first value.
    sweeps : tuple of Sweep
        In the order of their paths.
    solvers : tuple
        One or more solver entries; a dataset of several has the dimension `solver`.
    solver_labels : tuple of str
    accuracy : str
    outputs : tuple of str
        Groups of variables that the dataset keeps.
    figures : tuple of Figure
    stand_ins : tuple of StandIn
    kind : str
        What follows is there for some kinds of studies only.
    shear_strength : dict
        ``{modulus_fraction}``, ``{value}`` or ``{table}``.
    loads, speeds : tuple of float
        [N/m], [m/s]; no loads where the sample draws them.
    sample : Sample or None
    pressures : Pressures or None
        Of a rough contact; None leaves them to the accuracy.
    gap_thresholds : tuple of float
        Gaps below which a point counts as touching, for comparison [m].
    deflection : mapping
        ``force`` [N] and ``points`` of a study of that kind.
    solid : mapping
        What studies of finite-element bodies hold beside scene and loads: ``compare`` and ``datum`` [m] of the kind
        solid; ``coefficient`` of equivalence; ``frequency``, ``stiffness_frequency`` [rad/s] and ``temperature`` [K]
        of material.
    files : mapping
        Instruments' files by the name that the study gives them.
    """

    name: str
    title: str
    scene: Mapping[str, Any] = field(hash=False)
    sweeps: tuple[Sweep, ...]
    solvers: tuple[Any, ...]
    solver_labels: tuple[str, ...]
    accuracy: str
    outputs: tuple[str, ...]
    figures: tuple[Figure, ...]
    stand_ins: tuple[StandIn, ...]
    kind: str = "stribeck"
    shear_strength: Mapping[str, Any] = field(default_factory=dict, hash=False)
    loads: tuple[float, ...] = ()
    speeds: tuple[float, ...] = ()
    sample: Sample | None = None
    pressures: Pressures | None = None
    gap_thresholds: tuple[float, ...] = ()
    deflection: Mapping[str, Any] = field(default_factory=dict, hash=False)
    solid: Mapping[str, Any] = field(default_factory=dict, hash=False)
    files: Mapping[str, MeasuredFile] = field(default_factory=dict, hash=False)

    @property
    def chapter(self) -> int | None:
        """Chapter of the source that the study belongs to, by its name ``chN-…``."""
        match = re.match(r"ch([0-9]+)-", self.name)
        return int(match[1]) if match else None
