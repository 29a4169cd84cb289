"""Study of rough contacts: laws in SI, joined along what is swept and along the solvers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.datasets import store
from softlub.datasets.variables import FLAGS
from softlub.pressure_table import evaluate
from softlub.stages import surface_study
from softlub.stages.specimens import spectrum

HEIGHTS = (
    "average_roughness",
    "rms_roughness",
    "mean_separation",
    "mean_separation_persson",
    "mean_separation_persson_gamma",
    "rigid_approach",
    "gap",
    "threshold",
    "reduced_pressure",
    "contact_pressure",
    "rms_slope_spectral",
    "rms_slope_forward",
    "rms_slope_central",
)
"""What grows in proportion to the heights of the surface."""
PRESSURES = ("contact_pressure",)
"""What a law gives over E*."""
INTERNAL = ("persson_separation", "persson_pressure", "persson_rate")

Spec = Mapping[str, Any]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Join the laws and write the study's dataset.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: sweeps, solvers, surfaces (asked for and made, h_rms and E* of their laws), laws
        and topographies (which of the inputs are whose).
    inputs : mapping
        ``law`` and, where a figure needs spectra, ``topography``: files in the plan's order.
    outputs : sequence of Path
        The dataset.
    """
    laws = [store.read(path).drop_attrs(deep=False) for path in inputs.get("law", ())]
    pieces = [store.read(path).drop_attrs(deep=False) for path in inputs.get("topography", ())]
    rows = []
    for index, surface in enumerate(spec["surfaces"]):
        contacts = [_empty() if law is None else in_si(laws[law], surface) for law in spec["laws"][index]]
        own = [pieces[place] for place in spec["topographies"][index]] if spec["topographies"] else []
        rows += [_row(surface, contact, own) for contact in contacts]
    sweeps = list(spec["sweeps"])
    if len(spec["solvers"]) > 1:
        sweeps.append({"dimension": "solver", "labels": spec["solvers"]})
    dataset = surface_study.swept(rows, sweeps)
    store.write(dataset.transpose(..., *_last(dataset)), outputs[0], dict(spec))


def in_si(law: xr.Dataset, surface: Mapping[str, Any]) -> xr.Dataset:
    """A law with the heights of its surface and the modulus of the body.

    Parameters
    ----------
    law : xarray.Dataset
        Heights in units of `height`, pressures over E*.
    surface : mapping
        ``height`` [m], ``modulus`` [Pa] or None, and the surface as it was ``made``.

    Returns
    -------
    xarray.Dataset
        With `pressure`, `pressure_exponential`, κ and flags besides.
    """
    height, modulus = surface["height"], surface["modulus"]
    contact = law.drop_vars(INTERNAL, errors="ignore")
    contact = contact.assign({name: contact[name] * height for name in HEIGHTS if name in contact.data_vars})
    if "threshold" in contact.coords:
        # Rounded: what the study says and not what scaling to and fro makes of it.
        limits = [float(f"{value:.12g}") for value in contact["threshold"].values * height]
        contact = contact.assign_coords(threshold=limits)
    load = contact["reduced_pressure"] / contact["rms_slope_spectral"]
    failed = ~contact["converged"]
    derived = {
        "kappa": contact["contact_area_ratio"] / load,
        "kappa_local": _local_slope(contact["contact_area_ratio"], load),
        "flags": xr.where(failed, FLAGS["not_converged"], 0).astype(np.int32),
    }
    if modulus is not None:
        derived |= {name: contact[name] * modulus for name in PRESSURES if name in contact}
        derived["pressure"] = contact["reduced_pressure"] * modulus
        derived |= _exponential(contact, surface["made"], modulus)
    numbers = {name: np.arange(contact.sizes[name]) for name in ("realisation", "load_step")}
    contact = contact.assign(derived).assign_coords(numbers)
    return contact.isel(realisation=0, drop=True) if contact.sizes["realisation"] == 1 else contact


def _exponential(contact: xr.Dataset, made: Mapping[str, Any], modulus: float) -> dict[str, xr.DataArray]:
    """Pressure of equation 3-11 (4-23) at the separations of Persson's full integral [Pa]."""
    asked = spectrum(made)
    if asked is None:
        return {}
    separation = contact["mean_separation_persson"]
    pressure = evaluate(ExponentialLaw(asked, modulus).table, separation.values)[0]
    return {"pressure_exponential": separation.copy(data=pressure)}


def _local_slope(area: xr.DataArray, load: xr.DataArray) -> xr.DataArray:
    """d(A/A0)/d(p/(E* h'_rms)) by differences of the logarithms, of second order on uneven loads."""
    if area.sizes["load_step"] < 3:
        return xr.full_like(area, np.nan)
    x, y = (np.log(np.where(each > 0, each, np.nan)) for each in (load, area))
    exponent = [np.gradient(*pair, edge_order=2) for pair in zip(y, x, strict=True)]
    return area.copy(data=np.array(exponent)) * area / load


def _empty() -> xr.Dataset:
    """Contact of a surface that was too large for the accuracy: one load step that nobody attempted."""
    flags = ("load_step", np.array([FLAGS["not_attempted"]], dtype=np.int32))
    converged = ("load_step", np.array([False]))
    return xr.Dataset({"flags": flags, "converged": converged}, coords={"load_step": [0]})


def _row(surface: Mapping[str, Any], contact: xr.Dataset, own: Sequence[xr.Dataset]) -> xr.Dataset:
    statistics = [name for name in surface_study.joined(own) if name in contact] if own else []
    parts = [surface_study.described(surface), contact]
    if own:
        parts.append(surface_study.joined(own).drop_vars([*statistics, "spacing"], errors="ignore"))
    return xr.merge(parts, join="outer", compat="equals")


def _last(dataset: xr.Dataset) -> list[str]:
    return [name for name in ("realisation", "load_step", "x", "y") if name in dataset.dims]
