"""Run time against error of a 40-speed Stribeck curve: spectral elements, finite volumes, extrapolation.

The errors are the largest over the 40 speeds, against spectral elements of order 24 on the same domain. The time is
CPU time of the whole sweep, the contact law's table and the friction integrals included, compiled code warm, one
thread.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import xarray as xr
from measuring import cpu_seconds, least_squares_order, least_squares_rate
from reference_contact import SPEEDS, friction_of, table_3_1

from softlub.figures import draw as draw_figure
from softlub.figures.panel import DataFigure
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.finite_volume.extrapolation import nested_pair, richardson
from softlub.lubrication.solvers.spectral import Spectral

ORDERS = (4, 5, 6, 7, 8, 9, 10, 11, 12)
NODES = (65, 129, 257, 513, 1025, 2049)
REFERENCE_ORDER = 24
ASYMPTOTIC_NODES = (129, 257, 513, 1025)
"""Grids that the order of the finite volumes is taken from."""
LONG = 1025
"""Sweeps on this many nodes take seconds and are timed once."""


class Curve(NamedTuple):
    """What is compared: μ and u_min over speed, and the Newton steps that they took."""

    friction: np.ndarray
    separation: np.ndarray
    steps: int
    not_converged: int
    """Points that the solver itself flags; they are compared all the same."""

    @staticmethod
    def of(contacts: Sequence[LubricatedContact], problem: Problem) -> "Curve":
        """What a sweep found."""
        return Curve(
            np.array([friction_of(contact, problem) for contact in contacts]),
            np.array([contact.separation_min for contact in contacts]),
            sum(contact.iterations for contact in contacts),
            sum(not contact.converged for contact in contacts),
        )


Method = Callable[[], Curve]


def spectral(order: int) -> Method:
    """A whole curve by spectral elements, its problem and law made anew."""

    def curve() -> Curve:
        problem = table_3_1()
        return Curve.of(Spectral(order=order).sweep(problem, SPEEDS), problem)

    return curve


def finite_volume(nodes: int) -> Method:
    """The same by finite volumes."""

    def curve() -> Curve:
        problem = table_3_1()
        return Curve.of(FiniteVolume(nodes=nodes).sweep(problem, SPEEDS), problem)

    return curve


def extrapolated(nodes: int) -> Method:
    """The same by finite volumes on two nested grids, extrapolated; the steps of both grids count."""

    def curve() -> Curve:
        problem = table_3_1()
        levels = nested_pair(FiniteVolume(nodes=nodes), problem, SPEEDS)
        coarse, fine = (Curve.of(contacts, problem) for contacts in levels)
        return Curve(
            richardson(coarse.friction, fine.friction),
            richardson(coarse.separation, fine.separation),
            coarse.steps + fine.steps,
            coarse.not_converged + fine.not_converged,
        )

    return curve


METHODS: dict[str, tuple[Callable[[int], Method], tuple[int, ...]]] = {
    "spectral elements (p)": (spectral, ORDERS),
    "finite volumes (N)": (finite_volume, NODES),
    "finite volumes, extrapolated (N)": (extrapolated, NODES[1:]),
}


def measure() -> xr.Dataset:
    """CPU time and errors of every method and resolution, and the orders of convergence."""
    exact = spectral(REFERENCE_ORDER)()
    longest = max(len(resolutions) for _, resolutions in METHODS.values())
    table = np.full((6, len(METHODS), longest), np.nan)
    for row, (method, resolutions) in enumerate(METHODS.values()):
        for column, resolution in enumerate(resolutions):
            table[:, row, column] = resolution, *_cost(method(resolution), resolution, exact)
    names = ("resolution", "cpu_time", "error_friction", "error_separation", "newton_steps", "not_converged")
    dataset = xr.Dataset(
        {name: (("method", "step"), values) for name, values in zip(names, table, strict=True)},
        coords={"method": list(METHODS)},
        attrs={
            "title": "Run time against error",
            "timed": f"40 speeds from 1e-5 to 100 m/s of table 3-1, law and friction included, warm; errors are the "
            f"largest over the speeds, against spectral elements of order {REFERENCE_ORDER}",
        },
    )
    dataset["cpu_time"].attrs = {"units": "s", "long_name": "CPU time of a 40-speed curve"}
    dataset["error_friction"].attrs = {"units": "1", "long_name": "error of μ"}
    dataset["error_separation"].attrs = {"units": "1", "long_name": r"relative error of $u_\mathrm{min}$"}
    dataset["newton_steps"].attrs = {
        "units": "1",
        "long_name": "Newton steps at the speeds asked for, those between them not counted",
    }
    dataset.attrs |= convergence(dataset)
    return dataset


def _cost(method: Method, resolution: int, exact: Curve) -> tuple[float, float, float, int, int]:
    found = method()
    repeats = 1 if resolution >= LONG else 3 if resolution >= 129 else 15
    seconds = cpu_seconds(method, repeats, warm_up=False)
    return (
        seconds,
        float(np.max(np.abs(found.friction - exact.friction))),
        float(np.max(np.abs(found.separation / exact.separation - 1))),
        found.steps,
        found.not_converged,
    )


def convergence(dataset: xr.Dataset) -> dict[str, float]:
    """Least-squares orders of the finite volumes, and the factor per order of the spectral elements."""
    volumes = dataset.sel({"method": "finite volumes (N)"})
    chosen = np.isin(volumes["resolution"].values, ASYMPTOTIC_NODES)
    spectra = dataset.sel({"method": "spectral elements (p)"}).isel(step=slice(0, len(ORDERS)))
    found = {}
    for quantity in ("friction", "separation"):
        error = volumes[f"error_{quantity}"].values[chosen]
        found[f"finite_volume_order_{quantity}"] = least_squares_order(
            volumes["resolution"].values[chosen], error
        )
        found[f"spectral_factor_per_order_{quantity}"] = least_squares_rate(
            spectra["resolution"].values, spectra[f"error_{quantity}"].values
        )
    return found


def draw(dataset: xr.Dataset) -> DataFigure:
    """Both errors over CPU time."""
    return draw_figure("work_precision", dataset.drop_vars(["newton_steps", "not_converged"]))
