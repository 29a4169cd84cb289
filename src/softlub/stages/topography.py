"""Topography: one piece of a surface, or one line, with its statistics and spectra."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.stages.specimens import make, make_line
from softlub.surfaces.autocorrelation import autocorrelation
from softlub.surfaces.power_spectra import profile_power_spectrum, radial_power_spectrum
from softlub.surfaces.statistics import describe
from softlub.surfaces.topography import Topography

BINS_PER_DECADE = 24
"""Of the radial spectrum."""

Spec = Mapping[str, Any]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Make or read a piece of a surface and write what characterises it.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: surface, and whether to keep its heights.
    inputs : mapping
        ``files``: the instrument's file of a measured one.
    outputs : sequence of Path
        The dataset.
    """
    surface, files = spec["surface"], inputs.get("files", ())
    if surface["kind"].endswith("_line"):
        dataset = line_dataset(surface, files)
    else:
        dataset = surface_dataset(make(surface, files), spec["heights"])
    store.write(dataset, outputs[0], {"spec": dict(spec)})


def surface_dataset(topography: Topography, heights: bool) -> xr.Dataset:
    """Statistics, spectra, autocorrelation and height distribution of a surface, and its heights where asked for."""
    radial = radial_power_spectrum(topography, BINS_PER_DECADE)
    lines = profile_power_spectrum(topography)
    correlation = autocorrelation(topography)
    bins, density = height_density(topography)
    dataset = xr.Dataset(
        {
            **{name: float(value) for name, value in vars(describe(topography)).items()},
            "power_spectrum": ("wavevector", radial.density),
            "power_spectrum_profile": ("wavevector_profile", lines.density),
            "autocorrelation": ("lag", correlation.covariance),
            "height_density": ("height_bin", density),
            "spacing": topography.spacing,
        },
        coords={
            "wavevector": radial.wavevector,
            "wavevector_profile": lines.wavevector,
            "lag": correlation.distance,
            "height_bin": bins,
        },
    )
    if heights:
        along = {
            name: topography.spacing * np.arange(points)
            for name, points in zip(("x", "y"), topography.heights.shape, strict=True)
        }
        dataset = dataset.assign_coords(along).assign(
            height=(("x", "y"), topography.heights.astype(np.float32))
        )
    return dataset


def height_density(topography: Topography) -> tuple[np.ndarray, np.ndarray]:
    """Middles of bins about the mean height [m] and the probability density in them [1/m].

    The bins are as wide as the power of ten nearest to a tenth of h_rms and lie on its multiples, so that the
    surfaces of one study have theirs in common.
    """
    heights = topography.heights - topography.heights.mean()
    width = 10.0 ** (round(np.log10(heights.std())) - 1)
    number = np.rint(heights / width).astype(np.int64)
    first = int(number.min())
    counts = np.bincount(number.ravel() - first)
    middles = np.array([float(f"{k * width:.12g}") for k in range(first, first + counts.size)])
    return middles, counts / (heights.size * width)


def line_dataset(surface: Spec, files: Sequence[Path]) -> xr.Dataset:
    """A line as measured, without its form, and without its waviness."""
    line = make_line(surface, files)
    without_form = line.raw.heights - line.form.heights
    return xr.Dataset(
        {
            "profile_raw": ("position", line.raw.heights),
            "profile_form_removed": ("position", without_form),
            "profile_roughness": ("position", line.roughness.heights),
            **{f"profile_{name}": float(value) for name, value in vars(describe(line.roughness)).items()},
        },
        coords={"position": line.raw.positions},
    )
