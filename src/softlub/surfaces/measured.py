"""Measured topographies and lines from instruments' files, read by SurfaceTopography (some forty formats)."""

from __future__ import annotations

import contextlib
import io
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.surfaces.measurement import Missing
from softlub.surfaces.profile import Profile
from softlub.surfaces.surface_topography import surface_topography
from softlub.surfaces.topography import Topography

# Instruments write spacings along x and y with some four digits.
EVEN_SPACING = 1e-3


def read(
    path: str | Path,
    channel: str | int | None = None,
    unit: str | None = None,
    missing: Missing = "refuse",
) -> Topography:
    """Read a measured area.

    Parameters
    ----------
    path : str or Path
        The instrument's file.
    channel : str or int, optional
        Name of the channel, or its number from 0 where several share a name; the file's own default otherwise.
    unit : str, optional
        Unit of lengths and heights where the file states none: m, mm, µm (um), nm, Å or pm.
    missing : {"refuse", "fill"}
        What to do with points that the instrument did not measure: `fill` puts the smoothest (harmonic) surface
        through their surroundings.

    Returns
    -------
    Topography
        Heights of shape (nx, ny) [m], not periodic, with the form and waviness that were measured.

    Raises
    ------
    ValueError
        If the file cannot be read, has no such channel, holds a line, has missing points and no rule for them, states
        no unit or another one, has pixels that are not square, or heights that are all equal. The
        message names the file.
    FileNotFoundError
        If there is no such file.
    """
    surface, heights = _heights(Path(path), channel, unit, missing, dimensions=2)
    spacing_x, spacing_y = surface.pixel_size
    if abs(spacing_x / spacing_y - 1) > EVEN_SPACING:
        raise ValueError(
            f"{path}: pixels of {spacing_x:g} m × {spacing_y:g} m are not square; export the file with square pixels"
        )
    return Topography(heights, float(np.sqrt(spacing_x * spacing_y)), periodic=False)


def read_profile(
    path: str | Path,
    channel: str | int | None = None,
    unit: str | None = None,
    missing: Missing = "refuse",
) -> Profile:
    """Read a measured line. Points that are not evenly spaced are brought onto as many even ones, linearly.

    Parameters
    ----------
    path, channel, unit, missing
        As in `read`.

    Returns
    -------
    Profile
        Heights of shape (n,) [m], not periodic, with the form and waviness that were measured.

    Raises
    ------
    ValueError
        As `read`, or if the file holds an area.
    FileNotFoundError
        If there is no such file.
    """
    surface, heights = _heights(Path(path), channel, unit, missing, dimensions=1)
    if surface.is_uniform:
        return Profile(heights, float(surface.pixel_size[0]), periodic=False)
    positions = np.asarray(surface.positions(), dtype=np.float64)
    even = np.linspace(positions[0], positions[-1], positions.size)
    return Profile(np.interp(even, positions, heights), float(even[1] - even[0]), periodic=False)


def channels(path: str | Path) -> list[str]:
    """Names of the channels of an instrument's file that hold heights or anything else, in the file's order."""
    with _opened(Path(path)) as reader:
        return [str(channel.name) for channel in reader.channels]


def _heights(
    path: Path, channel: str | int | None, unit: str | None, missing: Missing, dimensions: int
) -> tuple[Any, NDArray[np.float64]]:
    """Surface in metres as SurfaceTopography holds it, and its heights without gaps."""
    if missing not in ("refuse", "fill"):
        raise ValueError(f"{path}: rule for missing points {missing!r} is unknown; allowed: refuse, fill")
    with _opened(path) as reader:
        chosen = _choose(path, reader.channels, channel)
        if not _holds_heights(chosen):
            raise ValueError(f"{path}: channel {chosen.name!r} holds no heights; {_listed(reader.channels)}")
        if chosen.dim != dimensions:
            what = "a line: read it with read_profile" if chosen.dim == 1 else "an area: read it with read"
            raise ValueError(f"{path}: channel {chosen.name!r} holds {what}")
        given = _unit_to_give(path, chosen, unit)
        with _said(path):
            surface = chosen.topography(**given).to_unit("m")
            if missing == "fill" and surface.has_undefined_data:
                surface = surface.interpolate_undefined_data()
            heights = surface.heights()
    return surface, _checked(path, heights)


def _choose(path: Path, available: list[Any], channel: str | int | None) -> Any:
    """Find the channel; the first one with heights where none is named."""
    if not available:
        raise ValueError(f"{path}: the file holds no channel; it may be truncated")
    if channel is None:
        return next((entry for entry in available if _holds_heights(entry)), available[0])
    if isinstance(channel, int):
        if 0 <= channel < len(available):
            return available[channel]
        raise ValueError(f"{path}: no channel {channel}; {_listed(available)}")
    found = [entry for entry in available if entry.name == channel]
    if len(found) == 1:
        return found[0]
    if not found:
        raise ValueError(f"{path}: no channel {channel!r}; {_listed(available)}")
    numbers = ", ".join(str(entry.index) for entry in found)
    raise ValueError(f"{path}: {len(found)} channels are called {channel!r}; choose by number: {numbers}")


def _holds_heights(channel: Any) -> bool:
    # Units along the surface and across it that differ in kind come as a pair.
    return channel.data_kind.value == "height" and not isinstance(channel.unit, tuple)


def _listed(available: list[Any]) -> str:
    return "it has " + ", ".join(f"{entry.index}: {entry.name}" for entry in available)


def _unit_to_give(path: Path, channel: Any, unit: str | None) -> dict[str, str]:
    """The unit that the reader has to be told, if any."""
    stated = _one_micro(unit)
    if channel.unit is None:
        if stated is None:
            raise ValueError(f"{path}: the file states no unit of length; state one, as unit: µm")
        return {"unit": stated}
    if stated not in (None, _one_micro(channel.unit)):
        raise ValueError(f"{path}: the file states its unit as {channel.unit}, not {unit}; leave unit out")
    return {}


def _one_micro(unit: str | None) -> str | None:
    """The unit with one of the three ways to write a micrometre."""
    return None if unit is None else unit.replace("um", "µm").replace("μ", "µ")


def _checked(path: Path, heights: Any) -> NDArray[np.float64]:
    """Heights as a plain array, or the reason why they are no surface."""
    plain = np.array(np.ma.getdata(heights), dtype=np.float64)
    undefined = np.ma.getmaskarray(heights) | ~np.isfinite(plain)
    if undefined.any():
        raise ValueError(
            f"{path}: {int(undefined.sum())} of {undefined.size} points are missing (not measured, NaN or infinite); "
            "say what to do with them, as missing: fill"
        )
    if min(plain.shape) < 2:
        raise ValueError(f"{path}: {' × '.join(map(str, plain.shape))} points: at least 2 a side are needed")
    if np.ptp(plain) == 0:
        raise ValueError(f"{path}: all heights are equal: the surface has no roughness")
    return plain


def _opened(path: Path) -> Any:
    if not path.is_file():
        raise FileNotFoundError(f"{path}: no such file")
    with _said(path):
        return surface_topography().IO.open_topography(str(path))


@contextlib.contextmanager
def _said(path: Path) -> Iterator[None]:
    """Turn whatever the reader raises into a message that names the file and says what the reader said."""
    try:
        # Some readers print the bytes that they stumble over.
        with contextlib.redirect_stdout(io.StringIO()):
            yield
    # Readers fail in any way on a damaged file: IndexError, UnicodeDecodeError, struct.error and their own.
    except Exception as error:
        raise ValueError(f"{path}: cannot be read as a topography: {_reason(path, error)}") from error


def _reason(path: Path, error: Exception) -> str:
    """What the readers of the file's own format complain of, by the ending of its name."""
    complaints = re.findall(r"tried (\w+): \s*(.*?)\n\n", str(error), flags=re.DOTALL)
    if not complaints:
        return f"the reader stopped with {type(error).__name__}: {_short(str(error))}"
    suffix = path.suffix.lower().lstrip(".")
    own = {
        reader.__name__
        for reader in surface_topography().IO.readers
        if suffix in (reader.format(), *reader.file_extensions())
    }
    said = [f"{name}: {_short(text)}" for name, text in complaints if name in own]
    return "; ".join(said) or "its contents fit none of the formats that SurfaceTopography knows"


def _short(text: str) -> str:
    line = re.sub(r" '?<_io\..*>'?", "", " ".join(text.split()))
    return line if len(line) <= 160 else line[:157] + "…"
