"""Study of a deflection: the half-space under Hertz's pressure by direct summation and by DC-FFT (figure 4-9)."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.contact.solver.compliance import Compliance, FreeCompliance
from softlub.contact.summation import SummedCompliance
from softlub.datasets import store
from softlub.references.hertz_point import HertzPoint

HALF_WIDTH = 2.0
"""Half-width of the domain over the contact's radius."""
REPETITIONS = 3
"""The shortest CPU time of so many counts."""


def run(spec: Mapping[str, Any], inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Deflect the half-space by each method and write what comes out along the central line.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: radius, force, modulus, points.
    inputs : mapping
        None.
    outputs : sequence of Path
        The dataset.
    """
    hertz = HertzPoint(spec["radius"], spec["modulus"], spec["force"])
    dataset = deflections(hertz, spec["points"])
    store.write(dataset, outputs[0], dict(spec))


def deflections(hertz: HertzPoint, points: int) -> xr.Dataset:
    """Deflection along x through the axis, by each method and in closed form.

    Parameters
    ----------
    hertz : HertzPoint
    points : int
        Points along each side of a square around the contact; odd, so that one lies on the axis.

    Returns
    -------
    xarray.Dataset
        Over `method` and x; `seconds` is the CPU time of one deflection of the whole square.
    """
    half = HALF_WIDTH * hertz.contact_radius
    x = np.linspace(-half, half, points)
    pressure = hertz.pressure(np.hypot(x[:, None], x))
    # Pressures in E*/(2 Δx) give displacements in metres.
    scaled = pressure * 2 * (x[1] - x[0]) / hertz.modulus
    makers: dict[str, Callable[[], Compliance]] = {
        "direct": lambda: SummedCompliance(pressure.shape),
        "dc_fft": lambda: FreeCompliance(pressure.shape, np.float64),
    }
    results = {method: _deflect(maker(), scaled) for method, maker in makers.items()}
    return xr.Dataset(
        {
            "deflection": (
                ("method", "x"),
                np.array([field[:, points // 2] for field, _ in results.values()]),
            ),
            "seconds": ("method", np.array([seconds for _, seconds in results.values()])),
            "deflection_hertz": ("x", hertz.deflection(np.abs(x))),
            "contact_radius": hertz.contact_radius,
            "points": float(points),
        },
        coords={"method": np.array(list(makers)), "x": x},
    )


def _deflect(compliance: Compliance, pressure: np.ndarray) -> tuple[np.ndarray, float]:
    """Displacement and CPU time; compiling, which happens once a machine, is not counted."""
    times = []
    for _ in range(REPETITIONS):
        compliance.source[:] = pressure
        clock = time.process_time()
        compliance.apply()
        times.append(time.process_time() - clock)
    return compliance.result.copy(), min(times)
