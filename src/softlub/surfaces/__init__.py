"""Rough surfaces: spectra, synthesis, measured topographies, statistics."""

from softlub.surfaces.spectrum import SelfAffine, Smooth
from softlub.surfaces.synthesis import synthesize, synthesize_exponential
from softlub.surfaces.topography import Topography

__all__ = ["SelfAffine", "Smooth", "Topography", "synthesize", "synthesize_exponential"]
