"""Rough surfaces: spectra, synthesis, measured topographies, statistics."""
