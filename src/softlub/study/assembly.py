"""From the models of a file and its swept fields to the study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from softlub.study.blocks import Names
from softlub.study.grid import SWEPT
from softlub.study.labels import labels
from softlub.study.models import StudyFile
from softlub.study.outputs import SCALARS
from softlub.study.parsed import Range, Sample, StandIn, Study, Sweep
from softlub.study.solvers import default_solver


def assembled(
    name: str,
    file: StudyFile,
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
    file : StudyFile
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
    drawn = file.grid.sample
    sample = None if drawn is None else Sample(drawn.points, drawn.seed, dict(sorted(ranges.items())))
    solvers = tuple(file.grid.solver or [file.solver or default_solver()])
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
        shear_strength=file.scene.shear_strength,
        loads=file.grid.load or (),
        speeds=file.grid.speed,
        sweeps=tuple(sweeps),
        sample=sample,
        solvers=solvers,
        solver_labels=tuple(solver_labels),
        accuracy=accuracy,
        outputs=tuple(file.outputs or SCALARS),
        figures=tuple(file.figures),
        stand_ins=tuple(stand_ins),
    )
