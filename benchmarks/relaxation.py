"""What the modules' relaxation factors do: sweeps to convergence, with the source's plain relaxation and accelerated.

Three questions that the source answers in words: which factors the inner loop of the full-film module bears; whether
the boundary-mixed module converges better with α_f < α_u < α_s; how many sweeps the mixed module may need.
"""

from collections.abc import Callable, Iterator
from itertools import permutations

import numpy as np
import xarray as xr
from reference_contact import SOURCE_HALF_DOMAIN, table_3_1

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.bml import BML
from softlub.lubrication.solvers.ehl import EHL
from softlub.lubrication.solvers.mehl import MEHL
from softlub.lubrication.solvers.modules.relaxation import BoundaryFactors, FilmFactors, MixedFactors

NODES = 257
SECONDS = 20.0
"""CPU time after which a point is given up: far more than 20,000 sweeps take [s]."""
MEMORIES = {"plain relaxation": 0, "accelerated": 20}
FILM_FACTORS = (0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0)
FILM_SPEEDS = (0.12, 10.0)
MIXED_FLUID_FACTORS = (0.03, 0.1, 0.3, 1.0)
MIXED_SPEEDS = (1.5e-3, 0.03)
BOUNDARY_VALUES = (0.02, 0.06, 0.5)
"""Within the ranges of table 3-2, given to α_f, α_u and α_s in every order."""
BOUNDARY_SPEEDS = (1e-5, 3e-5)

Task = tuple[str, str, float, str, str, Callable[[], LubricatedContact]]


def measure() -> xr.Dataset:
    """One row a combination of module, factors, speed and variant."""
    rows = []
    for module, factors, varied, order, variant, solve in _tasks():
        contact = solve()
        rows.append(
            {
                "module": module,
                "factors": factors,
                "varied_factor": varied,
                "order": order,
                "variant": variant,
                "speed": contact.speed,
                "converged": contact.converged,
                "iterations": contact.iterations,
                "residual": contact.residual,
                "solver_seconds": contact.seconds,
            }
        )
    return xr.Dataset(
        {name: ("trial", np.array([row[name] for row in rows])) for name in rows[0]},
        attrs={
            "title": "Relaxation factors of the source's modules",
            "timed": f"one point from cold on {NODES} even nodes over 1 mm, at most 20,000 sweeps or {SECONDS:g} s",
        },
    )


def _tasks() -> Iterator[Task]:
    problem = table_3_1(SOURCE_HALF_DOMAIN)
    for variant, memory in MEMORIES.items():
        settings = {"nodes": NODES, "memory": memory, "seconds": SECONDS}
        for speed in FILM_SPEEDS:
            for value in FILM_FACTORS:
                film = EHL(relaxation=FilmFactors(value, 0.1), **settings)
                yield "EHL", f"α_l = {value}", value, "", variant, _point(film, problem.at(speed=speed))
        for speed in MIXED_SPEEDS:
            for value in MIXED_FLUID_FACTORS:
                mixed = MEHL(relaxation=MixedFactors(value, 0.6, 0.5), **settings)
                yield "MEHL", f"α_f = {value}", value, "", variant, _point(mixed, problem.at(speed=speed))
        for speed in BOUNDARY_SPEEDS:
            for values in permutations(BOUNDARY_VALUES):
                boundary = BML(relaxation=BoundaryFactors(*values), **settings)
                order = " < ".join(name for _, name in sorted(zip(values, ("f", "u", "s"), strict=True)))
                yield "BML", str(values), values[0], order, variant, _point(boundary, problem.at(speed=speed))


def _point(module, problem) -> Callable[[], LubricatedContact]:
    return lambda: module.solve(problem)


def draw(dataset: xr.Dataset) -> DataFigure:
    """Sweeps over the factor for EHL (a) and MEHL (b), and over the order of the factors for BML (c)."""
    with styled():
        figure = new_figure(style.PAGE, 3.4)
        axes = figure.subplots(1, 3)
        panels = [
            _over_factor(axes[0], dataset, "EHL", r"$\alpha_l$", "a"),
            _over_factor(axes[1], dataset, "MEHL", r"$\alpha_f$", "b"),
            _over_order(axes[2], dataset),
        ]
        share_legend(figure, panels, 3)
        return figure


def _series(dataset: xr.Dataset, module: str) -> Iterator[tuple[int, str, xr.Dataset]]:
    """Index, name and trials of every speed and variant of a module."""
    own = dataset.isel(trial=dataset["module"].values == module)
    for variant in MEMORIES:
        for index, speed in enumerate(np.unique(own["speed"].values)):
            chosen = (own["variant"].values == variant) & (own["speed"].values == speed)
            yield index, f"{style.power(speed)} m/s, {variant}", own.isel(trial=chosen)


def _draw(panel: Panel, dataset: xr.Dataset, module: str, place: Callable[[xr.Dataset], np.ndarray]) -> None:
    panel.axes.set_ylim(10, 30_000)
    for index, name, trials in _series(dataset, module):
        good, plain = trials["converged"].values.astype(bool), "plain" in name
        colour = style.CYCLE[(index + ["EHL", "MEHL", "BML"].index(module) * 3) % len(style.CYCLE)]
        panel.line(
            f"{module} at {name}",
            place(trials),
            np.where(good, trials["iterations"].values, np.nan),
            color=colour,
            marker=style.MARKERS[index],
            linestyle=":" if plain else "-",
            markerfacecolor="none" if plain else colour,
        )
        panel.mark_failed(place(trials)[~good], colour, index)


def _over_factor(axes, dataset: xr.Dataset, module: str, symbol: str, letter: str) -> Panel:
    panel = Panel(axes, quantity("factor", label=symbol, unit="1"), _sweeps(), letter)
    panel.letter(letter)
    panel.axes.set_yscale("log")
    if module == "MEHL":
        panel.axes.set_xscale("log")
    _draw(panel, dataset, module, lambda trials: trials["varied_factor"].values)
    return panel


def _over_order(axes, dataset: xr.Dataset) -> Panel:
    panel = Panel(axes, quantity("order", label="order of the factors", unit="1"), _sweeps(), "c")
    panel.letter("c")
    panel.axes.set_yscale("log")
    own = dataset.isel(trial=dataset["module"].values == "BML")
    orders = list(dict.fromkeys(own["order"].values))
    _draw(
        panel,
        dataset,
        "BML",
        lambda trials: np.array([orders.index(order) for order in trials["order"].values]),
    )
    panel.axes.set_xticks(range(len(orders)), orders, rotation=90)
    panel.axes.set_xlabel(r"order of $\alpha$")
    return panel


def _sweeps():
    return quantity("iterations", label="sweeps", unit="1")
