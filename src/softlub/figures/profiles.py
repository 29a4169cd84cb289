"""Pressures and separation along the sliding direction at one speed (figures 3-9 to 3-11)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from softlub.figures import fields, style
from softlub.figures.friction_and_separation import colour_axis
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity

AMPLIFIED = style.PURPLE
"""Colour of the asperity pressure times a factor, which the three fields leave free."""


def draw(
    dataset: xr.Dataset,
    speed: float | None = None,
    load: float | None = None,
    amplify: float = 1.0,
    amplified: str | None = None,
    height: float = 3.3,
) -> DataFigure:
    """Draw the three fields of a contact; one line style a value of the swept dimension.

    Parameters
    ----------
    dataset : xarray.Dataset
        With fields over nodes.
    speed : float, optional
        [m/s]; the dataset's closest is taken.
    load : float, optional
        [N/m]; of a dataset with several loads the closest is taken, the middle one by default.
    amplify : float
        Factor by which a further line shows the asperity pressure, to make it visible; the legend says so.
    amplified : str, optional
        Label, as the dataset's coordinate has it, of the one profile that gets such a line; every one by default.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    at = fields.where(dataset, speed, load)
    drawn = fields.profiles(dataset, at, fields.swept_dimension(dataset))
    further = _amplified(drawn, amplify, amplified)
    with styled():
        figure = new_figure(style.COLUMN, height)
        figure.notes.append(at.sentence)
        pressure, separation = field_panels(figure.subplots(), drawn)
        for index, profile in enumerate(drawn):
            draw_fields(pressure, separation, profile, index)
        for index in further:
            figure.notes.append(_draw_amplified(pressure, drawn[index], index, amplify))
        field_legend(figure, drawn, pressure.handles)
        pressure.axes.set_title(at.title, loc="right")
        return figure


def _amplified(drawn: list[fields.Profile], amplify: float, label: str | None) -> list[int]:
    """Positions of the profiles whose asperity pressure is drawn amplified as well."""
    if amplify == 1.0:
        return []
    if label is None:
        return list(range(len(drawn)))
    positions = [index for index, profile in enumerate(drawn) if profile.label == style.readable(label)]
    if not positions:
        raise ValueError(
            f"no profile is labelled {label!r}; there are {', '.join(profile.label for profile in drawn)}"
        )
    return positions


def _draw_amplified(pressure: Panel, profile: fields.Profile, index: int, amplify: float) -> str:
    """A profile's asperity pressure times a factor, in a colour of its own; returns how far it reaches."""
    suffix = f", {profile.label}" if profile.label else ""
    name = f"asperity pressure × {style.power(amplify)}{suffix}"
    solid = amplify * profile.solid_pressure
    # On two lines, since the legend has two columns.
    label = name.replace(", ", ",\n", 1)
    line = pressure.line(name, profile.x, solid, label, color=AMPLIFIED, **fields.look(index))
    line.set_linewidth(1.0)
    largest = pressure.y.text(float(np.nanmax(solid)))
    return f"{style.plain(name[:1].upper() + name[1:])}, reaches {largest}."


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
    # An amplified pressure may leave the panel; the true ones set its scale.
    top = float(pressure.y.shown(highest))
    pressure.axes.set_ylim(-0.03 * top, 1.08 * top)
    separation.axes.set_ylim(0.0, float(separation.y.shown(film)))
    colour_axis(separation, style.SEPARATION)
    return pressure, separation


def draw_fields(pressure: Panel, separation: Panel, profile: fields.Profile, index: int) -> None:
    """The three fields of one profile, in the colours of the source: blue, green, red."""
    suffix = f", {profile.label}" if profile.label else ""
    look = fields.look(index)
    pressure.line(f"fluid pressure{suffix}", profile.x, profile.fluid_pressure, "", color=style.FLUID, **look)
    pressure.line(
        f"asperity pressure{suffix}", profile.x, profile.solid_pressure, "", color=style.SOLID, **look
    )
    separation.line(f"separation{suffix}", profile.x, profile.separation, "", color=style.SEPARATION, **look)


def field_handles() -> list[Line2D]:
    """What the three colours mean."""
    return [
        Line2D([], [], color=style.FLUID, label="fluid pressure"),
        Line2D([], [], color=style.SOLID, label="asperity pressure"),
        Line2D([], [], color=style.SEPARATION, label="separation"),
    ]


def field_legend(figure: DataFigure, drawn: list[fields.Profile], further: Sequence[Line2D] = ()) -> None:
    """Colours name the fields, line styles the profiles; further lines come last."""
    handles = field_handles()
    for index, profile in enumerate(drawn):
        if profile.label:
            state = "" if profile.converged else " (last iterate)"
            handles.append(
                Line2D([], [], color=style.BLACK, label=profile.label + state, **fields.look(index))
            )
    figure.legend(handles=[*handles, *further], loc="outside lower center", ncols=2)
