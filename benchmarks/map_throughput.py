"""CPU time of a curve of the study ch3-map, as its panel computes it: law, 13 speeds, error estimates, observables.

Split into the solver, the finer one's correction that estimates its error, and the rest: laws, observables, stacking.
"""

import time
from collections.abc import Sequence

import numpy as np
import xarray as xr
from random_scenes import MAP_RANGES, MAP_SPEEDS, random_scenes

from softlub.datasets.variables import FLAGS
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.auto import Auto
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.spectral import Spectral
from softlub.lubrication.speed_sweep import sweep_arrays
from softlub.study.accuracy import PRESETS

CURVES = 256
SPEEDS = np.geomspace(*MAP_SPEEDS, 13)
MAP_CURVES = 10_000
DRAFT = PRESETS["draft"]
"""The accuracy that the study asks for."""
INACCURATE = sum(bit for name, bit in FLAGS.items() if name.startswith("inaccurate"))
PARTS = ("solver", "error estimate", "observables and law")


class Timed:
    """A solver that adds up its CPU time."""

    def __init__(self, solver: Auto) -> None:
        self.solver = solver
        self.seconds = 0.0

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        began = time.process_time()
        contacts = self.solver.sweep(problem, speeds)
        self.seconds += time.process_time() - began
        return contacts

    def correct(self, problem: Problem, contacts: Sequence[LubricatedContact]) -> list[LubricatedContact]:
        began = time.process_time()
        corrected = self.solver.correct(problem, contacts)
        self.seconds += time.process_time() - began
        return corrected


def measure() -> xr.Dataset:
    """CPU time of every curve by parts."""
    scenes = random_scenes(np.random.default_rng(3), MAP_RANGES, CURVES + 1)
    chosen = Auto(Spectral(DRAFT.spectral_order), FiniteVolume(DRAFT.finite_volume_nodes))
    rows, flags = [], []
    for scene in scenes:
        solver, finer = Timed(chosen), Timed(chosen.refined())
        began = time.process_time()
        arrays = sweep_arrays(scene.problem(), [scene.load], SPEEDS.tolist(), solver, finer)
        whole = time.process_time() - began
        rows.append((solver.seconds, finer.seconds, whole - solver.seconds - finer.seconds))
        flags.append(arrays["flags"][0])
    # The first curve loads compiled code.
    seconds, flags = np.array(rows[1:]), np.array(flags[1:])
    mean = float(seconds.sum(axis=1).mean())
    return xr.Dataset(
        {"cpu_time": (("curve", "part"), seconds), "flags": (("curve", "speed"), flags)},
        coords={"part": list(PARTS), "speed": SPEEDS},
        attrs={
            "title": "CPU time of a curve of ch3-map",
            "timed": f"{CURVES} random curves of 13 speeds, with error estimates, one process",
            "milliseconds_per_curve": 1e3 * mean,
            **{
                f"milliseconds_{part.replace(' ', '_')}": 1e3 * float(value)
                for part, value in zip(PARTS, seconds.mean(axis=0), strict=True)
            },
            "minutes_of_ch3_map_on_two_cores": MAP_CURVES * mean / 2 / 60,
            "not_converged": int(((flags & FLAGS["not_converged"]) > 0).sum()),
            "inaccurate": int(((flags & INACCURATE) > 0).sum()),
            "points": flags.size,
        },
    )


def draw(dataset: xr.Dataset) -> DataFigure:
    """Sorted CPU times of the curves, a line a part."""
    with styled():
        figure = new_figure(style.COLUMN, 2.6)
        panel = Panel(
            figure.subplots(),
            quantity("share", label="share of the curves", unit="1"),
            quantity("cpu_time", dataset["cpu_time"].values, label="CPU time", unit="s"),
        )
        panel.axes.set_yscale("log")
        share = (np.arange(dataset.sizes["curve"]) + 1) / dataset.sizes["curve"]
        for index, part in enumerate(dataset["part"].values):
            values = np.sort(dataset["cpu_time"].sel({"part": part}).values)
            panel.line(part, share, values, color=style.CYCLE[index], linestyle=style.LINE_STYLES[index])
        panel.legend()
        return figure
