"""Make the environment of benchmarks/peers.py: `make_peers_environment.py REQUIREMENTS FOLDER`.

ASPHER is installed twice: as pip builds it, and in FOLDER/native compiled for the processor at hand.
"""

import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

EIGEN = ("/usr/include/eigen3/Eigen", "/usr/local/include/eigen3/Eigen", "/opt/homebrew/include/eigen3/Eigen")
NATIVE = "-DASPHER_NATIVE=ON"
"""What ASPHER's own build files call -O3 -march=native; packages are built without."""


def main(requirements: Path, folder: Path) -> None:
    """Check what ASPHER is compiled with, then install."""
    missing = []
    if not any(shutil.which(compiler) for compiler in ("c++", "g++", "clang++")):
        missing.append("a C++ compiler (Debian: apt-get install g++)")
    if not any(Path(path).exists() for path in EIGEN):
        missing.append("Eigen's headers (Debian: apt-get install libeigen3-dev)")
    if missing:
        sys.exit(f"ASPHER comes as source only and needs {' and '.join(missing)}")
    venv.create(folder, with_pip=True)
    pip = [str(folder / "bin" / "python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, "--requirement", str(requirements)], check=True)
    lines = requirements.read_text(encoding="utf-8").splitlines()
    (aspher,) = [line for line in lines if line.startswith("aspher==")]
    # pip's cache of what it built does not ask how
    fresh = ["--no-cache-dir", "--no-binary", "aspher", "--no-deps", "--upgrade"]
    subprocess.run(
        [*pip, *fresh, "--target", str(folder / "native"), aspher],
        check=True,
        env={**os.environ, "CMAKE_ARGS": NATIVE},
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
