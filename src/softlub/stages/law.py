"""Law: a rough surface swept over its load, all its realisations in one job."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.contact.laws.persson_curve import separation_at, spectrum_curve, waves_curve
from softlub.contact.laws.persson_integral import ScaledCurve
from softlub.contact.memory import refuse_what_will_not_fit
from softlub.contact.real_area import persson_area_ratio
from softlub.datasets import store
from softlub.stages.contact_solvers import descend
from softlub.stages.specimens import make, spectrum
from softlub.study.specimens import realisation, realisations
from softlub.surfaces.power_spectra import radial_power_spectrum
from softlub.surfaces.statistics import describe
from softlub.surfaces.topography import Topography

GAMMA = 0.45
"""γ of Persson's theory that agrees with simulations."""
BINS_PER_DECADE = 40
"""Of the measured spectrum that Persson's theory is fed."""
MAPS = ("contact_pressure", "gap")
"""Kept of the first realisation only, where somebody asks for them."""

Spec = Mapping[str, Any]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Sweep all realisations of a surface and write what they carry.

    Heights, separations and pressures over E* are those of the spec's surface, whose h_rms is 1 m where it is
    synthetic: whoever reads the law multiplies all three by its own h_rms.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: surface, boundary, pressures, solver, and maps and gap_thresholds where asked for.
    inputs : mapping
        ``files``: the instrument's file of a measured surface.
    outputs : sequence of Path
        The dataset.
    """
    surface, files = spec["surface"], inputs.get("files", ())
    if "points" in surface:
        refuse_what_will_not_fit((surface["points"],) * 2, spec["boundary"] != "free")
    pieces = []
    for index in range(realisations(surface)):
        topography = make(realisation(surface, index), files)
        pieces.append(one_realisation(spec, topography, maps=bool(spec.get("maps")) and index == 0))
    maps = {name: pieces[0][name] for name in MAPS if name in pieces[0]}
    curves = [piece.drop_vars([*MAPS, "x", "y"], errors="ignore") for piece in pieces]
    dataset = xr.concat(curves, dim="realisation", coords="minimal", compat="equals").assign(maps)
    store.write(dataset, outputs[0], {"spec": dict(spec)})


def one_realisation(spec: Spec, topography: Topography, maps: bool) -> xr.Dataset:
    """Statistics of one piece, and its contact over the load; E* is 1 Pa.

    Parameters
    ----------
    spec : mapping
        As in `run`.
    topography : Topography
    maps : bool
        Whether to keep pressure and gap at every point.

    Returns
    -------
    xarray.Dataset
        Over `load_step`; maps over x and y besides.
    """
    statistics = describe(topography)
    slope, height = statistics.rms_slope_spectral, statistics.rms_roughness
    given = np.array(spec["pressures"]["values"])
    reduced = given * slope if spec["pressures"]["over"] == "slope" else given
    if spec["boundary"] is not None:
        pressed = replace(topography, periodic=spec["boundary"] == "periodic")
    else:
        pressed = topography
    swept = descend(pressed, reduced, spec["solver"], spec.get("gap_thresholds", []), maps)
    closing = _persson(spec, topography, 1.0)
    return swept.assign(
        {
            "reduced_pressure": ("load_step", reduced),
            "contact_area_ratio_persson": ("load_step", persson_area_ratio(reduced, 1.0, slope)),
            "mean_separation_persson": ("load_step", height * separation_at(closing, reduced / slope)),
            "mean_separation_persson_gamma": (
                "load_step",
                height * separation_at(_persson(spec, topography, GAMMA), reduced / slope),
            ),
            "persson_separation": ("persson_step", closing.separation),
            "persson_pressure": ("persson_step", closing.pressure),
            "persson_rate": ("persson_step", closing.rate),
            **{name: float(value) for name, value in vars(statistics).items()},
        }
    )


def _persson(spec: Spec, topography: Topography, gamma: float) -> ScaledCurve:
    """Persson's curve of the asked spectrum, or of the measured waves."""
    asked = spectrum(spec["surface"])
    if asked is not None:
        return spectrum_curve(asked, gamma)
    waves = radial_power_spectrum(topography, BINS_PER_DECADE)
    size = topography.size[0] * topography.size[1]
    return waves_curve(waves.wavevector, waves.density * waves.modes * (2 * np.pi) ** 2 / size, gamma)
