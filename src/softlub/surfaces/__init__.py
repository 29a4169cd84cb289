"""Rough surfaces: spectra, synthesis, measured topographies, statistics.

The names below are loaded when they are first used: the study reader needs the spectrum's parameters at every start of
the workflow, and must not wait for transforms and readers of files.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from softlub.surfaces.measured import read, read_profile
    from softlub.surfaces.profile import Profile
    from softlub.surfaces.profile_synthesis import synthesize_profile
    from softlub.surfaces.spectrum import SelfAffine, Smooth
    from softlub.surfaces.statistics import describe
    from softlub.surfaces.synthesis import synthesize, synthesize_exponential
    from softlub.surfaces.topography import Topography

__all__ = [
    "Profile",
    "SelfAffine",
    "Smooth",
    "Topography",
    "describe",
    "read",
    "read_profile",
    "synthesize",
    "synthesize_exponential",
    "synthesize_profile",
]

_HOMES = {
    "Profile": "profile",
    "SelfAffine": "spectrum",
    "Smooth": "spectrum",
    "Topography": "topography",
    "describe": "statistics",
    "read": "measured",
    "read_profile": "measured",
    "synthesize": "synthesis",
    "synthesize_exponential": "synthesis",
    "synthesize_profile": "profile_synthesis",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
