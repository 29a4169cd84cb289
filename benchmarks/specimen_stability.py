"""Loading and sliding of the triangular specimen at random inputs: what arrives, what stops and why, what it costs.

Load 1–100 N/m, tip radius 0.05–0.5 mm and C10 over two decades, each even in its logarithm; friction 0–1; Poisson's
ratio up to 0.49995, even in the logarithm of 1 - 2ν. A specimen may well be too soft for its load: then the simulation
must stop with a reason and keep the last good state, and that counts as such, not as a success.
"""

import time
from collections import Counter

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.solid.body import Body
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.plate import PlateContact
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.solid.steps import InContact, Loading, Sliding, run

RUNS = 200
DENSITY = MeshDensity(edge_nodes=257, rows=11, flank_columns=30)
RANGES = {
    "load": (1.0, 100.0),
    "tip_radius": (0.05e-3, 0.5e-3),
    "c10": (0.06e6, 6e6),
    "incompressibility": (1e-4, 0.1),
}
"""The last is 1 - 2ν."""
LARGEST_FRICTION = 1.0
BALANCE = 1e-8
"""Relative error of load and friction above which an accepted state counts as wrong."""


def measure() -> xr.Dataset:
    """One row a random specimen."""
    generator = np.random.default_rng(10)
    rows = [_trial(**_inputs(generator)) for _ in range(RUNS)]
    dataset = xr.Dataset({name: ("trial", np.array([row[name] for row in rows])) for name in rows[0]})
    reasons = Counter(row["reason"] for row in rows if row["reason"])
    return dataset.assign_attrs(
        title="Stability of loading and sliding the triangular specimen",
        timed=f"CPU time of one simulation, {DENSITY.edge_nodes} edge nodes and {DENSITY.rows} rows",
        runs=RUNS,
        converged=int(dataset["converged"].sum()),
        stopped_with_reason=sum(reasons.values()),
        wrong=int(dataset["wrong"].sum()),
        contact_beyond_edge=int(dataset["beyond_edge"].sum()),
        reasons="; ".join(f"{count} × {reason}" for reason, count in reasons.most_common()),
    )


def _inputs(generator: np.random.Generator) -> dict[str, float]:
    inputs = {name: float(np.exp(generator.uniform(*np.log(limits)))) for name, limits in RANGES.items()}
    return inputs | {"friction": float(generator.uniform(0.0, LARGEST_FRICTION))}


def _trial(load: float, tip_radius: float, c10: float, incompressibility: float, friction: float):
    shear_modulus = 2 * c10
    poisson_ratio = (1 - incompressibility) / 2
    bulk_modulus = shear_modulus * 2 * (1 + poisson_ratio) / (3 * incompressibility)
    mesh = TriangularSpecimen(tip_radius=tip_radius).mesh(DENSITY)
    began = time.process_time()
    history = run(
        Body(mesh, NeoHookean(c10=c10, d1=2 / bulk_modulus)),
        PlateContact(),
        [InContact(), Loading(load), Sliding(friction)],
    )
    seconds = time.process_time() - began
    last = history.increments[-1] if history.increments else None
    failure = history.failure
    return {
        "load": load,
        "tip_radius": tip_radius,
        "c10": c10,
        "poisson_ratio": poisson_ratio,
        "friction": friction,
        "converged": history.converged,
        "wrong": history.converged and not _balanced(last, load, friction),
        "beyond_edge": last is not None and last.reaches_edge_end,
        "load_reached": last.load / load if last else 0.0,
        "friction_reached": last.friction if last else 0.0,
        "increments": len(history.increments),
        "rejected": history.rejected,
        "iterations": history.iterations,
        "solver_seconds": seconds,
        "stretch": load / (2 * c10 * tip_radius),
        "reason": _kind(failure.step, failure.reason) if failure else "",
    }


def _balanced(last, load: float, friction: float) -> bool:
    carried, dragged = last.normal.sum(), last.shear.sum()
    return bool(
        np.all(last.normal >= 0)
        and abs(carried / load - 1) <= BALANCE
        and abs(dragged - friction * carried) <= BALANCE * load
    )


def _kind(step: str, reason: str) -> str:
    """The step and the sort of reason, without the numbers that make each one its own."""
    sort = "an element turned inside out" if "inside out" in reason else reason.split("(")[0].strip()
    return f"{step}: {sort}"


def draw(dataset: xr.Dataset) -> DataFigure:
    """Where simulations arrived, over how hard the body is loaded and friction (a); what they cost (b)."""
    severity = quantity("stretch", label=r"load $W/(2C_{10}R)$", unit="1")
    friction = quantity("friction", label="friction coefficient μ", unit="1")
    seconds = quantity("solver_seconds", label="CPU time", unit="s")
    converged = dataset["converged"].values.astype(bool)
    with styled():
        figure = new_figure(style.PAGE, 2.9)
        axes = figure.subplots(1, 2)
        panels = [Panel(axes[0], severity, friction, "a"), Panel(axes[1], severity, seconds, "b")]
        for panel, name in zip(panels, ("friction", "solver_seconds"), strict=True):
            panel.letter(panel.name)
            panel.axes.set_xscale("log")
            for label, chosen, colour, marker in (
                ("arrived", converged, style.BLUE, "o"),
                ("stopped, with its reason", ~converged, style.VERMILION, "x"),
            ):
                panel.line(
                    label,
                    dataset["stretch"].values[chosen],
                    dataset[name].values[chosen],
                    color=colour,
                    marker=marker,
                    linestyle="",
                    markersize=3,
                )
        panels[1].axes.set_yscale("log")
        share_legend(figure, panels, 2)
        return figure
