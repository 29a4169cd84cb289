"""CPU time at equal measured errors: our solver and the source's algorithm beside ASPHER and tamaas, in one run.

Every solver gets the same heights and answers with the pressure; the gap is rebuilt from it by one code, so that no
solver judges itself. Area errors are absolute in A/A0 (share of points that carry pressure), gap errors root mean
square over the surface, over h_rms; both against our solver at a tolerance of 1e-9. A ladder of tolerances at four
loads comes first: a solver is timed at the loosest one that meets both limits at every load.

Peers run as a process each, see `peer_solvers`. The time is user and system time of the solves alone, one thread,
one call each; ours is the median of three, being short. tamaas runs twice where its FFTW can be replaced: its wheel's
own is built without vector instructions, and the dynamic loader takes the system's (Debian: libfftw3-double3)
instead when LD_PRELOAD names libfftw3.so.3 and libfftw3_omp.so.3. It stops at the same iterates either way: the
wheel as installed is not given a ladder, nor the sweep.
"""

import ctypes.util
import json
import os
import subprocess
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import peer_solvers
import xarray as xr

from softlub.contact import descend, solve, solve_polonsky_keer
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.surfaces import SelfAffine, Topography, synthesize

POINTS, LARGER = 512, (1024, 2048)
SWEEP = np.geomspace(1.0, 1e-3, 20)
"""p/(E*h'rms), falling; h'rms = 1 and E* = 1 here."""
LOADS = (1.0, 0.2, 0.05, 1e-3)
ONE_LOAD = 0.05
LARGEST_AREA_ERROR, LARGEST_GAP_ERROR = 1e-5, 1e-6
REFERENCE_TOLERANCE = 1e-9
PRELOADED = ("libfftw3.so.3", "libfftw3_omp.so.3")


class Answer(NamedTuple):
    """Seconds and pressure maps over the loads."""

    seconds: np.ndarray
    pressure: np.ndarray


Run = Callable[[Topography, Sequence[float], float], Answer]


class Solver(NamedTuple):
    """How to run a solver, its ladder of tolerances, and whether it is timed over the sweep."""

    run: Run
    tolerances: tuple[float, ...]
    sweeps: bool = True
    largest: int = LARGER[0]
    """Points a side of the largest grid that it is timed on."""
    as_chosen_for: str | None = None
    """The solver whose choice of tolerance holds here too."""


def _timed(maps: Callable[[], list[np.ndarray]], repeats: int) -> tuple[float, list[np.ndarray]]:
    taken = []
    for _ in range(repeats):
        began = time.process_time()
        found = maps()
        taken.append(time.process_time() - began)
    return float(np.median(taken)), found


def ours(topography: Topography, pressures: Sequence[float], tolerance: float) -> Answer:
    """`solve` at each load by itself."""
    rows = [
        _timed(lambda load=load: [solve(topography, 1.0, load, tolerance).pressure], 3) for load in pressures
    ]
    return Answer(np.array([row[0] for row in rows]), np.array([row[1][0] for row in rows]))


def ours_sweep(topography: Topography, pressures: Sequence[float], tolerance: float) -> Answer:
    """`descend`, every load from the last; the time is spread evenly over them."""

    def maps() -> list[np.ndarray]:
        return [contact.pressure for contact in descend(topography, 1.0, pressures, tolerance)]

    seconds, found = _timed(maps, 3)
    return Answer(np.full(len(pressures), seconds / len(pressures)), np.array(found))


def polonsky_keer(topography: Topography, pressures: Sequence[float], tolerance: float) -> Answer:
    """The source's algorithm with our transforms."""
    rows = [
        _timed(lambda load=load: [solve_polonsky_keer(topography, 1.0, load, tolerance, 0.0).pressure], 1)
        for load in pressures
    ]
    return Answer(np.array([row[0] for row in rows]), np.array([row[1][0] for row in rows]))


def peer(name: str, python: str, preloaded: Sequence[str] = ()) -> Run:
    """A peer in a process of its own, with the interpreter of the peers' environment."""
    environment = {
        **os.environ,
        **{f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL")},
        "LD_PRELOAD": ":".join(preloaded),
    }

    def run(topography: Topography, pressures: Sequence[float], tolerance: float) -> Answer:
        with tempfile.TemporaryDirectory() as name_of_folder:
            folder = Path(name_of_folder)
            np.save(folder / "heights.npy", topography.heights)
            job = {"pressures": list(map(float, pressures)), "tolerance": tolerance}
            (folder / "job.json").write_text(json.dumps(job))
            command = [python, peer_solvers.__file__, name, str(folder)]
            done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
            if done.returncode:
                raise RuntimeError(f"{name} at tolerance {tolerance:g} failed:\n{done.stderr[-1000:]}")
            return Answer(np.load(folder / "cpu_time.npy"), np.load(folder / "pressure.npy"))

    return run


def solvers(python: str) -> dict[str, Solver]:
    """All that are compared; tamaas with the system's FFTW only where there is one."""
    found = {
        "softlub": Solver(ours, (1e-5, 3e-6, 1e-6), largest=LARGER[-1]),
        "Polonsky–Keer (softlub)": Solver(polonsky_keer, (3e-6, 1e-6), sweeps=False),
        "ASPHER": Solver(peer("aspher", python), (1e-5, 1e-6, 3e-7, 1e-7), largest=LARGER[-1]),
    }
    wheel = Solver(peer("tamaas", python), (1e-4, 1e-5, 5e-6, 1e-6), sweeps=False)
    if ctypes.util.find_library("fftw3") and ctypes.util.find_library("fftw3_omp"):
        found["tamaas, system's FFTW"] = Solver(peer("tamaas", python, PRELOADED), wheel.tolerances)
        wheel = wheel._replace(as_chosen_for="tamaas, system's FFTW")
    return found | {"tamaas, wheel": wheel}


def surface(points: int) -> Topography:
    """Self-affine, H = 0.8, roll-off at a quarter of the period, cut-off at 8 points, h'rms = 1."""
    spectrum = SelfAffine.from_rms_slope(1.0, 0.8, 2 * np.pi * 4, 2 * np.pi * points / 8)
    return synthesize(spectrum, 1.0, points, seed=1, target="rms_slope")


def gap_of(topography: Topography, pressure: np.ndarray) -> np.ndarray:
    """Gap that a pressure makes, zero on average over the load, by the compliance 2/(E*|q|)."""
    count = topography.heights.shape[0]
    along, across = np.fft.rfftfreq(count, 1 / count), np.fft.fftfreq(count, 1 / count)
    wavevector = 2 * np.pi * np.hypot(across[:, None], along)
    wavevector[0, 0] = np.inf
    displacement = np.fft.irfft2(np.fft.rfft2(pressure) * 2 / wavevector, pressure.shape)
    gap = displacement - topography.heights
    return np.asarray(gap - np.sum(gap * pressure) / pressure.sum())


def errors(topography: Topography, exact: np.ndarray, found: np.ndarray) -> tuple[float, float]:
    """Errors of the area (absolute) and of the gap (over h_rms)."""
    difference = gap_of(topography, found) - gap_of(topography, exact)
    area = abs(np.mean(found > 0) - np.mean(exact > 0))
    return float(area), float(np.sqrt(np.mean(difference**2)) / topography.heights.std())


def measure(python: str) -> xr.Dataset:
    """Ladders of tolerances at four loads, then the sweep and the larger grids at the tolerance they choose."""
    candidates = solvers(python)
    names = list(candidates)
    small = surface(POINTS)
    solve(small, 1.0, 0.05)  # compiles
    steps = max(len(solver.tolerances) for solver in candidates.values())
    ladder = np.full((4, len(names), steps, len(LOADS)), np.nan)
    sweep = np.full((3, len(names), len(SWEEP)), np.nan)
    single = np.full((3, len(names), len(LARGER)), np.nan)
    chosen = np.full(len(names), np.nan)

    exact = [solve(small, 1.0, load, REFERENCE_TOLERANCE).pressure for load in LOADS]
    for row, solver in enumerate(candidates.values()):
        follows = solver.as_chosen_for
        tolerances = solver.tolerances if follows is None else (float(chosen[names.index(follows)]),)
        for step, tolerance in enumerate(tolerances):
            ladder[0, row, step] = tolerance
            ladder[1:, row, step] = _cost(solver.run, small, LOADS, tolerance, exact)
            if np.isnan(chosen[row]) and _meets(ladder[2:, row, step]):
                chosen[row] = tolerance
        chosen[row] = tolerances[-1] if np.isnan(chosen[row]) else chosen[row]

    exact = [solve(small, 1.0, load, REFERENCE_TOLERANCE).pressure for load in SWEEP]
    for row, (name, solver) in enumerate(candidates.items()):
        if solver.sweeps:
            run = ours_sweep if name == "softlub" else solver.run
            sweep[:, row] = _cost(run, small, SWEEP, chosen[row], exact)
    for column, points in enumerate(LARGER):
        large = surface(points)
        exact = [solve(large, 1.0, ONE_LOAD, REFERENCE_TOLERANCE).pressure]
        for row, solver in enumerate(candidates.values()):
            if points <= solver.largest:
                single[:, row, column] = _cost(solver.run, large, [ONE_LOAD], chosen[row], exact)[:, 0]
    return _dataset(names, chosen, ladder, sweep, single)


def _cost(
    run: Run, topography: Topography, loads: Sequence[float], tolerance: float, exact: list[np.ndarray]
) -> np.ndarray:
    """Seconds, area error and gap error, over the loads."""
    answer = run(topography, loads, tolerance)
    found = [errors(topography, *pair) for pair in zip(exact, answer.pressure, strict=True)]
    return np.vstack([answer.seconds, np.transpose(found)])


def _meets(found: np.ndarray) -> bool:
    return bool((found[0] <= LARGEST_AREA_ERROR).all() and (found[1] <= LARGEST_GAP_ERROR).all())


def _dataset(
    names: list[str], chosen: np.ndarray, ladder: np.ndarray, sweep: np.ndarray, single: np.ndarray
) -> xr.Dataset:
    kinds = ("cpu_time", "area_error", "gap_error")
    dataset = xr.Dataset(
        {
            "chosen_tolerance": ("solver", chosen),
            "tolerance": (("solver", "step"), ladder[0, :, :, 0]),
            **{kind: (("solver", "step", "load"), ladder[1 + n]) for n, kind in enumerate(kinds)},
            **{f"sweep_{kind}": (("solver", "sweep_load"), sweep[n]) for n, kind in enumerate(kinds)},
            **{f"larger_{kind}": (("solver", "points"), single[n]) for n, kind in enumerate(kinds)},
        },
        coords={"solver": names, "load": list(LOADS), "sweep_load": SWEEP, "points": list(LARGER)},
        attrs={
            "title": "Rough contact: CPU time at equal measured errors",
            "timed": f"one thread, solves alone; ladders and sweep at {POINTS}², one load on the larger grids",
            "largest_area_error": LARGEST_AREA_ERROR,
            "largest_gap_error": LARGEST_GAP_ERROR,
        },
    )
    return dataset


def draw(dataset: xr.Dataset) -> DataFigure:
    """Gap error over CPU time at one load, and CPU time over load at equal errors; 512²."""
    with styled():
        figure = new_figure(style.PAGE, 3.0)
        left, right = figure.subplots(1, 2)
        seconds = quantity("cpu_time", label="CPU time of a load", unit="s")
        error = quantity("gap_error", label=r"gap error (over $h_\mathrm{rms}$)", unit="1")
        load = quantity("load", label=r"$p / (E^* h'_\mathrm{rms})$", unit="1")
        panels = [Panel(left, seconds, error, "a"), Panel(right, load, seconds, "b")]
        for panel in panels:
            panel.letter(panel.name)
            panel.axes.set_xscale("log")
            panel.axes.set_yscale("log")
        for index, name in enumerate(dataset["solver"].values):
            of_one = dataset.sel({"solver": name})
            at_one = of_one.sel({"load": ONE_LOAD})
            look = {"color": style.CYCLE[index], "marker": "o"}
            panels[0].line(str(name), at_one["cpu_time"].values, at_one["gap_error"].values, **look)
            step = int(np.argmax((of_one["tolerance"] == of_one["chosen_tolerance"]).values))
            panels[1].line(str(name), dataset["load"].values, of_one["cpu_time"].values[step], **look)
        share_legend(figure, panels, 3)
        return figure
