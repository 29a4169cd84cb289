"""Spectral elements with the rupture point as an unknown: the fastest and most accurate solver of the line contact."""

from softlub.lubrication.solvers.spectral.solver import Spectral

__all__ = ["Spectral"]
