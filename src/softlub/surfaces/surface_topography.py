"""The way into SurfaceTopography, which takes 1.4 s to import and warns where mpi4py is missing."""

from __future__ import annotations

import logging
import warnings
from types import ModuleType
from typing import Any

from softlub.surfaces.modes import Surface
from softlub.surfaces.topography import Topography


def surface_topography() -> ModuleType:
    """Import SurfaceTopography, at its first use only, and quietly."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import SurfaceTopography
        import SurfaceTopography.IO
    # One of its readers writes every file that is not its own to the terminal.
    logging.getLogger("igor2").setLevel(logging.CRITICAL)
    return SurfaceTopography


def as_surface_topography(surface: Surface) -> Any:
    """SurfaceTopography's `Topography` or `UniformLineScan` of the same heights, in metres."""
    library = surface_topography()
    kind = library.Topography if isinstance(surface, Topography) else library.UniformLineScan
    sides = tuple(count * surface.spacing for count in surface.heights.shape)
    return kind(surface.heights, sides, periodic=surface.periodic, unit="m")
