"""The solver of a study: what its entry may hold, and the settings it stands for at some accuracy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

from pydantic import Field

from softlub.study import parts
from softlub.study.accuracy import Accuracy
from softlub.study.fields import Quantity, Tagged
from softlub.study.parts import PartModel
from softlub.units import Unit

_Speed = Annotated[float, Quantity(Unit("m/s", above=0))]

MODULES = ("bml", "mehl", "ehl")
"""The source's own solvers."""


class SolverModel(PartModel):
    """Solver with its settings, and the speeds that it is asked for."""

    label: str | None = None
    lowest: _Speed | None = Field(default=None, alias="from")
    highest: _Speed | None = Field(default=None, alias="to")
    every: Annotated[int, Quantity(Unit("1", at_least=1, at_most=1000), whole=True)] = 1

    def speeds(self, grid: Sequence[float]) -> list[float]:
        """Those of the grid's speeds that lie between `from` and `to`, every so many of them."""
        low = 0.0 if self.lowest is None else self.lowest * (1 - 1e-9)
        high = float("inf") if self.highest is None else self.highest * (1 + 1e-9)
        return [speed for speed in grid if low <= speed <= high][:: self.every]


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
    given = {name: getattr(solver, name) for name in parts.field_names(parts.SOLVERS[solver.name])}
    order = given.pop("order", None) or accuracy.spectral_order
    usual = accuracy.module_nodes if solver.name in MODULES else accuracy.finite_volume_nodes
    volumes: dict[str, Any] = {"nodes": given.pop("nodes", None) or usual}
    if accuracy.grid != "graded":
        volumes["grid"] = accuracy.grid
    if solver.name == "auto":
        return {"name": "auto", "spectral": {"order": order}, "finite_volume": volumes}
    if solver.name == "spectral":
        return {"name": "spectral", "order": order}
    return {"name": solver.name, **volumes, **given}


def as_block(entry: Any) -> Any:
    """A solver's bare name as the block that it stands for; anything else as it is."""
    return {"name": entry} if isinstance(entry, str) else entry


def default_solver() -> Any:
    """The solver of a study that names none."""
    return parts.model_of(parts.SOLVERS["auto"], "name", "auto", SolverModel)()
