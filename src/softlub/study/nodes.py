"""Nodes of the plan: what is to be computed, under a key made of its content."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from softlub.study.messages import Problem, StudyError

DIGITS = 10
"""Hex digits of a key."""

FIGURE_FORMATS = ("pdf", "png", "svg", "csv")


def canonical_json(spec: Any) -> str:
    """A spec as text that does not depend on the order of its keys."""
    return json.dumps(spec, sort_keys=True, separators=(",", ":"), allow_nan=False)


def digest(spec: Any) -> str:
    """sha256 of a spec's canonical text, in hex."""
    return hashlib.sha256(canonical_json(spec).encode()).hexdigest()


@dataclass(frozen=True)
class Node:
    """One job and the file it makes.

    Parameters
    ----------
    kind : str
        ``topography``, ``law``, ``state``, ``stiffness``, ``equivalence``, ``panel``, ``study`` or ``figure``.
    name : str
        What its files are called: the key; of the last two ``<study>`` and ``<study>/<figure>``.
    key : str
        Readable slug and ten hex digits of the hash of `spec`.
    spec : mapping
        Everything that decides the result, in SI: JSON values only.
    inputs : tuple of str
        Keys of the nodes whose files it reads.
    files : tuple of str
        Files from outside that it reads; the spec holds the hash of what is in them, not where they lie.
    """

    kind: str
    name: str
    key: str
    spec: Mapping[str, Any] = field(hash=False)
    inputs: tuple[str, ...] = ()
    files: tuple[str, ...] = ()

    @property
    def path(self) -> str:
        """Its file below the results folder; of a figure the PDF."""
        folder = {"study": "studies", "figure": "figures"}.get(self.kind, self.kind)
        return f"{folder}/{self.name}.{'pdf' if self.kind == 'figure' else 'nc'}"

    @property
    def paths(self) -> tuple[str, ...]:
        """All its files below the results folder."""
        if self.kind != "figure":
            return (self.path,)
        return tuple(f"{self.path.removesuffix('.pdf')}.{suffix}" for suffix in FIGURE_FORMATS)


def make_node(
    kind: str,
    slug: str,
    spec: Mapping[str, Any],
    inputs: Iterable[Node] = (),
    name: str = "",
    files: tuple[str, ...] = (),
) -> Node:
    """A node with its key.

    Parameters
    ----------
    kind : str
    slug : str
        Readable part of the key.
    spec : mapping
        Without the keys of the inputs, which are put into it.
    inputs : iterable of Node
    name : str
        Of its files; the key where there is none.
    files : tuple of str
        Files from outside that it reads.

    Returns
    -------
    Node
    """
    keys = tuple(node.key for node in inputs)
    whole = {**spec, "input_keys": list(keys)}
    key = f"{slug}-{digest(whole)[:DIGITS]}"
    return Node(kind, name or key, key, whole, keys, files)


@dataclass(frozen=True)
class Plan:
    """Everything that some studies need, each node once.

    Parameters
    ----------
    nodes : tuple of Node
        Inputs before those that read them.
    chapters : mapping
        Study -> chapter of the source; studies of one's own are not in it.
    """

    nodes: tuple[Node, ...]
    chapters: Mapping[str, int] = field(default_factory=dict, hash=False)

    def of_kind(self, kind: str) -> tuple[Node, ...]:
        """All nodes of a kind."""
        return tuple(node for node in self.nodes if node.kind == kind)

    def node(self, kind: str, name: str) -> Node:
        """The node of a kind by its name or key; KeyError where there is none."""
        for node in self.nodes:
            if node.kind == kind and name in (node.name, node.key):
                return node
        raise KeyError(f"no {kind} {name} is planned")

    def inputs(self, node: Node) -> tuple[Node, ...]:
        """The nodes whose files a node reads, in its order."""
        by_key = {other.key: other for other in self.nodes}
        return tuple(by_key[key] for key in node.inputs)

    def figures(self, study: str) -> tuple[Node, ...]:
        """Figures of one study."""
        return tuple(node for node in self.of_kind("figure") if node.spec["study"] == study)

    @property
    def studies(self) -> tuple[str, ...]:
        """Names of the studies."""
        return tuple(node.name for node in self.of_kind("study"))


def merge(plans: Iterable[Plan]) -> Plan:
    """One plan of several; what they share stands in it once.

    Parameters
    ----------
    plans : iterable of Plan

    Returns
    -------
    Plan

    Raises
    ------
    StudyError
        If two different studies have one name.
    """
    merged: dict[str, Node] = {}
    chapters: dict[str, int] = {}
    names: dict[tuple[str, str], str] = {}
    for plan in plans:
        chapters.update(plan.chapters)
        for node in plan.nodes:
            if names.setdefault((node.kind, node.name), node.key) != node.key:
                raise StudyError(
                    node.name, [Problem("", "two different studies have this name; rename one file")]
                )
            merged.setdefault(node.key, node)
    return Plan(tuple(merged.values()), chapters)
