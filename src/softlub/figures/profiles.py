"""Pressures and separation along the sliding direction at one speed (figures 3-9 to 3-11)."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from softlub.figures import fields, style
from softlub.figures.curves import nearest_speed
from softlub.figures.friction_and_separation import colour_axis
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity


def draw(
    dataset: xr.Dataset, speed: float | None = None, amplify: float = 1.0, height: float = 3.3
) -> DataFigure:
    """Draw the three fields of a contact; one line style a value of the swept dimension.

    Parameters
    ----------
    dataset : xarray.Dataset
        With fields over nodes.
    speed : float, optional
        [m/s]; the dataset's closest is taken.
    amplify : float
        Factor on the asperity pressure, to make it visible; the legend says so.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    speed = nearest_speed(dataset, speed)
    drawn = fields.profiles(dataset, speed, fields.swept_dimension(dataset))
    with styled():
        figure = new_figure(style.COLUMN, height)
        pressure, separation = field_panels(figure.subplots(), drawn)
        for index, profile in enumerate(drawn):
            draw_fields(pressure, separation, profile, index, amplify)
        field_legend(figure, drawn, amplify)
        pressure.axes.set_title(f"v = {style.power(speed)} m/s", loc="right")
        return figure


def field_panels(left: Axes, drawn: list[fields.Profile]) -> tuple[Panel, Panel]:
    """Pressure on the left axis, separation on the right one, both cut to the contact.

    Parameters
    ----------
    left : matplotlib.axes.Axes
    drawn : list of Profile
        What will be drawn; sets the window and the units.

    Returns
    -------
    pressure, separation : Panel
    """
    window = fields.contact_window(drawn)
    film = fields.separation_limit(drawn, window)
    position = quantity("x", max(abs(window[0]), abs(window[1])))
    pressure = Panel(left, position, fields.pressure_axis(drawn), "pressure")
    separation = Panel(left.twinx(), position, quantity("separation", film), "separation")
    left.tick_params(right=False)
    pressure.axes.set_xlim(*position.shown(window))
    highest = max(np.nanmax(np.fmax(p.fluid_pressure, p.solid_pressure)) for p in drawn)
    # An amplified pressure may leave the panel; the true ones fill it.
    top = float(pressure.y.shown(highest))
    pressure.axes.set_ylim(-0.03 * top, 1.08 * top)
    separation.axes.set_ylim(0.0, float(separation.y.shown(film)))
    colour_axis(separation, style.SEPARATION)
    return pressure, separation


def draw_fields(
    pressure: Panel, separation: Panel, profile: fields.Profile, index: int, amplify: float = 1.0
) -> None:
    """The three fields of one profile, in the colours of the source: blue, green, red."""
    suffix = f", {profile.label}" if profile.label else ""
    look = fields.look(index)
    pressure.line(f"fluid pressure{suffix}", profile.x, profile.fluid_pressure, "", color=style.FLUID, **look)
    solid = amplify * profile.solid_pressure
    name = f"asperity pressure × {amplify:g}" if amplify != 1.0 else "asperity pressure"
    pressure.line(f"{name}{suffix}", profile.x, solid, "", color=style.SOLID, **look)
    separation.line(f"separation{suffix}", profile.x, profile.separation, "", color=style.SEPARATION, **look)


def field_handles(times: str = "") -> list[Line2D]:
    """What the three colours mean."""
    return [
        Line2D([], [], color=style.FLUID, label="fluid pressure"),
        Line2D([], [], color=style.SOLID, label=f"asperity pressure{times}"),
        Line2D([], [], color=style.SEPARATION, label="separation"),
    ]


def field_legend(figure: DataFigure, drawn: list[fields.Profile], amplify: float = 1.0) -> None:
    """Colours name the fields, line styles the profiles."""
    handles = field_handles(f" × {style.power(amplify)}" if amplify != 1.0 else "")
    for index, profile in enumerate(drawn):
        if profile.label:
            state = "" if profile.converged else " (last iterate)"
            handles.append(
                Line2D([], [], color=style.BLACK, label=profile.label + state, **fields.look(index))
            )
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
