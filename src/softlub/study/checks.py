"""What only the whole study shows: solvers that cannot do the scene, figures that lack what they draw."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from softlub.study import paths
from softlub.study.contact_checks import contact_problems, law_problems
from softlub.study.drawings import DRAWINGS
from softlub.study.figure_checks import unmet_needs
from softlub.study.figures import Figure
from softlub.study.messages import Problem
from softlub.study.parsed import Study
from softlub.study.solid_checks import body_problems, solid_problems

ALL_SOLVERS = ("stribeck", "parameter_study")
"""Drawings that show the curves of every solver; the others show Newton's only."""
MESHED_SOLVERS = ("auto", "finite_volume")
"""Solvers that know bodies of finite elements."""


def problems_of(study: Study) -> list[Problem]:
    """Everything wrong with a study whose entries are all right by themselves."""
    if study.kind == "deflection":
        return [*_figure_problems(study)]
    if study.kind in ("solid", "equivalence", "material"):
        return [*_figure_problems(study), *solid_problems(study)]
    if study.kind != "stribeck":
        return [*_figure_problems(study), *contact_problems(study)]
    return [
        *_solver_problems(study),
        *_figure_problems(study),
        *_grid_problems(study),
        *law_problems(study),
        *body_problems(study),
    ]


def _values(study: Study, path: str) -> list[Any]:
    """Every value that a field of the scene takes in a study."""
    taken = [paths.get(study.scene, path)]
    for sweep in study.sweeps:
        if sweep.path == path:
            taken += sweep.values
        elif path.startswith(f"{sweep.path}."):
            taken += [value.get(path[len(sweep.path) + 1 :]) for value in sweep.values]
    return taken


def _solver_problems(study: Study) -> Iterator[Problem]:
    for label, solver in zip(study.solver_labels, study.solvers, strict=True):
        if study.solver_labels.count(label) > 1:
            yield Problem("grid.solver", f"has {label} twice; drop one, or give each a label")
        if not solver.speeds(study.speeds):
            yield Problem("solver", f"{label} is left no speed of the grid between its from and to")
        if solver.name not in ("auto", "finite_volume") and "mass_conserving" in _values(
            study, "lubricant.cavitation"
        ):
            yield Problem(
                "solver",
                f"{solver.name} knows the cavitation reynolds only; allowed here: auto, finite_volume",
            )
        if solver.name not in MESHED_SOLVERS and "initial" in _values(study, "body.stiffness"):
            yield Problem(
                "solver",
                f"{solver.name} knows half-spaces only; allowed with stiffness initial: {', '.join(MESHED_SOLVERS)}",
            )
        if solver.half_domain is not None and "initial" in _values(study, "body.stiffness"):
            yield Problem("solver", f"{label} has a half_domain, and the film is as wide as the contact edge")
        if solver.name == "bml" and "none" in _values(study, "contact_law.name"):
            yield Problem(
                "solver", "bml needs asperity contact, and contact_law is none; allowed here: auto, ehl, …"
            )


def _figure_problems(study: Study) -> Iterator[Problem]:
    there = {
        "solver": len(study.solvers) > 1,
        "field": bool(study.sweeps),
        "sample": study.sample is not None,
    }
    yield from unmet_needs(study.kind, study.figures, there)
    for figure in study.figures:
        if study.kind in DRAWINGS[figure.draw].kinds:
            yield from _option_problems(study, figure)


def _curve_problems(study: Study, figure: Figure) -> Iterator[Problem]:
    """More curves than the drawing tells apart."""
    most = DRAWINGS[figure.draw].curves
    count = math.prod([len(study.loads), *(len(sweep.values) for sweep in study.sweeps)])
    if study.sample is not None:
        count = study.sample.points
    if figure.draw in ALL_SOLVERS:
        count *= len(study.solvers)
    if most and count > most:
        yield Problem(
            "figures",
            f"{figure.draw} ({figure.name}) would show {count} curves and tells {most} apart; sweep fewer values, or "
            "make a study for each part of them",
        )


def _option_problems(study: Study, figure: Figure) -> Iterator[Problem]:
    yield from _curve_problems(study, figure)
    for name, unit, there in (("speed", "m/s", study.speeds), ("load", "N/m", study.loads)):
        wanted = figure.options.get(name)
        if wanted is not None and all(abs(math.log(wanted / own)) > 0.1 for own in there):
            yield Problem(
                "figures",
                f"{figure.name} asks for {wanted:g} {unit}, which is not among the {name}s of the grid; add it there",
            )
    for name in figure.options.get("solvers", ()):
        if name not in [solver.name for solver in study.solvers]:
            yield Problem("figures", f"{figure.name} asks for the solver {name}, which is not in grid.solver")


def _grid_problems(study: Study) -> Iterator[Problem]:
    if study.sample is not None and study.sweeps:
        yield Problem(
            "grid", "a sample and swept fields exclude each other; put the fields among the sample's ranges"
        )
    for path in study.sample.ranges if study.sample else ():
        if path.startswith("body.") and study.scene["body"]["stiffness"] != "half_space":
            yield Problem(
                f"grid.sample.ranges.scene.{path}",
                "would need a reduced stiffness for every point of the sample; sweep the field in steps instead",
            )
