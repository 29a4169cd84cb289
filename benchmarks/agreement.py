"""Spectral elements against finite volumes, extrapolated from two grids: two independent solvers on 50 random contacts.

The contacts are those of the study ch3-map's ranges, each at four random speeds.
"""

import numpy as np
import xarray as xr
from measuring import cpu_seconds
from random_scenes import MAP_RANGES, MAP_SPEEDS, Scene, log_uniform, random_scenes
from reference_contact import smallest_separation, total_friction

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.finite_volume.extrapolation import nested_pair, richardson
from softlub.lubrication.solvers.spectral import Spectral

SCENES, SPEEDS_EACH = 50, 4
ORDER = 12
NODES = (257, 513, 1025)
LIMIT = 1e-4
"""Difference of μ that the two solvers are held to."""


def measure() -> xr.Dataset:
    """Differences of μ and u_min between the solvers, for finite volumes extrapolated to several grids."""
    generator = np.random.default_rng(2026)
    scenes = random_scenes(generator, MAP_RANGES, SCENES)
    speeds = np.sort(log_uniform(generator, MAP_SPEEDS, SCENES, SPEEDS_EACH), axis=1)
    found = np.full((4, SCENES, len(NODES), SPEEDS_EACH), np.nan)
    for index, scene in enumerate(scenes):
        found[:, index] = _differences(scene, speeds[index])
    over = ("scene", "nodes", "point")
    dataset = xr.Dataset(
        {
            "difference_friction": (over, found[0]),
            "difference_separation": (over, found[1]),
            "friction_coefficient": (("scene", "point"), found[2, :, 0]),
            "cpu_time": (over, found[3]),
            "speed": (("scene", "point"), speeds),
            **{
                name: ("scene", np.array([getattr(scene, name) for scene in scenes]))
                for name in Scene._fields
            },
        },
        coords={"nodes": list(NODES)},
        attrs={
            "title": "Spectral elements against finite volumes",
            "timed": f"spectral elements of order {ORDER}, finite volumes extrapolated from (N + 1)/2 and N nodes",
        },
    )
    dataset.attrs |= _summary(dataset)
    return dataset


def _differences(scene: Scene, speeds: np.ndarray) -> np.ndarray:
    """Rows: difference of μ, of u_min, μ, CPU time of the finite volumes; over grid and speed."""
    problem, strength = scene.problem(), scene.shear_strength
    spectral = Spectral(order=ORDER).sweep(problem, speeds)
    friction = np.array([total_friction(contact, problem, strength) for contact in spectral])
    separation = np.array([smallest_separation(contact) for contact in spectral])
    result = np.full((4, len(NODES), len(speeds)), np.nan)
    for row, nodes in enumerate(NODES):
        pair = []

        def solve(nodes: int = nodes, pair: list = pair) -> None:
            pair[:] = nested_pair(FiniteVolume(nodes=nodes), problem, speeds)

        seconds = cpu_seconds(solve, 1, warm_up=False)
        levels_friction = [np.array([total_friction(c, problem, strength) for c in level]) for level in pair]
        levels_separation = [np.array([smallest_separation(c) for c in level]) for level in pair]
        result[:, row] = (
            np.abs(richardson(*levels_friction) - friction),
            np.abs(richardson(*levels_separation) / separation - 1),
            friction,
            np.full(len(speeds), seconds),
        )
    return result


def _summary(dataset: xr.Dataset) -> dict[str, float | int]:
    finest = dataset.isel(nodes=-1)
    difference = finest["difference_friction"].values
    return {
        "points": difference.size,
        "failed": int(np.isnan(difference).sum()),
        "above_limit": int((difference > LIMIT).sum()),
        "median_difference_friction": float(np.nanmedian(difference)),
        "largest_difference_friction": float(np.nanmax(difference)),
        "median_difference_separation": float(np.nanmedian(finest["difference_separation"].values)),
        "largest_difference_separation": float(np.nanmax(finest["difference_separation"].values)),
    }


def draw(dataset: xr.Dataset) -> DataFigure:
    """Differences in ascending order, a line a grid."""
    with styled():
        figure = new_figure(style.PAGE, 3.0)
        panels = []
        for axes, name, symbol, letter in zip(
            figure.subplots(1, 2),
            ("friction", "separation"),
            ("μ", r"$u_\mathrm{min}$ (relative)"),
            "ab",
            strict=True,
        ):
            panel = Panel(
                axes,
                quantity("share", label="share of the points", unit="1"),
                quantity(f"difference_{name}", label=f"difference of {symbol}", unit="1"),
                letter,
            )
            panel.letter(letter)
            panel.axes.set_yscale("log")
            for index, nodes in enumerate(dataset["nodes"].values):
                values = np.sort(dataset[f"difference_{name}"].sel({"nodes": nodes}).values.ravel())
                panel.line(
                    f"finite volumes, extrapolated to N = {nodes}",
                    (np.arange(values.size) + 1) / values.size,
                    values,
                    color=style.CYCLE[index],
                )
            panels.append(panel)
        panels[0].line("limit", [0.0, 1.0], [LIMIT, LIMIT], color=style.GREY, linestyle="--")
        share_legend(figure, panels, 2)
        return figure
