"""Studies that are too large to be what anybody meant: refused before their scenes are even listed."""

from __future__ import annotations

import math
from collections.abc import Iterator

from softlub.study.messages import Problem
from softlub.study.parsed import Study

MOST_POINTS = 2_000_000
"""Points of a study, each a solution at one load and one speed."""

MOST_CURVES = 1000
"""Curves over swept fields and loads, which one job solves; a sample is cut into jobs."""

MOST_JOBS = 500
"""Laws, topographies, states and stiffnesses of a study."""


def size_problems(study: Study) -> Iterator[Problem]:
    """Whether a study asks for more than is reasonable, with what would do instead."""
    combinations = math.prod(len(sweep.values) for sweep in study.sweeps)
    if study.kind == "stribeck":
        yield from _too_many_points(study, combinations * max(1, len(study.loads)))
    elif study.kind in ("solid", "equivalence", "material"):
        yield from _too_many_bodies(study, combinations)
    elif combinations * max(1, len(study.solvers)) > MOST_JOBS:
        yield Problem("grid", f"makes {combinations} surfaces; allowed: {MOST_JOBS} jobs at most")


def _too_many_points(study: Study, swept: int) -> Iterator[Problem]:
    curves = swept * (study.sample.points if study.sample else 1)
    points = curves * sum(len(solver.speeds(study.speeds)) for solver in study.solvers)
    remedy = "take fewer points"
    if study.sample is None:
        remedy += ", or draw a sample of the loads and fields, which is cut into jobs: grid.sample"
    if points > MOST_POINTS:
        yield Problem(
            "grid",
            f"asks for {points:,} points ({curves:,} curves over the speeds of each solver); "
            f"allowed: {MOST_POINTS:,} at most; {remedy}",
        )
    elif swept > MOST_CURVES:
        yield Problem(
            "grid",
            f"asks for {swept:,} curves over loads and swept fields in one job; "
            f"allowed: {MOST_CURVES:,} at most; {remedy}",
        )


def _too_many_bodies(study: Study, combinations: int) -> Iterator[Problem]:
    each = {
        "solid": len(study.loads) + 1,
        "equivalence": len(study.loads) * (3 + 2 * len(study.solid.get("coefficient", ()))),
        "material": max(1, len(study.solid.get("stiffness_frequency", ()))),
    }[study.kind]
    if combinations * each > MOST_JOBS:
        yield Problem(
            "grid",
            f"makes {combinations * each:,} jobs, {each} for each of {combinations:,} scenes; "
            f"allowed: {MOST_JOBS} at most; take fewer loads or swept values",
        )
