"""From a fresh process to one Stribeck curve: imports, compiled code from its cache, law, 40 speeds, friction."""

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity

REPEATS = 7
STAGES = {
    "interpreter": "",
    "numpy": "import numpy",
    "numba": "import numba",
    "contact and solver": "from reference_contact import *; from softlub.lubrication.solvers.auto import Auto",
    "one curve": (
        "from reference_contact import *; from softlub.lubrication.solvers.auto import Auto\n"
        "problem = table_3_1(); contacts = Auto().sweep(problem, SPEEDS)\n"
        "assert all(contact.converged for contact in contacts); friction_curve(contacts, problem)"
    ),
    "one curve as a dataset": (
        "from reference_contact import *; from softlub.lubrication import sweep\n"
        "dataset = sweep(table_3_1(), [100.0], SPEEDS); assert dataset['converged'].all()"
    ),
}
"""What a process does, each more than the one before; the last also estimates the errors, and needs xarray."""


def measure() -> xr.Dataset:
    """Wall and CPU time of fresh processes, the quickest of several each."""
    _process(STAGES["one curve as a dataset"])  # compiles, where the cache is empty
    times = np.array([[_process(code) for _ in range(REPEATS)] for code in STAGES.values()]).min(axis=1)
    dataset = xr.Dataset(
        {"wall_time": ("stage", times[:, 0]), "cpu_time": ("stage", times[:, 1])},
        coords={"stage": list(STAGES)},
        attrs={
            "title": "From a fresh process to one curve",
            "timed": f"quickest of {REPEATS} processes; compiled code in its cache",
        },
    )
    for name, long_name in (("wall_time", "wall time"), ("cpu_time", "CPU time")):
        dataset[name].attrs = {"units": "s", "long_name": long_name}
    return dataset


def _process(code: str) -> tuple[float, float]:
    """Wall and CPU time of one process [s]."""
    before, began = _children_cpu(), time.perf_counter()
    subprocess.run([sys.executable, "-c", code], check=True, cwd=Path(__file__).parent)
    return time.perf_counter() - began, _children_cpu() - before


def _children_cpu() -> float:
    import resource

    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def draw(dataset: xr.Dataset) -> DataFigure:
    """Two marks a stage."""
    with styled():
        figure = new_figure(style.COLUMN, 2.6)
        panel = Panel(
            figure.subplots(),
            quantity("stage", label="process", unit="1"),
            quantity("time", label="time", unit="s"),
        )
        places = np.arange(dataset.sizes["stage"])
        for name, marker, colour in (("wall_time", "s", style.BLUE), ("cpu_time", "o", style.VERMILION)):
            panel.line(
                dataset[name].attrs["long_name"],
                places,
                dataset[name].values,
                color=colour,
                marker=marker,
                linestyle="none",
            )
        panel.axes.set_xticks(places, list(dataset["stage"].values), rotation=30, ha="right")
        panel.axes.set_xlabel("")
        panel.axes.set_ylim(bottom=0)
        panel.legend()
        return figure
