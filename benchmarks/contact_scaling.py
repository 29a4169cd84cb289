"""One rough contact from cold on larger and larger grids, each in a process of its own: time, convolutions, memory.

The surface's shortest wave spans two points or eight; the load is p/(E*h'rms) = 0.05. The first solve of a process
plans its transforms and loads compiled code, the next one does not; grids from 4096² points on are solved once. Memory
is that of the whole process, the making of the surface included.
"""

import json
import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import xarray as xr

from softlub.contact import solve
from softlub.contact.memory import available_bytes, estimated_bytes
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.surfaces import SelfAffine, synthesize

POINTS = (512, 1024, 2048, 4096, 8192)
POINTS_A_WAVE = (2, 8)
ONCE_FROM = 4096
LOAD = 0.05
SIZE = 4e-4
REPEATS = 3


def measure() -> xr.Dataset:
    """One row a grid and surface; grids that do not fit the memory free now are left out."""
    cases = [
        (points, wave)
        for points in POINTS
        for wave in POINTS_A_WAVE
        if estimated_bytes((points,) * 2, True) < available_bytes()
    ]
    rows = [_in_a_process(points, wave) for points, wave in cases]
    return xr.Dataset(
        {name: ("trial", np.array([row[name] for row in rows])) for name in rows[0]},
        attrs={
            "title": "One rough contact on larger and larger grids",
            "timed": f"CPU time of the solve; later ones the least of {REPEATS}, NaN where there is one only",
        },
    )


def _in_a_process(points: int, wave: int) -> dict[str, float]:
    command = [sys.executable, __file__, str(points), str(wave)]
    done = subprocess.run(command, check=True, cwd=Path(__file__).parent, capture_output=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def _trial(points: int, wave: int) -> dict[str, float]:
    spectrum = SelfAffine(1e-6, 0.8, 2 * np.pi / 1e-4, 2 * np.pi * points / (wave * SIZE), 2 * np.pi / 2e-4)
    surface = synthesize(spectrum, SIZE, points, seed=1)
    pressure = LOAD * spectrum.rms_slope
    seconds = []
    for _ in range(1 if points >= ONCE_FROM else 1 + REPEATS):
        began = time.process_time()
        found = solve(surface, 1.0, pressure)
        seconds.append(time.process_time() - began)
    return {
        "points": points,
        "points_a_wave": wave,
        "first_seconds": seconds[0],
        "later_seconds": min(seconds[1:], default=float("nan")),
        "convolutions": float(found.convolutions),
        "converged": bool(found.converged),
        "peak_memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024.0,
    }


def draw(dataset: xr.Dataset) -> DataFigure:
    """CPU time (a), convolutions (b) and memory (c) over the grid."""
    points = quantity("points", label="points a side $N$", unit="1")
    quantities = {
        "first_seconds": quantity("first_seconds", label="CPU time", unit="s"),
        "convolutions": quantity("convolutions", label="convolutions", unit="1"),
        "peak_memory": quantity(
            "peak_memory", dataset["peak_memory"].values, label="memory of the process", unit="B"
        ),
    }
    with styled():
        figure = new_figure(style.PAGE, 2.7)
        axes = figure.subplots(1, 3)
        panels = [
            Panel(axis, points, shown, letter)
            for axis, shown, letter in zip(axes, quantities.values(), "abc", strict=True)
        ]
        for panel, name in zip(panels, quantities, strict=True):
            panel.letter(panel.name)
            panel.axes.set_xscale("log", base=2)
            panel.axes.set_yscale("log" if name == "first_seconds" else "linear")
            _draw(panel, dataset, name)
        for panel in panels[1:]:
            panel.axes.set_ylim(bottom=0)
        share_legend(figure, panels, 2)
        return figure


def _draw(panel: Panel, dataset: xr.Dataset, name: str) -> None:
    looks = ((style.BLUE, "o"), (style.VERMILION, "s"))
    for (colour, marker), wave in zip(looks, POINTS_A_WAVE, strict=True):
        own = dataset.isel(trial=dataset["points_a_wave"].values == wave)
        label = f"shortest wave of {wave} points"
        if name != "first_seconds":
            panel.line(label, own["points"].values, own[name].values, color=colour, marker=marker)
            continue
        first, later = own["first_seconds"].values, own["later_seconds"].values
        panel.line(
            f"{label}, first solve", own["points"].values, first, color=colour, marker=marker, linestyle=":"
        )
        panel.line(label, own["points"].values, later, color=colour, marker=marker)


if __name__ == "__main__":
    print(json.dumps(_trial(int(sys.argv[1]), int(sys.argv[2]))))
