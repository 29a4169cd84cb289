"""Tables 4-1 to 4-5 beside ours: inputs, rms roughness and rms slope by named estimator, κ by named count."""

from __future__ import annotations

import csv
import io
import os

import numpy as np
import xarray as xr

from softlub.claims.kappas import kappa
from softlub.claims.printed_surfaces import PrintedSurface, find, rows
from softlub.claims.table import write_text
from softlub.claims.verdict import NotComputed
from softlub.datasets.contact_curves import contact_curve, inputs

COLUMNS = (
    "row",
    "longest_wavelength [m]",
    "rolloff_wavelength [m]",
    "shortest_wavelength [m]",
    "shortest_wavelength_printed [m]",
    "hurst [1]",
    "size [m]",
    "points [1]",
    "spacing [m]",
    "rms_roughness_printed [m]",
    "rms_roughness [m]",
    "rms_slope_printed [1]",
    "rms_slope_forward [1]",
    "rms_slope_central [1]",
    "rms_slope_spectral [1]",
    "deviation_of_forward_slope [1]",
    "skewness [1]",
    "kurtosis [1]",
    "nayak_parameter [1]",
    "realisations [1]",
    "kappa_corrected_area [1]",
    "kappa_pixel_area [1]",
    "kappa_local_at_0.005 [1]",
    "kappa_local_at_0.05 [1]",
    "state",
)
"""Headers; κ is that of the line through the origin up to A/A0 = 0.2 over the spectral slope, see `kappas`."""
DIMENSIONLESS = (
    "rms_slope_forward",
    "rms_slope_central",
    "rms_slope_spectral",
    "skewness",
    "kurtosis",
    "nayak_parameter",
)
"""Inputs and statistics that are written as they are."""
NOT_RUN = "not run at this accuracy"


def write(table: str, dataset: xr.Dataset, path: str | os.PathLike[str]) -> None:
    """Write one table as CSV.

    Parameters
    ----------
    table : str
        ``"table_4_2"``.
    dataset : xarray.Dataset
        Of the study that runs its surfaces.
    path : path-like
    """
    write_text(path, text(table, dataset))


def text(table: str, dataset: xr.Dataset) -> str:
    """One table as CSV: a row a surface, those that were not run with an empty right half.

    Parameters
    ----------
    table : str
    dataset : xarray.Dataset

    Returns
    -------
    str

    Raises
    ------
    ValueError
        If the source has no such table of surfaces.
    """
    if not rows(table):
        raise ValueError(
            f"the source prints no table of surfaces called {table}; there are table_4_1 to table_4_5"
        )
    stream = io.StringIO()
    writer = csv.DictWriter(stream, COLUMNS, restval="", lineterminator="\n")
    writer.writeheader()
    for number, printed in enumerate(rows(table), 1):
        surface = find(dataset, printed)
        ours = {"state": NOT_RUN} if surface is None else _ours(printed, surface)
        cells = {**_printed(printed), **ours}
        writer.writerow({"row": number} | {name: _cell(value) for name, value in cells.items()})
    return stream.getvalue()


def _cell(value: float | str) -> str:
    if isinstance(value, str):
        return value
    return f"{value:.6g}" if np.isfinite(value) else ""


def _printed(printed: PrintedSurface) -> dict[str, float | str]:
    return {
        "longest_wavelength [m]": printed.longest,
        "rolloff_wavelength [m]": printed.rolloff,
        "shortest_wavelength [m]": printed.shortest,
        "shortest_wavelength_printed [m]": printed.printed_shortest or printed.shortest,
        "hurst [1]": printed.hurst,
        "size [m]": printed.size,
        "points [1]": printed.points,
        "spacing [m]": printed.size / printed.points,
        "rms_roughness_printed [m]": printed.rms_roughness,
        "rms_slope_printed [1]": printed.rms_slope,
    }


def _ours(printed: PrintedSurface, surface: xr.Dataset) -> dict[str, float | str]:
    known = inputs(surface)
    ours: dict[str, float | str] = {f"{name} [1]": known[name] for name in DIMENSIONLESS if name in known}
    ours["rms_roughness [m]"] = known["rms_roughness"]
    ours["deviation_of_forward_slope [1]"] = known["rms_slope_forward"] / printed.rms_slope - 1
    ours["state"] = "run"
    if "converged" in surface:
        curve = contact_curve(surface)
        ours["realisations [1]"] = curve.realisations
        try:
            found = kappa(curve)
        except NotComputed as missing:
            return ours | {"state": f"run; no kappa: {missing}"}
        ours |= {
            "kappa_corrected_area [1]": found.corrected,
            "kappa_pixel_area [1]": found.pixel,
            "kappa_local_at_0.005 [1]": found.light,
            "kappa_local_at_0.05 [1]": found.heavy,
        }
    return ours
