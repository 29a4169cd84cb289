"""The stress test as a whole: its counts, the estimated error against the true one, a study file for every failure."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import xarray as xr
import yaml
from random_scenes import Scene
from stress_chunk import KINDS

from softlub.datasets.variables import FLAGS
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.lubrication.speed_sweep import FRICTION_ERROR_LIMIT, SEPARATION_ERROR_LIMIT

INACCURATE = sum(bit for name, bit in FLAGS.items() if name.startswith("inaccurate"))
SMALLEST_SHOWN = 1e-14
"""Errors below this are drawn at it."""


def measure(parts: Sequence[xr.Dataset]) -> xr.Dataset:
    """All chunks in one, with a verdict a point and the counts as attributes."""
    dataset = xr.concat(parts, dim="point", combine_attrs="drop")
    flags = dataset["flags"].values
    failed = (flags & FLAGS["not_converged"]) > 0
    inaccurate = (flags & INACCURATE) > 0
    values = np.stack(
        [dataset[name].values for name in ("friction_coefficient", "separation_min", "error_friction")]
    )
    nan = ~np.isfinite(values).all(axis=0)
    wrong = (dataset["true_error_friction"].values > FRICTION_ERROR_LIMIT) | (
        dataset["true_error_separation"].values > SEPARATION_ERROR_LIMIT
    )
    dataset["not_a_number_unflagged"] = "point", nan & ~failed & ~inaccurate
    dataset["silently_wrong"] = "point", wrong & ~failed & ~inaccurate
    dataset["failed"] = "point", failed
    dataset.attrs = {"title": "Stress test: random contacts", "timed": "all chunks of stress_chunk together"}
    dataset.attrs |= counts(dataset)
    print("\n".join(f"{name}: {value}" for name, value in dataset.attrs.items()))
    return dataset


def counts(dataset: xr.Dataset) -> dict[str, float | int | str]:
    """What became of the points of the default solver, and of those of the finite volumes."""
    ours = dataset.isel(point=dataset["kind"].values != KINDS[-1])
    checked = np.isfinite(ours["true_error_friction"].values)
    result: dict[str, float | int | str] = {
        "points": ours.sizes["point"],
        "converged": int((~ours["failed"].values).sum()),
        "converged_percent": round(100 * float((~ours["failed"].values).mean()), 4),
        "by_finite_volumes": int((ours["solver"].values == "finite_volume").sum()),
        "checked": int(checked.sum()),
        "flagged_inaccurate": int(((ours["flags"].values & INACCURATE) > 0).sum()),
        "silently_wrong": int(ours["silently_wrong"].values.sum()),
        "not_a_number_unflagged": int(ours["not_a_number_unflagged"].values.sum()),
        "largest_load_error_converged": float(ours["load_error"].values[~ours["failed"].values].max()),
        "cpu_seconds": round(float(ours["solver_seconds"].sum()), 1),
    }
    result |= {f"flag_{name}": int(((ours["flags"].values & bit) > 0).sum()) for name, bit in FLAGS.items()}
    for quantity_name in ("friction", "separation"):
        true = ours[f"true_error_{quantity_name}"].values[checked]
        estimated = ours[f"error_{quantity_name}"].values[checked]
        result[f"true_error_{quantity_name}_50_90_99_100"] = " ".join(
            f"{value:.1e}" for value in np.percentile(true, [50, 90, 99, 100])
        )
        result[f"estimate_too_small_10_fold_{quantity_name}_percent"] = round(
            100 * float(np.mean(true > np.maximum(10 * estimated, 1e-9))), 3
        )
    for kind in KINDS:
        chosen = dataset["kind"].values == kind
        result[f"{kind}"] = (
            f"{int((~dataset['failed'].values[chosen]).sum())} of {int(chosen.sum())} converged"
        )
    return result


def write_failures(dataset: xr.Dataset, folder: Path) -> None:
    """A study file for every point of the default solver that failed or was silently wrong, its reason in `about`."""
    folder.mkdir(parents=True, exist_ok=True)
    for reason in ("failed", "silently_wrong", "not_a_number_unflagged"):
        for index in np.flatnonzero(dataset[reason].values & (dataset["kind"].values != KINDS[-1])):
            row = {name: dataset[name].values[index].item() for name in (*Scene._fields, "speed", "kind")}
            scene = Scene(*(row[name] for name in Scene._fields))
            study = scene.study(f"Stress test, point {index}: {reason}", row["speed"])
            study["about"] = f"{reason.replace('_', ' ')}, {row['kind']}"
            (folder / f"stress-{index}.yaml").write_text(yaml.safe_dump(study, sort_keys=False))


def draw(dataset: xr.Dataset) -> DataFigure:
    """Estimated error over true error of every checked point, one mark a point, the diagonal beside."""
    with styled():
        figure = new_figure(style.PAGE, 3.2)
        axes = figure.subplots(1, 2)
        panels = [
            _panel(axis, dataset, name, symbol, letter)
            for axis, name, symbol, letter in zip(
                axes, ("friction", "separation"), ("μ", r"$u_\mathrm{min}$ (relative)"), "ab", strict=True
            )
        ]
        share_legend(figure, panels, 4)
        return figure


def _panel(axes, dataset: xr.Dataset, name: str, symbol: str, letter: str) -> Panel:
    panel = Panel(
        axes,
        quantity(f"true_error_{name}", label=f"true error of {symbol}", unit="1"),
        quantity(f"error_{name}", label=f"estimated error of {symbol}", unit="1"),
        letter,
    )
    panel.letter(letter)
    panel.axes.set(xscale="log", yscale="log")
    ours = dataset.isel(point=dataset["kind"].values != KINDS[-1])
    true, estimated = (ours[f"{prefix}error_{name}"].values for prefix in ("true_", ""))
    known = np.isfinite(true) & np.isfinite(estimated)
    flagged = (ours["flags"].values & INACCURATE) > 0
    for label, chosen, colour in (
        ("converged", known & ~flagged, style.BLUE),
        ("flagged inaccurate", known & flagged, style.VERMILION),
    ):
        panel.line(
            label,
            np.maximum(true[chosen], SMALLEST_SHOWN),
            np.maximum(estimated[chosen], SMALLEST_SHOWN),
            color=colour,
            marker="o",
            markersize=1.5,
            linestyle="none",
            alpha=0.5,
        )
    largest = max(np.max(true[known], initial=1e-6), np.max(estimated[known], initial=1e-6))
    ends = np.array([SMALLEST_SHOWN, 3 * largest])
    panel.line("estimate = truth", ends, ends, color=style.GREY, linestyle="--", linewidth=0.8)
    return panel
