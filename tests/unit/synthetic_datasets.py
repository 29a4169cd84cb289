"""Made-up datasets with the dimensions of real ones: for tests of figures and claims, and nothing else."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.datasets.store import describe
from softlub.datasets.variables import FLAGS

SPEEDS = np.geomspace(1e-5, 100, 29)


def stribeck(speeds=SPEEDS, dimensions=None, nodes=0, load=100.0, modulus=1e7, rms=1e-6, viscosity=0.1):
    """A smooth Stribeck-like dataset over (dimensions…, load, speed[, node])."""
    dimensions = dict(dimensions or {})
    shape = (*(len(values) for values in dimensions.values()), 1, len(speeds))
    names = (*dimensions, "load", "speed")
    offset = np.arange(int(np.prod(shape[:-2], dtype=int))).reshape(*shape[:-2], 1, 1)
    hersey = viscosity * np.asarray(speeds) * np.ones(shape)
    film = 2e-6 * (hersey / 4e-3) ** 0.6 * (1 + 0.1 * offset)
    share = 1 / (1 + (hersey / 5e-5) ** 0.9) / (1 + 0.1 * offset)
    fluid = 0.03 * (hersey / 4e-3) ** 0.45 * (1 - share) + 0 * offset
    solid = 0.39 * share
    full = {
        "friction_coefficient": fluid + solid,
        "friction_coefficient_fluid": fluid,
        "friction_coefficient_couette": 0.7 * fluid,
        "friction_coefficient_poiseuille": 0.3 * fluid,
        "friction_coefficient_solid": solid,
        "separation_min": film,
        "separation_central": 1.2 * film,
        "load_share_solid": share,
        "lambda_ratio": film / rms,
        "real_contact_width": solid * load / (0.1 * modulus),
        "residual": np.full(shape, 1e-9),
        "solver_seconds": np.full(shape, 1e-3) * (1 + offset),
    }
    variables = {name: (names, values) for name, values in full.items()}
    variables |= {
        "hersey_number": ("speed", viscosity * np.asarray(speeds)),
        "converged": (names, np.ones(shape, dtype=bool)),
        "iterations": (names, np.full(shape, 5)),
        "flags": (names, np.zeros(shape, dtype=np.int32)),
        "viscosity": ((), viscosity),
        "rms_roughness": ((), rms),
        "radius": ((), 0.01),
        "plane_strain_modulus": ((), modulus / (1 - 0.4999**2)),
        "long_term_modulus": ((), modulus),
        "shear_strength": ((), 0.1 * modulus),
    }
    if "rms_roughness" in dimensions:
        del variables["rms_roughness"]
    coordinates = {**dimensions, "load": [load], "speed": np.asarray(speeds)}
    if nodes:
        fields, x = _fields(share, film, nodes)
        variables |= {name: ((*names, "node"), values) for name, values in fields.items()}
        coordinates["x"] = ((*names, "node"), x)
    return describe(xr.Dataset(variables, coords=coordinates))


def _fields(share, film, nodes):
    a, peak, radius = 0.309e-3, 0.206e6, 0.01
    x = np.broadcast_to(
        np.sort(np.r_[np.linspace(-1.2, 1.2, nodes - 9) * a, np.geomspace(2, 60, 9) * -a]),
        (*share.shape, nodes),
    )
    total = peak * np.sqrt(np.clip(1 - (x / a) ** 2, 0, None))
    beyond = np.clip(np.abs(x) / a, 1, None)
    opening = a**2 / (2 * radius) * (beyond * np.sqrt(beyond**2 - 1) - np.arccosh(beyond))
    fields = {
        "fluid_pressure": (1 - share[..., None]) * total,
        "solid_pressure": share[..., None] * total,
        "separation": film[..., None] + opening,
    }
    return fields, x.copy()


def fail(dataset, **where):
    """A copy in which the points at integer positions `where` failed: NaN, flagged; fields and effort stay."""
    failed = dataset.copy(deep=True)
    kept = {"iterations", "residual", "solver_seconds", "load_error"}
    for name, variable in failed.data_vars.items():
        if "speed" not in variable.dims or "node" in variable.dims or name in kept or name == "hersey_number":
            continue
        if variable.dtype == bool:
            variable[where] = False
        elif name == "flags":
            variable[where] = FLAGS["not_converged"]
        else:
            variable[where] = np.nan
    failed["residual"][where] = 3e-2
    failed["iterations"][where] = 20000
    return failed


def skip(dataset, **where):
    """A copy in which points were never attempted."""
    skipped = fail(dataset, **where)
    skipped["flags"][where] = FLAGS["not_attempted"]
    skipped["iterations"][where] = 0
    return skipped


def sample(points=2000, seed=1):
    """A designed sample of scenes over (sample, speed)."""
    random = np.random.default_rng(seed)
    ranges = {
        "young_modulus": (5e5, 5e7),
        "rms_roughness": (1e-7, 1e-5),
        "viscosity": (1e-3, 1),
        "radius": (1e-3, 5e-2),
        "load": (10, 1e3),
    }
    drawn = {
        name: np.exp(random.uniform(np.log(low), np.log(high), points))
        for name, (low, high) in ranges.items()
    }
    speeds = np.geomspace(1e-4, 10, 9)
    modulus = drawn["young_modulus"] / 0.75
    half_width = np.sqrt(4 * drawn["load"] * drawn["radius"] / (np.pi * modulus))
    number = (
        6
        * drawn["viscosity"][:, None]
        * speeds
        * (drawn["radius"] ** 2 / half_width**2 * np.pi / 2 / drawn["load"])[:, None]
    )
    film = 0.35 * number**0.6 * (half_width**2 / drawn["radius"])[:, None]
    ratio = film / drawn["rms_roughness"][:, None]
    share = 1 / (1 + ratio**2)
    data = {
        "converged": np.ones_like(film, dtype=bool),
        "friction_coefficient": 0.4 * share + 0.03 * number**0.4,
        "separation_min": film,
        "lambda_ratio": ratio,
        "load_share_solid": share,
        "flags": np.zeros(film.shape, dtype=np.int32),
    }
    variables = {name: (("sample", "speed"), values) for name, values in data.items()}
    variables |= {name: ("sample", values) for name, values in drawn.items()}
    variables |= {"plane_strain_modulus": ("sample", modulus), "hertz_half_width": ("sample", half_width)}
    variables["hersey_number"] = (("sample", "speed"), drawn["viscosity"][:, None] * speeds)
    return describe(xr.Dataset(variables, coords={"sample": np.arange(points), "speed": speeds}))


def work_precision():
    """Two methods at four resolutions."""
    time = np.array([[1e-3, 2e-3, 4e-3, 8e-3], [1e-2, 4e-2, 0.2, np.nan]])
    error = np.array([[1e-3, 1e-4, 1e-5, 1e-6], [1e-3, 2.5e-4, 6e-5, np.nan]])
    return xr.Dataset(
        {
            "cpu_time": (("method", "step"), time),
            "error_friction": (("method", "step"), error, {"long_name": "error of μ"}),
            "error_separation": (
                ("method", "step"),
                10 * error,
                {"long_name": "relative error of the separation"},
            ),
            "resolution": (("method", "step"), np.array([[4.0, 6, 8, 12], [65, 129, 257, np.nan]])),
        },
        coords={"method": ["spectral", "finite_volume"]},
    )
