"""Made-up datasets of chapter 4 with the dimensions of real ones: for tests of figures and claims, and nothing else."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.printed_surfaces import rows
from softlub.datasets.store import describe
from softlub.surfaces.spectrum import SelfAffine

LOADS = np.geomspace(1e-3, 1, 16)


def surface(
    row, realisations=2, pixel_excess=0.25, kappa=2.1, kurtosis=3.0, slope=1.0, gap=1.0, roughness=None
):
    """One printed surface with a contact whose area is `kappa` times the load and bends over to 1.

    Pixels count `pixel_excess` times spacing over shortest wave more; the gap falls with the logarithm of p/E*.
    """
    count = realisations
    spectral = slope * row.rms_slope * 1.1
    load = LOADS * np.ones((count, 1))
    area = np.tanh(kappa * load)
    excess = 1 + pixel_excess * row.size / row.points / row.shortest
    height = row.rms_roughness if roughness is None else roughness
    separation = gap * height * np.log1p(0.1 / (load * spectral))
    over = ("realisation", "load_step")
    each = np.ones(count)
    variables = {
        "reduced_pressure": (over, load * spectral),
        "pressure": (over, 1e7 * load * spectral),
        "contact_area_ratio": (over, area),
        "contact_area_ratio_pixel": (over, np.minimum(area * excess, 1.0)),
        "mean_separation": (over, separation),
        "mean_separation_persson": (over, 1.3 * separation),
        "mean_separation_persson_gamma": (over, 1.05 * separation),
        "pressure_exponential": (over, 1e7 * 0.8 * load * spectral),
        "converged": (over, np.ones(load.shape, dtype=bool)),
        "iterations": (over, np.full(load.shape, 30)),
        "rms_roughness": ("realisation", height * each),
        "rms_slope_spectral": ("realisation", spectral * each),
        "rms_slope_forward": ("realisation", slope * row.rms_slope * each),
        "rms_slope_central": ("realisation", 0.9 * slope * row.rms_slope * each),
        "skewness": ("realisation", 0.05 * each),
        "kurtosis": ("realisation", kurtosis * each),
        "nayak_parameter": ("realisation", _asked(row, height).nayak_parameter * each),
        "hurst": row.hurst,
        "rolloff": 2 * np.pi / row.rolloff,
        "cutoff": 2 * np.pi / row.shortest,
        "long_cutoff": 2 * np.pi / row.longest,
        "size": row.size,
        "points": row.points,
    }
    return xr.Dataset(variables | _spectra(row, height, count))


def _asked(row, height):
    return SelfAffine(
        height, row.hurst, 2 * np.pi / row.rolloff, 2 * np.pi / row.shortest, 2 * np.pi / row.longest
    )


def _spectra(row, height, count):
    asked = _asked(row, height)
    q = np.geomspace(asked.plateau_start, asked.cutoff, 40)
    z = np.linspace(-4, 4, 41) * height
    density = np.exp(-((z / height) ** 2) / 2) / height / np.sqrt(2 * np.pi)
    return {
        "wavevector_values": ("wavevector", q),
        "power_spectrum": (("realisation", "wavevector"), np.tile(asked.density(q), (count, 1))),
        "height_values": ("height_bin", z),
        "height_density": (("realisation", "height_bin"), np.tile(density, (count, 1))),
    }


def with_axes(dataset):
    """Wavevectors and heights as coordinates."""
    values = {
        "wavevector": dataset["wavevector_values"].values,
        "height_bin": dataset["height_values"].values,
    }
    return describe(dataset.drop_vars(["wavevector_values", "height_values"]).assign_coords(values))


def table(name, largest=2048, **changes):
    """The surfaces of a printed table up to a number of points; a change may be a list, one value a row."""
    kept = [row for row in rows(name) if row.points <= largest]
    parts = []
    for index, row in enumerate(kept):
        own = {key: value[index] if isinstance(value, list) else value for key, value in changes.items()}
        parts.append(with_axes(surface(row, **own)))
    return xr.concat(parts, dim="surface", join="outer")


def areas():
    """One area with its spectra, and a line at its three stages."""
    (row,) = rows("table_4_1")
    dataset = with_axes(surface(row, 1)).isel(realisation=0)
    points, position = 24, np.linspace(0, 8e-3, 300)
    height = 1e-6 * np.sin(np.arange(points)[:, None] / 3) * np.cos(np.arange(points) / 4)
    lag = np.linspace(0, 2e-4, 50)
    spectrum = dataset["power_spectrum"].values
    roughness = 1e-6 * np.sin(position * 4e4)
    waviness = 3e-6 * np.sin(position * 3e3)
    coordinates = {
        "x": np.arange(points) * 1e-6,
        "y": np.arange(points) * 1e-6,
        "lag": lag,
        "wavevector_profile": dataset["wavevector"].values,
        "position": position,
    }
    return dataset.assign_coords(coordinates).assign(
        height=(("x", "y"), height),
        autocorrelation=("lag", 1e-12 * np.exp(-lag / 3e-5)),
        power_spectrum_profile=("wavevector_profile", 3.4 * dataset["wavevector"].values * spectrum),
        profile_raw=("position", roughness + waviness + 1e-3 * position),
        profile_form_removed=("position", roughness + waviness),
        profile_roughness=("position", roughness),
    )


def synthesis(tilt=0.5):
    """Surfaces of linear and of exponential wavevectors, the latter's spectrum turned by `tilt` about 2 q_r."""
    linear = areas()
    q, density = linear["wavevector"].values, linear["power_spectrum"].values
    middle = 2 * float(linear["rolloff"])
    parts = [
        linear.assign(power_spectrum=("wavevector", density * factor))
        for factor in (np.ones_like(q), (q / middle) ** -tilt)
    ]
    return xr.concat(parts, xr.Variable("wavevectors", ["linear", "exponential"]), data_vars="all")


def deflections(difference=0.0, seconds=(7.1, 0.06)):
    """Deflection by summation and DC-FFT beside a closed form."""
    x = np.linspace(-2e-3, 2e-3, 81)
    exact = 1e-4 / (1 + (x / 1e-3) ** 2)
    return xr.Dataset(
        {
            "deflection": (("method", "x"), np.array([exact, exact * (1 + difference)]) * (1 + 1e-4)),
            "deflection_hertz": ("x", exact),
            "seconds": ("method", list(seconds)),
        },
        coords={"method": ["direct", "dc_fft"], "x": x},
    )


def maps():
    """Maps of pressure and gap at four loads, touching ever more."""
    points, loads = 32, np.array([0.03e6, 0.23e6, 0.6e6, 1.6e6])
    wave = np.cos(np.arange(points) * 2 * np.pi / 16)
    shape = (wave[:, None] + wave) / 4 + 0.5
    limits = np.array([0.9, 0.6, 0.3, 0.0])
    pressure = np.maximum(shape - limits[:, None, None], 0)
    pressure *= (loads / pressure.mean(axis=(1, 2)))[:, None, None]
    gap = 1e-6 * np.maximum(limits[:, None, None] - shape, 0)
    over = ("load_step", "x", "y")
    return xr.Dataset(
        {
            "contact_pressure": (over, pressure),
            "gap": (over, gap),
            "pressure": ("load_step", loads),
            "converged": ("load_step", np.ones(4, dtype=bool)),
        },
        coords={"x": np.arange(points) * 1e-6, "y": np.arange(points) * 1e-6},
    )


def validation(difference=0.0, below=(0.9, 0.4), iterations=150):
    """One surface periodic and as a finite patch, by ours and by Polonsky–Keer; area below two gaps."""
    (row,) = rows("table_4_1")
    one = with_axes(surface(row, 1)).isel(realisation=0)
    other = one.assign(
        mean_separation=one["mean_separation"] + difference * one["rms_roughness"],
        iterations=("load_step", np.full(LOADS.size, iterations)),
    )
    solvers = xr.Variable("solver", ["conjugate_gradients", "polonsky_keer"])
    free, periodic = (xr.concat(pair, solvers, data_vars="all") for pair in ((one, other), (other, other)))
    joined = xr.concat([free, periodic], xr.Variable("boundary", ["free", "periodic"]), data_vars="all")
    counted = joined["contact_area_ratio_pixel"].expand_dims(threshold=[1e-20, 1e-9]).copy(deep=True)
    return joined.assign(contact_area_ratio_gap=counted * xr.DataArray(list(below), dims="threshold"))


DATASETS = {
    "profile_stages": areas,
    "topography_map": areas,
    "self_affine_spectrum": areas,
    "surface_spectra": areas,
    "wavevector_spacing": synthesis,
    "persson_separation": lambda: table("table_4_1"),
    "deflection": deflections,
    "contact_lines": maps,
    "solver_comparison": validation,
    "area_and_separation": lambda: table("table_4_3"),
    "spectra_and_heights": lambda: table("table_4_3"),
}
"""The smallest dataset that each drawing takes."""
