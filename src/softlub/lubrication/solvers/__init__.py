"""Solvers of the lubricated contact; one solver a folder or file.

Each is a frozen dataclass of its settings with two methods: ``solve(problem, start=None)`` returns a
`LubricatedContact`,
``sweep(problem, speeds)`` a list of them, continued along speed. Those that can estimate their error have a third,
``refined()``: the same solver on a finer grid, whose ``correct(problem, contacts)`` solves the points of given contacts
there, each begun from the contact.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any

SOLVERS = {
    "auto": ("softlub.lubrication.solvers.auto", "Auto"),
    "spectral": ("softlub.lubrication.solvers.spectral", "Spectral"),
    "finite_volume": ("softlub.lubrication.solvers.finite_volume", "FiniteVolume"),
    "bml": ("softlub.lubrication.solvers.bml", "BML"),
    "mehl": ("softlub.lubrication.solvers.mehl", "MEHL"),
    "ehl": ("softlub.lubrication.solvers.ehl", "EHL"),
}
"""Module and class of each solver: they bring compiled code, so only the one asked for is imported."""


def make_solver(name: str, **settings: Any) -> Any:
    """A solver by its name.

    Parameters
    ----------
    name : str
        A key of `SOLVERS`.
    **settings
        Arguments of that solver; a mapping stands for the settings of a part, which is a solver of that name.

    Returns
    -------
    Solver

    Raises
    ------
    ValueError
        If there is no such solver.
    """
    if name not in SOLVERS:
        raise ValueError(f"no solver is called {name!r}; there are {', '.join(SOLVERS)}")
    module, class_name = SOLVERS[name]
    arguments = {
        key: make_solver(key, **value) if isinstance(value, Mapping) else value
        for key, value in settings.items()
    }
    return getattr(import_module(module), class_name)(**arguments)


def finer(solver: Any) -> Any:
    """The refined copy that estimates a solver's error; None for the source's modules, which have none."""
    refined = getattr(solver, "refined", None)
    return refined() if refined is not None else None
