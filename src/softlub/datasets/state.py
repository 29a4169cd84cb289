"""What a dataset tells of its points, in sentences: how many converged, and what is known against the others."""

from __future__ import annotations

from functools import reduce
from operator import or_

import xarray as xr

from softlub.datasets.variables import FLAG_EXPLANATIONS, FLAGS


def convergence(dataset: xr.Dataset) -> str:
    """How many of the points asked for converged, by solver where there are several; bodies by their steps.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study; one without points gives an empty text.

    Returns
    -------
    str
    """
    if "converged" not in dataset:
        return ""
    if "stop_reason" in dataset:
        return _state_of_bodies(dataset)
    asked, failed = _asked(dataset), _failed(dataset)
    if not bool(asked.any()):
        return ""
    if not bool(failed.any()):
        return f"All {int(asked.sum())} points converged."
    counts = f"{int(failed.sum())} of {int(asked.sum())} points did not converge"
    if "solver" in dataset.dims:
        each = [
            f"{label}: {int(failed.isel(solver=i).sum())} of {int(asked.isel(solver=i).sum())}"
            for i, label in enumerate(dataset["solver"].values)
        ]
        counts += f" ({'; '.join(each)})"
    return f"{counts}."


def failures(dataset: xr.Dataset) -> int:
    """Number of points asked for that did not converge, or of bodies that did not get to the end of their steps."""
    return int(_failed(dataset).sum()) if "converged" in dataset else 0


def flagged(dataset: xr.Dataset) -> str:
    """How many of the converged points carry which flag, and at which speeds; empty where none does."""
    raised = _raised(dataset)
    if not raised:
        return ""
    counts = ", ".join(f"{name} {int(where.sum())}{_speeds(where)}" for name, where in raised.items())
    some = reduce(or_, raised.values())
    converged = int(dataset["converged"].astype(bool).sum())
    return f"{int(some.sum())} of {converged} converged points are flagged: {counts}."


def flag_meanings(dataset: xr.Dataset) -> str:
    """What each flag that a converged point carries means; empty where none does."""
    return " ".join(f"{name}: {FLAG_EXPLANATIONS[name]}." for name in _raised(dataset))


def _asked(dataset: xr.Dataset) -> xr.DataArray:
    """Where a solver was asked for a point."""
    if "flags" not in dataset:
        return xr.ones_like(dataset["converged"], dtype=bool)
    return (dataset["flags"].astype(int) & FLAGS["not_attempted"]) == 0


def _failed(dataset: xr.Dataset) -> xr.DataArray:
    return _asked(dataset) & ~dataset["converged"].astype(bool)


def _raised(dataset: xr.Dataset) -> dict[str, xr.DataArray]:
    """The converged points that carry each flag, of those flags that any point carries."""
    if "flags" not in dataset or "converged" not in dataset:
        return {}
    # Converged points carry neither not_converged nor not_attempted.
    flags = dataset["flags"].astype(int).where(dataset["converged"].astype(bool), 0).astype(int)
    each = {name: (flags & bit) > 0 for name, bit in FLAGS.items()}
    return {name: where for name, where in each.items() if bool(where.any())}


def _speeds(where: xr.DataArray) -> str:
    """At which speeds any point is marked."""
    if "speed" not in where.dims:
        return ""
    speed = where["speed"].values[where.any([name for name in where.dims if name != "speed"]).values]
    # Through a float, since 100 reads better than 1e+02.
    low, high = (f"{float(f'{value:.2g}'):g}" for value in (speed.min(), speed.max()))
    return f" (v = {low} m/s)" if low == high else f" (v from {low} to {high} m/s)"


def _state_of_bodies(dataset: xr.Dataset) -> str:
    """How many finite-element bodies were taken through all of their steps, and which increments were given up."""
    failed, count = failures(dataset), int(_asked(dataset).sum())
    cut = int(dataset["rejected_increments"].sum()) if "rejected_increments" in dataset else 0
    tried = f" {cut} increments that did not converge were tried again in smaller ones." if cut else ""
    tried += _too_wide(dataset)
    if not failed:
        who = "The body" if count == 1 else f"All {count} bodies"
        return f"{who} got to the end of {'its' if count == 1 else 'their'} steps.{tried}"
    reasons = sorted(
        {str(reason).rstrip(".") for reason in dataset["stop_reason"].values.ravel() if str(reason)}
    )
    whose = "its" if failed == 1 else "their"
    return (
        f"{failed} of {count} bodies did not get to the end of {whose} steps ({'; '.join(reasons)}).{tried}"
    )


def _too_wide(dataset: xr.Dataset) -> str:
    """In how many bodies the contact goes beyond the nodes that can touch."""
    beyond = int((dataset["reaches_edge_end"] == 1).sum()) if "reaches_edge_end" in dataset else 0
    if not beyond:
        return ""
    return (
        f" In {beyond} of {dataset['converged'].size} bodies the contact reaches an end of the contact edge, beyond "
        "which nothing can touch the plate: pressures and displacements there are wrong; widen the contact edge."
    )
