"""From the models of a file and its swept fields to the study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from softlub.study.blocks import Names
from softlub.study.contact_grid import default_contact_solver
from softlub.study.grid import SWEPT
from softlub.study.labels import labels
from softlub.study.models import (
    DeflectionFile,
    EquivalenceFile,
    MaterialFile,
    RoughContactFile,
    SolidFile,
    StudyFile,
    SurfaceFile,
)
from softlub.study.outputs import SCALARS
from softlub.study.parsed import Pressures, Range, Sample, StandIn, Study, Sweep
from softlub.study.solvers import default_solver

AnyFile = (
    StudyFile | RoughContactFile | SurfaceFile | DeflectionFile | SolidFile | EquivalenceFile | MaterialFile
)


def assembled(
    name: str,
    file: AnyFile,
    sweeps: Sequence[Sweep],
    ranges: Mapping[str, Range],
    accuracy: str,
    names: Names,
) -> Study:
    """The study of a file whose parts were read.

    Parameters
    ----------
    name : str
        Stem of the file.
    file : StudyFile, RoughContactFile or SurfaceFile
    sweeps : sequence of Sweep
    ranges : mapping
        Of the sample, by path.
    accuracy : str
        The one in force.
    names : Names
        Knows which named blocks stand in for something.

    Returns
    -------
    Study
    """
    solvers = _solvers(file)
    solver_labels = labels(
        [solver.name for solver in solvers],
        [solver.options for solver in solvers],
        [solver.label for solver in solvers],
    )
    stand_ins = [StandIn(entry.key, entry.reason) for entry in file.stand_ins]
    stand_ins += [StandIn(f"{SWEPT}{place}", reason) for place, reason in names.stand_ins.items()]
    return Study(
        name=name,
        title=file.title or name,
        scene=file.scene.canonical(),
        sweeps=tuple(sweeps),
        solvers=tuple(solvers),
        solver_labels=tuple(solver_labels),
        accuracy=accuracy,
        figures=tuple(file.figures),
        stand_ins=tuple(stand_ins),
        kind=file.kind,
        **_own_part(file, ranges),
    )


def _solvers(file: AnyFile) -> list[Any]:
    if isinstance(file, StudyFile):
        return list(file.grid.solver or [file.solver or default_solver()])
    if isinstance(file, RoughContactFile):
        return list(file.grid.solver or [file.solver or default_contact_solver()])
    return []


def _own_part(file: AnyFile, ranges: Mapping[str, Range]) -> dict[str, Any]:
    """What only studies of its kind hold."""
    if isinstance(file, StudyFile):
        drawn = file.grid.sample
        return {
            "shear_strength": file.scene.shear_strength,
            "loads": file.grid.load or (),
            "speeds": file.grid.speed,
            "sample": drawn and Sample(drawn.points, drawn.seed, dict(sorted(ranges.items()))),
            "outputs": tuple(file.outputs or SCALARS),
        }
    if isinstance(file, DeflectionFile):
        return {"outputs": (), "deflection": {"force": file.grid.force, "points": file.grid.points}}
    if isinstance(file, MaterialFile):
        return {"outputs": (), "solid": file.grid.model_dump()}
    if isinstance(file, SolidFile):
        own_grid = {"compare": file.compare, "datum": file.datum}
        return {"outputs": tuple(file.outputs or ()), "loads": file.grid.load, "solid": own_grid}
    if isinstance(file, EquivalenceFile):
        own_grid = {"coefficient": file.grid.coefficient}
        return {"outputs": tuple(file.outputs or ()), "loads": file.grid.load, "solid": own_grid}
    own: dict[str, Any] = {"outputs": tuple(file.outputs or ())}
    if isinstance(file, RoughContactFile):
        for over, values in (("slope", file.grid.normalised_pressure), ("pascal", file.grid.pressure)):
            if values is not None:
                own["pressures"] = Pressures(over, values)
        own["gap_thresholds"] = file.gap_thresholds
    return own
