"""Rough surfaces: spectra, synthesis, measured topographies, statistics."""

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
