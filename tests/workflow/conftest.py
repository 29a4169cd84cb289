"""Running the workflow as a user does: a study file, a command, files in a folder."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

TINY_STUDY = """
title: Tiny study of the tests
kind: stribeck
scene:
  body:
    shape: {kind: cylinder, radius: 10 mm}
    material: {young_modulus: 10 MPa, poisson_ratio: 0.4999}
  surface: {kind: self_affine, rms_roughness: 1 um, hurst: 0.8, rolloff: 1e4 1/m, cutoff: 7.8e9 1/m}
  lubricant: {viscosity: 0.1 Pa s}
  shear_strength: SHEAR
grid:
  load: [100 N/m]
  speed: {from: 1e-3 m/s, to: 1 m/s, points: POINTS, spacing: log}
figures: FIGURES
"""


class Workspace:
    """A folder with one study file, in which the workflow is run."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.study = folder / "tiny.yaml"

    def write(self, shear: str = "0.1 E", points: int = 5, figures: str = "[stribeck]") -> None:
        """Write the study file with these values."""
        text = TINY_STUDY.replace("SHEAR", shear).replace("POINTS", str(points)).replace("FIGURES", figures)
        self.study.write_text(text)

    def command(self, *arguments: str) -> list[str]:
        """The command that runs the study."""
        return [
            sys.executable,
            "-m",
            "snakemake",
            "--snakefile",
            str(ROOT / "Snakefile"),
            "--directory",
            str(self.folder),
            "--cores",
            "2",
            "--config",
            f"study={self.study}",
            *arguments,
        ]

    def run(self, *arguments: str) -> subprocess.CompletedProcess:
        """Run to the end; the caller looks at the exit status and at what was said."""
        return subprocess.run(
            self.command(*arguments), capture_output=True, text=True, env=self.environment, timeout=300
        )

    def start(self, *arguments: str) -> subprocess.Popen:
        """Start in a process group of its own, so that it can be killed with all its jobs."""
        return subprocess.Popen(
            self.command(*arguments),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env=self.environment,
            start_new_session=True,
        )

    @property
    def environment(self) -> dict[str, str]:
        """This process's environment, with caches inside the folder."""
        return os.environ | {
            "XDG_CACHE_HOME": str(self.folder / "cache"),
            "MPLCONFIGDIR": str(self.folder / "mpl"),
        }

    def made(self, pattern: str) -> list[Path]:
        """Files under results/, by glob."""
        return sorted((self.folder / "results").glob(pattern))


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    """An empty workspace."""
    return Workspace(tmp_path)
