"""The source's three modules against Newton's method on the same nodes: sweeps, CPU time, errors, failures.

On the source's domain (±1 mm), each module over its speeds and somewhat beyond, once accelerated (Anderson's method,
the default) and once with the plain relaxation of the source. Newton's method of the finite volumes solves the same
discrete equations on the same nodes; for the full-film module, which knows no asperities, without the law.
"""

from dataclasses import replace

import numpy as np
import xarray as xr
from measuring import cpu_seconds
from reference_contact import SOURCE_HALF_DOMAIN, friction_of, table_3_1

from softlub.contact.laws.none import NoContact
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.lubrication.problem import Problem
from softlub.lubrication.solvers.bml import BML
from softlub.lubrication.solvers.ehl import EHL
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.mehl import MEHL

NODES = (257, 1025)
SPEEDS = (1e-5, 1e-4, 1.5e-3, 5e-3, 0.03, 0.12, 0.5, 1.0, 3.0)
PLAIN_NODES = 257
"""Plain relaxation is tried on this grid, where 20,000 sweeps take some seconds."""
PLAIN_SECONDS = 5.0
"""CPU time after which a point with plain relaxation is given up [s]."""
MODULES = {
    "BML": (BML(), 0.0, 0.03),
    "MEHL, Gauss–Seidel": (MEHL("gauss_seidel"), 1e-4, 1.0),
    "MEHL, Newton–Raphson": (MEHL("newton_raphson"), 1e-4, 1.0),
    "EHL": (EHL(), 0.03, 10.0),
}
"""Module and the speeds between which it is tried: its own range, and beyond it until it fails."""
VARIANTS = ("accelerated", "plain relaxation")
MEASURED = ("converged", "sweeps", "residual", "cpu_time", "error_friction", "error_separation")


def measure() -> xr.Dataset:
    """Every module at every speed of its range; NaN where it was not tried."""
    table = np.full((len(MEASURED), len(MODULES) + 1, len(VARIANTS), len(NODES), len(SPEEDS)), np.nan)
    for column, nodes in enumerate(NODES):
        for row, speed in enumerate(SPEEDS):
            table[:, :, :, column, row] = _point(nodes, speed)
    over = ("module", "variant", "nodes", "speed")
    dataset = xr.Dataset(
        {name: (over, values) for name, values in zip(MEASURED, table, strict=True)},
        coords={
            "module": [*MODULES, "Newton"],
            "variant": list(VARIANTS),
            "nodes": list(NODES),
            "speed": list(SPEEDS),
        },
        attrs={
            "title": "The source's modules against Newton's method on the same nodes",
            "timed": "one point from cold, its way through lower speeds included; tolerance 1e-4 of the true residual; "
            f"given up after 20,000 sweeps, 30 s, or {PLAIN_SECONDS:g} s with plain relaxation",
        },
    )
    dataset["converged"] = dataset["converged"] == 1
    modules = dataset.sel({"module": list(MODULES)})
    for variant in VARIANTS:
        of_variant = modules.sel({"variant": variant})
        dataset.attrs[f"converged_{variant.split()[0]}"] = (
            f"{int(of_variant['converged'].sum())} of {int(_tried(of_variant).sum())}"
        )
    converged = modules["error_friction"].values[modules["converged"].values]
    dataset.attrs["largest_error_friction_converged"] = float(np.max(np.abs(converged)))
    return dataset


def _tried(dataset: xr.Dataset) -> np.ndarray:
    """Which points were tried: a diverged one has an infinite residual, one that was not tried has none."""
    return ~np.isnan(dataset["residual"].values)


def _point(nodes: int, speed: float) -> np.ndarray:
    """All modules, and Newton's method last, at one speed; shape (measured, modules + 1, variants)."""
    problem = table_3_1(SOURCE_HALF_DOMAIN).at(speed=speed)
    newton = FiniteVolume(nodes=nodes, grid="even")
    result = np.full((len(MEASURED), len(MODULES) + 1, len(VARIANTS)), np.nan)
    exact = newton.solve(problem)
    seconds = cpu_seconds(lambda: newton.solve(problem), 1, warm_up=False)
    result[:, -1, 0] = exact.converged, exact.iterations, exact.residual, seconds, 0.0, 0.0
    for row, (module, lowest, highest) in enumerate(MODULES.values()):
        if not lowest <= speed <= highest:
            continue
        own = replace(problem, law=NoContact()) if isinstance(module, EHL) else problem
        target = newton.solve(own) if isinstance(module, EHL) else exact
        result[:, row, 0] = _compared(replace(module, nodes=nodes), own, target)
        if nodes == PLAIN_NODES:
            plain = replace(module, nodes=nodes, memory=0, seconds=PLAIN_SECONDS)
            result[:, row, 1] = _compared(plain, own, target)
    return result


def _compared(module: BML | MEHL | EHL, problem: Problem, target) -> tuple[float, ...]:
    contact = module.solve(problem)
    # The last iterate of a point that failed is compared too: the error shows how far from the solution it stopped.
    return (
        float(contact.converged),
        contact.iterations,
        contact.residual,
        contact.seconds,
        friction_of(contact, problem) - friction_of(target, problem),
        contact.separation_min / target.separation_min - 1,
    )


def draw(dataset: xr.Dataset) -> DataFigure:
    """Sweeps, CPU time and error of μ over speed on the grid of all variants; crosses where a module failed."""
    drawn = dataset.sel({"nodes": PLAIN_NODES})
    shown = (
        ("sweeps", quantity("sweeps", label="sweeps (Newton: steps)", unit="1")),
        ("cpu_time", quantity("cpu_time", label="CPU time", unit="s")),
        ("error_friction", quantity("error_friction", label="error of μ", unit="1")),
    )
    with styled():
        figure = new_figure(style.PAGE, 3.4)
        panels = []
        for axes, (name, axis), letter in zip(figure.subplots(1, 3), shown, "abc", strict=True):
            panel = Panel(axes, quantity("speed"), axis, letter)
            panel.letter(letter)
            panel.axes.set(xscale="log", yscale="log")
            for index, module in enumerate(drawn["module"].values):
                if module == "Newton" and name == "error_friction":
                    continue
                _lines(panel, drawn.sel({"module": module}), name, index)
            if name == "sweeps":
                panel.axes.set_ylim(bottom=0.05)
            panels.append(panel)
        share_legend(figure, panels, 3)
        return figure


def _lines(panel: Panel, of_module: xr.Dataset, name: str, index: int) -> None:
    """Both variants of a module: a full line, and a dotted one with open marks."""
    speeds = of_module["speed"].values
    for variant, look in zip(VARIANTS, ({}, {"linestyle": ":", "markerfacecolor": "none"}), strict=True):
        chosen = of_module.sel({"variant": variant})
        tried = _tried(chosen)
        if not tried.any():
            continue
        good = chosen["converged"].values
        label = str(of_module["module"].values) + ("" if variant == VARIANTS[0] else ", plain")
        panel.line(
            label,
            speeds[tried],
            np.where(good, np.abs(chosen[name].values), np.nan)[tried],
            color=style.CYCLE[index],
            marker=style.MARKERS[index],
            **look,
        )
        if name == "sweeps":
            panel.mark_failed(speeds[tried & ~good], style.CYCLE[index], index)
