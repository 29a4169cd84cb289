"""From the solver's part of a panel's spec to the solver, and to the finer one that estimates its error."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any

from softlub.lubrication.sweep import Solver

SOLVERS = {
    "auto": ("softlub.lubrication.solvers.auto", "Auto"),
    "spectral": ("softlub.lubrication.solvers.spectral", "Spectral"),
    "finite_volume": ("softlub.lubrication.solvers.finite_volume", "FiniteVolume"),
    "bml": ("softlub.lubrication.solvers.bml", "BML"),
    "mehl": ("softlub.lubrication.solvers.mehl", "MEHL"),
    "ehl": ("softlub.lubrication.solvers.ehl", "EHL"),
}
"""Module and class of each solver: they bring compiled code, so only the one that is asked for is imported."""


def make_solver(options: Mapping[str, Any]) -> Solver:
    """The solver of a panel.

    Parameters
    ----------
    options : mapping
        ``name`` and the settings of that solver; those of ``auto`` are the options of its two parts.

    Returns
    -------
    Solver
    """
    module, class_name = SOLVERS[options["name"]]
    settings = {
        key: make_solver({"name": key, **value}) if isinstance(value, Mapping) else value
        for key, value in options.items()
        if key != "name"
    }
    return getattr(import_module(module), class_name)(**settings)


def finer_solver(options: Mapping[str, Any]) -> Solver | None:
    """The solver's refined copy; None for the source's modules, whose error is that of their residual."""
    refined = getattr(make_solver(options), "refined", None)
    return refined() if refined is not None else None
