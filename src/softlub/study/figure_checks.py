"""What figures lack: drawings of another kind of study, or of something that is not varied."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from pydantic_core import PydanticCustomError

from softlub.study.drawings import DRAWINGS, NEEDS
from softlub.study.figures import Figure, read_figure
from softlub.study.grid import SWEPT
from softlub.study.messages import Problem


def unmet_needs(kind: str, figures: Sequence[Figure], there: Mapping[str, bool]) -> Iterator[Problem]:
    """Figures that a study cannot have.

    Parameters
    ----------
    kind : str
        Of the study.
    figures : sequence of Figure
    there : mapping
        For each of `NEEDS`, whether the study has it.

    Yields
    ------
    Problem
    """
    for figure in figures:
        drawing = DRAWINGS[figure.draw]
        name = figure.draw if figure.name == figure.draw else f"{figure.draw} ({figure.name})"
        if kind not in drawing.kinds:
            fitting = ", ".join(other for other, one in DRAWINGS.items() if kind in one.kinds)
            yield Problem(
                "figures",
                f"{name} draws studies of the kind {' or '.join(drawing.kinds)}; of this kind: {fitting}",
            )
        elif drawing.needs and not there[drawing.needs]:
            yield Problem("figures", f"{name} needs {NEEDS[drawing.needs]}")


def unmet_needs_of_file(raw: Mapping[str, Any], kinds: Sequence[str]) -> Iterator[Problem]:
    """The same from a file whose other entries may be wrong: what figures need does not depend on their values."""
    kind, grid, figures = raw.get("kind", kinds[0]), raw.get("grid"), raw.get("figures")
    if kind not in kinds or not isinstance(grid or {}, dict) or not isinstance(figures, list):
        return
    grid = grid or {}
    solvers = grid.get("solver")
    there = {
        "solver": isinstance(solvers, list) and len(solvers) > 1,
        "field": any(str(key).startswith(SWEPT) for key in grid),
        "sample": "sample" in grid,
    }
    yield from unmet_needs(kind, [figure for figure in map(_readable, figures) if figure], there)


def _readable(entry: Any) -> Figure | None:
    try:
        return read_figure(entry)
    except PydanticCustomError:
        return None
