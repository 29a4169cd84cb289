"""Rough contact of several surfaces (figures 4-12, 4-14 to 4-16): real area (a), its κ (b), separation (c)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets.contact_curves import (
    WINDOW,
    ContactCurve,
    contact_curve,
    inputs,
    local_kappa,
    secant_kappa,
    surfaces,
)
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import Quantity, quantity
from softlub.figures.surface_labels import surface_labels

PERSSON, BUSH = np.sqrt(8 / np.pi), np.sqrt(2 * np.pi)
"""κ of Persson's theory and of Bush, Gibson and Thomas."""
LOAD = quantity("reduced_load", label=r"load $p/(E^*h'_\mathrm{rms})$", unit="1")
PRESSURE = quantity("reduced_pressure", label=r"load $p/E^*$", unit="1")
AREA = quantity("contact_area_ratio", label=r"real area $A/A_0$", unit="1")
KAPPA = quantity("kappa", label=r"$\kappa = A/A_0 \cdot E^*h'_\mathrm{rms}/p$", unit="1")
SEPARATION = quantity("relative_separation", label=r"mean separation $u/h_\mathrm{rms}$", unit="1")
FULL_CONTACT = 1e-4
"""u/h_rms below which nothing is drawn."""


def draw(dataset: xr.Dataset, height: float = 3.1) -> DataFigure:
    """Draw the contact of each surface, averaged over its realisations.

    Lines show the area corrected for its edge, open circles the count of pixels; κ is given as the secant (lines) and
    the local slope (dotted). Thin lines bound the realisations.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of rough contact.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    curves = [contact_curve(surface) for surface in surfaces(dataset)]
    labels = surface_labels([inputs(surface) for surface in surfaces(dataset)])
    with styled():
        figure = new_figure(style.PAGE, height)
        area, kappa, separation = _panels(figure)
        for index, (label, curve) in enumerate(zip(labels, curves, strict=True)):
            colour = style.CYCLE[index % len(style.CYCLE)]
            name = label or "surface"
            _draw_area(area, name, curve, colour)
            _draw_kappa(kappa, name, curve, colour)
            _draw_separation(separation, name, curve, colour)
            for panel, x in ((area, curve.load), (kappa, curve.load), (separation, curve.reduced_pressure)):
                panel.mark_failed(x[curve.failed], colour, index)
        _draw_theories(area, kappa)
        _limit(area, kappa, separation, curves)
        counts = sorted({curve.realisations for curve in curves})
        if counts[-1] > 1:
            figure.notes.append(
                f"Curves are means of {' to '.join(map(str, counts))} realisations, thin lines their bounds."
            )
        share_legend(figure, [area, kappa, separation], 4)
        return figure


def _panels(figure: DataFigure) -> tuple[Panel, Panel, Panel]:
    quantities: Sequence[tuple[Quantity, Quantity]] = ((LOAD, AREA), (LOAD, KAPPA), (PRESSURE, SEPARATION))
    panels = [
        Panel(axes, x, y, letter)
        for axes, (x, y), letter in zip(figure.subplots(1, 3), quantities, "abc", strict=True)
    ]
    for panel in panels:
        panel.letter(panel.name)
    for panel in panels[1:]:
        panel.axes.set_xscale("log")
    return panels[0], panels[1], panels[2]


def _draw_area(panel: Panel, name: str, curve: ContactCurve, colour: str) -> None:
    light = curve.load <= _window_end(curve)
    load = curve.load[light]
    panel.line(name, load, curve.mean["contact_area_ratio"][light], color=colour)
    _draw_spread(panel, name, curve, "contact_area_ratio", light, colour)
    panel.line(
        f"{name}, pixels counted",
        load,
        curve.mean["contact_area_ratio_pixel"][light],
        "",
        **_pixels(colour),
    )


def _pixels(colour: str) -> dict[str, Any]:
    return {"linestyle": "none", "marker": "o", "markersize": 3, "markerfacecolor": "none", "color": colour}


def _draw_spread(
    panel: Panel, name: str, curve: ContactCurve, variable: str, kept: np.ndarray, colour: str
) -> None:
    if curve.realisations < 2:
        return
    for bound, values in (("least", curve.low), ("greatest", curve.high)):
        panel.line(
            f"{name}, {bound} of {curve.realisations}",
            curve.load[kept],
            values[variable][kept],
            "",
            color=colour,
            linewidth=0.4,
        )


def _window_end(curve: ContactCurve) -> float:
    """Lightest load at which the area has left the window, or the heaviest load."""
    left = curve.load[curve.mean["contact_area_ratio"] > WINDOW]
    return float(left[0]) if left.size else float(curve.load[-1])


def _draw_kappa(panel: Panel, name: str, curve: ContactCurve, colour: str) -> None:
    load = curve.load
    corrected, pixels = (curve.mean[f"contact_area_ratio{count}"] for count in ("", "_pixel"))
    panel.line(name, load, secant_kappa(load, corrected), "", color=colour)
    panel.line(
        f"{name}, local slope",
        load,
        local_kappa(load, corrected),
        "",
        color=colour,
        linestyle=":",
        linewidth=1.0,
    )
    panel.line(f"{name}, pixels counted", load, secant_kappa(load, pixels), "", **_pixels(colour))


def _draw_separation(panel: Panel, name: str, curve: ContactCurve, colour: str) -> None:
    relative = curve.relative_separation()
    shown = np.where(relative > FULL_CONTACT, relative, np.nan)
    panel.line(name, curve.reduced_pressure, shown, "", color=colour)
    if "mean_separation_persson_gamma" in curve.mean:
        panel.line(
            f"{name}, Persson",
            curve.reduced_pressure,
            curve.relative_separation("mean_separation_persson_gamma"),
            "",
            color=colour,
            linestyle="--",
            linewidth=0.7,
        )


def _draw_theories(area: Panel, kappa: Panel) -> None:
    """Both theories' lines, and what the looks of the surfaces' lines mean."""
    for name, value, dashes in (("Persson", PERSSON, "--"), ("Bush, Gibson, Thomas", BUSH, "-.")):
        load = np.array([0.0, WINDOW / value])
        panel_look: dict[str, Any] = {"color": style.GREY, "linestyle": dashes, "linewidth": 0.9}
        area.line(f"{name}, κ = {value:.2f}", load, value * load, **panel_look)
        kappa.line(name, [1e-6, 1e3], [value, value], "", **panel_look)
    looks: tuple[tuple[str, dict[str, Any]], ...] = (
        ("area corrected for its edge", {"color": style.BLACK}),
        ("pixels counted", _pixels(style.BLACK)),
        ("local slope (b)", {"color": style.BLACK, "linestyle": ":"}),
        ("Persson, γ = 0.45 (c)", {"color": style.BLACK, "linestyle": "--", "linewidth": 0.7}),
    )
    for label, look in looks:
        (handle,) = kappa.axes.plot([], [], label=label, **look)
        kappa.handles.append(handle)


def _limit(area: Panel, kappa: Panel, separation: Panel, curves: Sequence[ContactCurve]) -> None:
    loads = np.concatenate([curve.load for curve in curves])
    area.axes.set_xlim(0.0, 0.12)
    area.axes.set_ylim(0.0, WINDOW)
    kappa.axes.set_xlim(loads.min() / 1.3, loads.max() * 1.3)
    highest = max(
        float(np.nanmax(secant_kappa(curve.load, curve.mean["contact_area_ratio_pixel"]), initial=0.0))
        for curve in curves
    )
    kappa.axes.set_ylim(0.0, 1.05 * max(highest, BUSH))
    separation.axes.set_ylim(bottom=0.0)
