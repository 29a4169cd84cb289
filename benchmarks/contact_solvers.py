"""Contact solvers under one face: ours, the source's algorithm with our transforms, and other projects' solvers.

Peers run as a process each, see `peer_solvers`. tamaas runs twice where its FFTW can be replaced: its wheel's own is
built without vector instructions, and the dynamic loader takes the system's (Debian: libfftw3-double3) instead when
LD_PRELOAD names libfftw3.so.3 and libfftw3_omp.so.3. ASPHER runs twice as well: as pip builds it, and compiled for the
processor at hand.
"""

import ctypes.util
import json
import os
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import peer_solvers
from peer_solvers import Begin, Found, timed

from softlub.contact import descend, solve_polonsky_keer
from softlub.surfaces import Topography

OURS = "softlub"
PRELOADED = ("libfftw3.so.3", "libfftw3_omp.so.3")
Sequences = Sequence[Sequence[float]]


class Answer(NamedTuple):
    """CPU time [s], convolutions and pressure map of every load of all sequences, one after another."""

    seconds: np.ndarray
    convolutions: np.ndarray
    pressure: np.ndarray

    @staticmethod
    def of(sequences: Sequences, begin: Callable[[Sequence[float]], Begin]) -> "Answer":
        """Time every sequence in this process."""
        answers = [timed(begin(sequence), sequence) for sequence in sequences]
        found = [one for _, several in answers for one in several]
        return Answer(
            np.concatenate([seconds for seconds, _ in answers]),
            np.array([one.convolutions for one in found]),
            np.array([one.pressure for one in found]),
        )


Run = Callable[[Topography, Sequences, float], Answer]
"""Surface, sequences of falling loads (each begins from cold) and tolerance to an answer; E* = 1."""


class Solver(NamedTuple):
    """How to run a solver, and which runs it is given: slow ones get fewer on large grids."""

    run: Run
    tolerances: tuple[float, ...]
    """The ladder, from loose to tight; a run means something else by it in every project."""
    settled: int = 0
    """Rung from which the ladder is climbed, until both errors keep their limits, where it is not climbed whole."""
    ladder_to: int = 512
    """Points a side of the largest grid on which every load is solved at the whole ladder."""
    loads_to: int = 1024
    """The same for every load."""
    largest: int = 2048
    """The same for one load."""
    sweeps: bool = True
    """Whether it is timed over the sweep of 20 loads."""
    follows: str | None = None
    """The solver whose choice of tolerance holds here too, since both go through the same iterates."""


def ours(topography: Topography, sequences: Sequences, tolerance: float) -> Answer:
    """`descend`: every load from the last ones, the first from cold as `solve` does; its set-up is timed."""

    def begin(pressures: Sequence[float]) -> Begin:
        def start() -> Callable[[float], Found]:
            contacts = descend(topography, 1.0, pressures, tolerance)

            def solve(_: float) -> Found:
                contact = next(contacts)
                return Found(contact.pressure, contact.convolutions)

            return solve

        return start

    return Answer.of(sequences, begin)


def polonsky_keer(topography: Topography, sequences: Sequences, tolerance: float) -> Answer:
    """The source's algorithm with our transforms; every load from cold."""

    def solve(pressure: float) -> Found:
        contact = solve_polonsky_keer(topography, 1.0, pressure, tolerance, 0.0)
        return Found(contact.pressure, contact.convolutions)

    return Answer.of(sequences, lambda _: lambda: solve)


def peer(name: str, python: str, preloaded: Sequence[str] = (), packages: str = "") -> Run:
    """A peer in a process of its own, with the interpreter of the peers' environment.

    `preloaded` names libraries for the dynamic loader, `packages` a folder whose packages go before the installed ones.
    """
    environment = {
        **os.environ,
        **{f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL")},
        "LD_PRELOAD": ":".join(preloaded),
        "PYTHONPATH": packages,
    }

    def run(topography: Topography, sequences: Sequences, tolerance: float) -> Answer:
        with tempfile.TemporaryDirectory() as name_of_folder:
            folder = Path(name_of_folder)
            np.save(folder / "heights.npy", topography.heights)
            job = {"sequences": [list(map(float, part)) for part in sequences], "tolerance": tolerance}
            (folder / "job.json").write_text(json.dumps(job))
            command = [python, peer_solvers.__file__, name, str(folder)]
            done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
            if done.returncode:
                raise RuntimeError(f"{name} at tolerance {tolerance:g} failed:\n{done.stderr[-1000:]}")
            return Answer(
                *(np.load(folder / f"{part}.npy") for part in ("cpu_time", "convolutions", "pressure"))
            )

    return run


def our_solvers() -> dict[str, Solver]:
    """What softlub itself offers; quick enough for every grid, or here for comparison."""
    return {
        OURS: Solver(ours, (1e-5, 3e-6, 1e-6, 3e-7, 1e-7), 1, ladder_to=2048, loads_to=4096, largest=4096),
        "Polonsky–Keer (softlub)": Solver(polonsky_keer, (3e-6, 1e-6, 3e-7, 1e-7), 1),
    }


def all_solvers(python: str) -> dict[str, Solver]:
    """All that are compared; tamaas with the system's FFTW only where there is one.

    Parameters
    ----------
    python : str
        Interpreter of the peers' environment, which keeps ASPHER's second build in its folder `native`.
    """
    native = str(Path(python).absolute().parents[1] / "native")
    rungs = (1e-4, 1e-5, 2e-6, 1e-6, 3e-7, 1e-7, 3e-8)
    found = our_solvers() | {
        "ASPHER": Solver(peer("aspher", python), rungs, 2, ladder_to=1024, loads_to=2048, largest=4096),
        "ASPHER, native build": Solver(peer("aspher", python, packages=native), rungs, 2),
    }
    wheel = Solver(peer("tamaas", python), (1e-4, 1e-5, 5e-6, 1e-6, 1e-7), 2, sweeps=False, largest=1024)
    if ctypes.util.find_library("fftw3") and ctypes.util.find_library("fftw3_omp"):
        name = "tamaas, system's FFTW"
        found[name] = wheel._replace(run=peer("tamaas", python, PRELOADED), sweeps=True, largest=2048)
        wheel = wheel._replace(follows=name, loads_to=512)
    return found | {
        "tamaas, wheel": wheel,
        "ContactMechanics": Solver(
            peer("contact_mechanics", python),
            (1e-3, 1e-4, 1e-5, 1e-6),
            2,
            ladder_to=256,
            loads_to=512,
            largest=1024,
        ),
    }
