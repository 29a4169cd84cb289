"""The surface of the comparison with other projects, and the one judge of every solver's pressure.

Every solver gets the same heights and answers with the pressure; the gap is rebuilt from it here, so that no solver
judges itself. Area errors are absolute in A/A0 (share of points that carry pressure), gap errors root mean square over
the surface, over h_rms; both against our solver at a tolerance of 1e-9.
"""

from typing import NamedTuple, TypeVar

import numpy as np
import scipy.fft
import xarray as xr

from softlub.contact import solve
from softlub.surfaces import SelfAffine, Topography, synthesize

LARGEST_AREA_ERROR, LARGEST_GAP_ERROR = 1e-5, 1e-6
REFERENCE_TOLERANCE = 1e-9

Errors = TypeVar("Errors", np.ndarray, xr.DataArray)


def surface(points: int, shortest_wave: int = 8) -> Topography:
    """Self-affine, H = 0.8, roll-off at a quarter of the period, cut-off at a number of points, h'rms = 1."""
    spectrum = SelfAffine.from_rms_slope(1.0, 0.8, 2 * np.pi * 4, 2 * np.pi * points / shortest_wave)
    return synthesize(spectrum, 1.0, points, seed=1, target="rms_slope")


def gap_of(heights: np.ndarray, pressure: np.ndarray) -> np.ndarray:
    """Gap that a pressure makes on a period of 1, zero on average over the load, by the compliance 2/(E*|q|)."""
    rows, columns = heights.shape
    across, along = np.fft.fftfreq(rows, 1 / rows), np.fft.rfftfreq(columns, 1 / columns)
    wavevector = 2 * np.pi * np.hypot(across[:, None], along)
    wavevector[0, 0] = np.inf
    waves = scipy.fft.rfft2(np.asarray(pressure, dtype=float))
    waves *= 2 / wavevector
    gap = scipy.fft.irfft2(waves, heights.shape) - heights
    return np.asarray(gap - np.sum(gap * pressure) / pressure.sum())


class Reference(NamedTuple):
    """What the pressure maps at one load are held against."""

    heights: np.ndarray
    gap: np.ndarray
    area: float

    @staticmethod
    def at(topography: Topography, load: float) -> "Reference":
        """The contact at a load, by our solver at a tolerance of 1e-9."""
        contact = solve(topography, 1.0, load, REFERENCE_TOLERANCE)
        if not contact.converged:
            raise RuntimeError(
                f"no reference at p/(E*h'rms) = {load:g} on {topography.heights.shape}: residual "
                f"{contact.residual:.1e} instead of {REFERENCE_TOLERANCE:g}"
            )
        return Reference.of(topography.heights, contact.pressure)

    @staticmethod
    def of(heights: np.ndarray, pressure: np.ndarray) -> "Reference":
        """The contact that a pressure map describes."""
        return Reference(heights, gap_of(heights, pressure), float(np.mean(pressure > 0)))

    def errors(self, pressure: np.ndarray) -> tuple[float, float]:
        """Errors of the area (absolute) and of the gap (over h_rms)."""
        difference = gap_of(self.heights, pressure) - self.gap
        area = abs(float(np.mean(pressure > 0)) - self.area)
        return area, float(np.sqrt(np.mean(difference**2)) / self.heights.std())


def meets(area_error: Errors, gap_error: Errors) -> Errors:
    """Whether both errors keep their limits; not where nothing was run."""
    return (area_error <= LARGEST_AREA_ERROR) & (gap_error <= LARGEST_GAP_ERROR)


def quickest(dataset: xr.Dataset) -> xr.Dataset:
    """Of the runs along `step` that keep both limits, the one that took the least CPU time; NaN where none does."""
    within = meets(dataset["area_error"], dataset["gap_error"])
    seconds = dataset["cpu_time"].where(within)
    step = seconds.fillna(np.inf).argmin("step")
    chosen = dataset[["cpu_time", "tolerance", "convolutions", "area_error", "gap_error"]].isel(step=step)
    return chosen.where(within.any("step"))
