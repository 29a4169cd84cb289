"""What the width of the domain does: friction and smallest separation over its half-width, a line a speed."""

import numpy as np
import xarray as xr
from reference_contact import friction_curve, separation_curve, table_3_1

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.lubrication.solvers.spectral import Spectral

HALF_WIDTHS = (3.2, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0)
"""Half-domain in Hertz half-widths; 3.2 is the source's ±1 mm."""
SPEEDS = (1e-3, 0.0425, 0.1, 1.0, 10.0)
ORDER = 12


def measure() -> xr.Dataset:
    """μ and u_min on every domain."""
    table = np.full((2, len(HALF_WIDTHS), len(SPEEDS)), np.nan)
    half_width = table_3_1().hertz.half_width
    for row, units in enumerate(HALF_WIDTHS):
        problem = table_3_1(units * half_width)
        contacts = Spectral(order=ORDER).sweep(problem, SPEEDS)
        table[:, row] = friction_curve(contacts, problem), separation_curve(contacts)
    return xr.Dataset(
        {
            "friction_coefficient": (("half_domain", "speed"), table[0]),
            "separation_min": (("half_domain", "speed"), table[1]),
            "half_widths": ("half_domain", list(HALF_WIDTHS)),
        },
        coords={"half_domain": half_width * np.array(HALF_WIDTHS), "speed": list(SPEEDS)},
        attrs={
            "title": "What the width of the domain does",
            "timed": f"nothing; spectral elements of order {ORDER}",
        },
    )


def draw(dataset: xr.Dataset) -> DataFigure:
    """Both over the half-domain, relative to the widest one."""
    with styled():
        figure = new_figure(style.PAGE, 3.0)
        panels = []
        for axes, name, letter in zip(
            figure.subplots(1, 2), ("friction_coefficient", "separation_min"), "ab", strict=True
        ):
            label = "μ" if letter == "a" else r"$u_\mathrm{min}$"
            panel = Panel(
                axes,
                quantity("half_widths", label="half-domain over Hertz half-width", unit="1"),
                quantity(f"relative_{name}", label=f"{label} over that of the widest domain", unit="1"),
                letter,
            )
            panel.letter(letter)
            panel.axes.set_xscale("log", base=2)
            panel.axes.xaxis.set_major_formatter("{x:g}")
            for index, speed in enumerate(dataset["speed"].values):
                values = dataset[name].sel({"speed": speed}).values
                panel.line(
                    f"{style.power(speed)} m/s",
                    dataset["half_widths"].values,
                    values / values[-1],
                    color=style.CYCLE[index],
                    marker=style.MARKERS[index],
                )
            panels.append(panel)
        share_legend(figure, panels, 5)
        return figure
