"""Finite volumes with semi-smooth complementarity: the check of the spectral solver and its fallback."""

from softlub.lubrication.solvers.finite_volume.solver import FiniteVolume

__all__ = ["FiniteVolume"]
