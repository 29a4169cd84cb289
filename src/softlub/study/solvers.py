"""The solver of a study: what its entry may hold, and the settings it stands for at some accuracy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

from pydantic import Field

from softlub.study import kinds, parts
from softlub.study.accuracy import Accuracy
from softlub.study.fields import Quantity, Tagged
from softlub.study.parts import PartModel
from softlub.units import Unit

_Speed = Annotated[float, Quantity(Unit("m/s", above=0))]

MODULES = ("bml", "mehl", "ehl")
"""The source's own solvers; their grid is even whatever the accuracy."""


class SolverModel(PartModel):
    """Solver with its settings, and the speeds and the domain that it is asked for."""

    label: str | None = None
    lowest: _Speed | None = Field(default=None, alias="from")
    highest: _Speed | None = Field(default=None, alias="to")
    every: Annotated[int, Quantity(Unit("1", at_least=1, at_most=1000), whole=True)] = 1
    half_domain: Annotated[float, Quantity(Unit("m", above=0))] | None = None

    def speeds(self, grid: Sequence[float]) -> list[float]:
        """Those of the grid's speeds that lie between `from` and `to`, every so many of them."""
        low = 0.0 if self.lowest is None else self.lowest * (1 - 1e-9)
        high = float("inf") if self.highest is None else self.highest * (1 + 1e-9)
        return [speed for speed in grid if low <= speed <= high][:: self.every]

    @property
    def options(self) -> dict[str, Any]:
        """What tells it from others of its name, as its label says."""
        own = {name: getattr(self, name) for name in kinds.field_names(self.part)} if self.part else {}
        return {
            name: value
            for name, value in {**own, "half_domain": self.half_domain}.items()
            if value is not None
        }


Solver = Annotated[
    Any,
    Tagged(
        "name",
        {word: parts.model_of(part, "name", word, SolverModel) for word, part in parts.SOLVERS.items()},
        bare="name of a solver",
    ),
]


def settings(solver: Any, accuracy: Accuracy) -> dict[str, Any]:
    """The solver's part of a panel's spec: its name and whatever decides its numbers, no more.

    Parameters
    ----------
    solver : SolverModel
    accuracy : Accuracy
        Fills in what the study file leaves open.

    Returns
    -------
    dict
    """
    given = {name: getattr(solver, name) for name in kinds.field_names(parts.SOLVERS[solver.name])}
    order = given.get("order") or accuracy.spectral_order
    if solver.name == "spectral":
        return {"name": "spectral", "order": order}
    if solver.name in MODULES:
        sweep = {"reynolds_sweep": given["sweep"]} if "sweep" in given else {}
        return {"name": solver.name, "nodes": given["nodes"] or accuracy.module_nodes, **sweep}
    volumes: dict[str, Any] = {"nodes": given["nodes"] or accuracy.finite_volume_nodes}
    if accuracy.grid != "graded":
        volumes["grid"] = accuracy.grid
    if solver.name == "auto":
        return {"name": "auto", "spectral": {"order": order}, "finite_volume": volumes}
    return {"name": solver.name, **volumes}


def as_block(entry: Any) -> Any:
    """A solver's bare name as the block that it stands for; anything else as it is."""
    return {"name": entry} if isinstance(entry, str) else entry


def default_solver() -> Any:
    """The solver of a study that names none."""
    return parts.model_of(parts.SOLVERS["auto"], "name", "auto", SolverModel)()
