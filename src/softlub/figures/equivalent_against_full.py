"""Displacement of a viscoelastic body's contact edge, and by reduced stiffnesses of its equivalents (figure 5-16)."""

from __future__ import annotations

import xarray as xr

from softlub.figures.edge_displacements import EdgeCurve, difference_sentence, draw_edges, line, markers
from softlub.figures.models import VISCOELASTIC, Model, models, scene_sentences
from softlub.figures.panel import DataFigure, styled


def draw(
    dataset: xr.Dataset,
    friction: float | None = None,
    load: float | None = None,
    steps: str = "",
    height: float = 4.1,
) -> DataFigure:
    """Draw the viscoelastic body as a line and what reduced stiffnesses make of its nodal forces as markers.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind equivalence.
    friction, load : float, optional
        Which one where several were swept [1], [N/m]; without them the first and the heaviest.
    steps : str, optional
        The same by label; the first without it.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure

    Raises
    ------
    ValueError
        If the dataset lacks one of them.
    """
    everyone = models(dataset, {"friction": friction, "load": load, "steps": steps})
    full, others = everyone[0], everyone[1:]
    moved, x = full.along_edge("displacement"), full.data["x"].values
    curves = [EdgeCurve(f"finite elements, {VISCOELASTIC}", x, moved, line(0))]
    for index, model in enumerate(others):
        look = markers(index, 1 + index, x.size)
        curves.append(EdgeCurve(_label(model), x, model.along_edge("displacement_reduced"), look, moved))
    with styled():
        figure = draw_edges(curves, height)
        figure.notes += scene_sentences(dataset, everyone)
        if bool(full.data["converged"]):
            figure.notes += [_sentence(model) for model in others if bool(model.data["converged"])]
        return figure


def _label(model: Model) -> str:
    return f"reduced stiffness, {model.label.removeprefix('hyperelastic, ')}"


def _sentence(model: Model) -> str:
    each = model.data["displacement_reduced_error_component"]
    lateral, vertical = (float(each.sel(component=name)) for name in "xy")
    return difference_sentence(
        _label(model), float(model.data["displacement_reduced_error"]), lateral, vertical
    )
