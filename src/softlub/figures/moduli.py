"""Storage and loss modulus (a) and loss factor (b) of a viscoelastic material over frequency (figures 5-12 to 5-14)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.bodies import readable
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import Quantity, quantity

COLOURS = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE)
MOST_CURVES = len(COLOURS)
FREQUENCY = quantity("frequency", label="angular frequency ω", unit="rad/s")
LEAST_LOSS = 1e-3
"""Loss modulus over the least storage modulus down to which it is shown."""
PLATEAU = 100.0
"""Factor of the frequency that is shown beyond the transition, on either side."""
FLAT = 0.05
"""Stiffening up to which the storage modulus counts as flat."""


class Moduli(NamedTuple):
    """Moduli of one material at one temperature."""

    label: str
    data: xr.Dataset


def draw(dataset: xr.Dataset, material: str = "", height: float = 2.7) -> DataFigure:
    """Draw the moduli of a material, at each temperature where there are several.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind material.
    material : str
        Which one where several were swept; all of them without it.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure

    Raises
    ------
    ValueError
        If the dataset lacks that material or has more curves than a figure tells apart.
    """
    everyone = _everyone(dataset, material)
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2)
        modulus = Quantity("tensile_modulus", "modulus E′, E″", "Pa", 6)
        panels = [
            Panel(left, FREQUENCY, modulus, "a"),
            Panel(right, FREQUENCY, quantity("loss_factor", label="loss factor tan φ"), "b"),
        ]
        for panel in panels:
            panel.letter(panel.name)
            panel.axes.set_xscale("log")
        panels[0].axes.set_yscale("log")
        for index, one in enumerate(everyone):
            _draw_one(panels, one, _colours(index, len(everyone)))
        low = min(float(one.data["storage_modulus"].min()) for one in everyone)
        high = max(float(one.data["storage_modulus"].max()) for one in everyone)
        # The loss falls for ever on both sides of the transition.
        panels[0].axes.set_ylim(*modulus.shown([LEAST_LOSS * low, 3 * high]))
        for panel in panels:
            panel.axes.set_xlim(*_transition(everyone, LEAST_LOSS * low))
        panels[1].axes.set_ylim(bottom=0)
        share_legend(figure, panels, columns=3)
        figure.notes += [_sentence(one) for one in everyone]
        return figure


def _transition(everyone: list[Moduli], least: float) -> tuple[float, float]:
    """Frequencies to show: where any loss modulus is above the least one, and part of both plateaus [rad/s]."""
    frequency = everyone[0].data["frequency"].values
    lossy = np.any([one.data["loss_modulus"].values > least for one in everyone], axis=0)
    if not lossy.any():
        return float(frequency[0]), float(frequency[-1])
    between = frequency[lossy]
    return max(frequency[0], between[0] / PLATEAU), min(frequency[-1], between[-1] * PLATEAU)


def _everyone(dataset: xr.Dataset, material: str) -> list[Moduli]:
    """Every material, and temperature where there are several, with its label."""
    if material and "material" in dataset.dims:
        labels = [str(label) for label in dataset["material"].values]
        if material not in labels:
            raise ValueError(f"the dataset holds no material {material}, only {', '.join(labels)}")
        dataset = dataset.isel(material=labels.index(material))
    over = [str(name) for name in dataset["storage_modulus"].dims if name != "frequency"]
    stacked = dataset[["storage_modulus", "loss_modulus", "loss_factor"]]
    found = []
    for place in np.ndindex(*(stacked.sizes[name] for name in over)):
        one = stacked.isel(dict(zip(over, place, strict=True)))
        labels = [_value(one, name) for name in over if stacked.sizes[name] > 1]
        found.append(Moduli(", ".join(labels), one))
    if len(found) > MOST_CURVES:
        raise ValueError(
            f"moduli would show {len(found)} curves and tells {MOST_CURVES} apart; choose a material by the "
            "figure's option, or take fewer temperatures"
        )
    return found


def _value(one: xr.Dataset, name: str) -> str:
    value = one[name].values.item() if name in one.coords else ""
    if isinstance(value, str):
        return readable(value)
    return f"T = {value:g} K" if name == "temperature" else f"{name.replace('_', ' ')} = {value:g}"


def _colours(index: int, count: int) -> tuple[str, str, str]:
    """Of storage, loss and loss factor: each its own where one material is drawn."""
    if count == 1:
        return style.BLUE, style.VERMILION, style.BLACK
    return (COLOURS[index],) * 3


def _draw_one(panels: list[Panel], one: Moduli, colours: tuple[str, str, str]) -> None:
    frequency = one.data["frequency"].values
    head = f"{one.label}: " if one.label else ""
    drawn: tuple[tuple[str, str, Panel, Any], ...] = (
        ("storage_modulus", "storage modulus E′", panels[0], "-"),
        ("loss_modulus", "loss modulus E″", panels[0], "--"),
        ("loss_factor", "loss factor tan φ", panels[1], "-"),
    )
    for (name, words, panel, dashes), colour in zip(drawn, colours, strict=True):
        panel.line(f"{head}{words}", frequency, one.data[name].values, color=colour, linestyle=dashes)


def _sentence(one: Moduli) -> str:
    frequency, storage = one.data["frequency"].values, one.data["storage_modulus"].values
    factor = one.data["loss_factor"].values
    stiff = np.flatnonzero(storage > (1 + FLAT) * storage[0])
    head = f"{style.plain(one.label)}: " if one.label else ""
    begins = f", {100 * FLAT:.0f} % more from {_rate(frequency[stiff[0]])} on" if stiff.size else ""
    peak = int(np.argmax(factor))
    return (
        f"{head}E′ is {storage[0] / 1e6:.3g} MPa at the lowest frequency{begins}, and {storage[-1] / 1e6:.4g} "
        f"MPa at the highest; tan φ reaches {factor[peak]:.2g} at {_rate(frequency[peak])}."
    )


def _rate(frequency: float) -> str:
    """A frequency to one digit: 3e7 rad/s."""
    return f"{float(f'{frequency:.1g}'):g} rad/s".replace("e+0", "e").replace("e+", "e")
