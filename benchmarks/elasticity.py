"""One Newton step of the finite volumes: dense elimination against fast transforms with GMRES.

On the source's domain with even nodes, at three speeds from boundary to full film; the step is the one that Newton's
method takes first from the solution at a speed lower by a tenth.
"""

from functools import partial

import numpy as np
import xarray as xr
from measuring import cpu_seconds
from reference_contact import SOURCE_HALF_DOMAIN, table_3_1

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity
from softlub.lubrication.half_space import HalfSpaceFFT
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.finite_volume.dense import Elimination
from softlub.lubrication.solvers.finite_volume.equations import Linearisation, linearise
from softlub.lubrication.solvers.finite_volume.level import Level, state_of
from softlub.lubrication.solvers.finite_volume.transform import Transforms

NODES = (257, 513, 1025, 2049, 4097)
SPEEDS = (1e-3, 0.03, 0.3)
METHODS = ("dense elimination", "transforms and GMRES")


def measure() -> xr.Dataset:
    """CPU time of a step, and how far the step by transforms is from the dense one."""
    table = np.full((3, len(METHODS), len(SPEEDS), len(NODES)), np.nan)
    for column, nodes in enumerate(NODES):
        for row, speed in enumerate(SPEEDS):
            table[:, :, row, column] = _step(nodes, speed)
    over = ("method", "speed", "nodes")
    dataset = xr.Dataset(
        {
            name: (over, values)
            for name, values in zip(("cpu_time", "difference", "products"), table, strict=True)
        },
        coords={"method": list(METHODS), "speed": list(SPEEDS), "nodes": list(NODES)},
        attrs={
            "title": "One Newton step, dense or by transforms",
            "timed": "assembly and solution of one Newton step of the finite volumes, even grid, domain of 1 mm",
        },
    )
    dataset["cpu_time"].attrs = {"units": "s", "long_name": "CPU time of one Newton step"}
    dataset["difference"].attrs = {
        "units": "1",
        "long_name": "difference to the dense step over its largest entry",
    }
    dataset["products"].attrs = {"units": "1", "long_name": "products with the Jacobian"}
    return dataset


def _step(nodes: int, speed: float) -> np.ndarray:
    level, equations = _linearised(nodes, speed)
    dense, transforms = Elimination(level.contact.space.matrix()), Transforms(level.contact.space)
    exact = dense(level.contact, equations)[0]
    counting = CountingSpace(level.contact.space)
    found = Transforms(counting)(level.contact, equations)[0]
    repeats = 3 if nodes < 2000 else 2
    times = [
        cpu_seconds(partial(solver, level.contact, equations), repeats, warm_up=False)
        for solver in (dense, transforms)
    ]
    difference = float(np.max(np.abs(found - exact)) / np.max(np.abs(exact)))
    return np.array([times, [0.0, difference], [np.nan, counting.products]])


def _linearised(nodes: int, speed: float) -> tuple[Level, Linearisation]:
    """Equations at a speed, about the solution at 0.9 times that speed."""
    problem = table_3_1(SOURCE_HALF_DOMAIN).at(speed=0.9 * speed)
    solver = FiniteVolume(nodes=nodes, grid="even")
    level = solver.level(problem, nodes)
    solution = solver.solve(problem)
    if not solution.converged:
        raise RuntimeError(f"no solution on {nodes} nodes at {problem.speed:g} m/s to linearise about")
    state = state_of(level, problem, solution)
    gap = level.contact.gap(state.pressure, state.approach)
    return level, linearise(level.contact, problem.at(speed=speed).speed_number, state, gap)


class CountingSpace:
    """A half-space that counts its products with pressures."""

    def __init__(self, space: HalfSpaceFFT) -> None:
        self._space = space
        self.products = 0

    def __getattr__(self, name: str):
        return getattr(self._space, name)

    def deflection(self, pressure: np.ndarray) -> np.ndarray:
        self.products += 1
        return self._space.deflection(pressure)


def draw(dataset: xr.Dataset) -> DataFigure:
    """CPU time over the number of nodes: dense elimination at one speed, transforms at each."""
    with styled():
        figure = new_figure(style.COLUMN, 3.0)
        panel = Panel(
            figure.subplots(),
            quantity("nodes", label="nodes N", unit="1"),
            quantity("cpu_time", label="CPU time of one Newton step", unit="s"),
        )
        panel.axes.set(xscale="log", yscale="log")
        times, nodes = dataset["cpu_time"], dataset["nodes"].values
        panel.line(
            METHODS[0],
            nodes,
            times.sel({"method": METHODS[0]}).mean("speed"),
            color=style.BLACK,
            marker="s",
        )
        for index, speed in enumerate(dataset["speed"].values):
            panel.line(
                f"{METHODS[1]}, {speed:g} m/s",
                nodes,
                times.sel({"method": METHODS[1], "speed": speed}),
                color=style.CYCLE[index],
                marker=style.MARKERS[index],
            )
        panel.axes.set_xticks(nodes, [str(count) for count in nodes], minor=False)
        panel.axes.minorticks_off()
        panel.legend()
        return figure
