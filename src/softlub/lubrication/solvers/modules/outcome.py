"""From a module's last iterate to the lubricated contact that is handed back."""

from __future__ import annotations

from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.fields import (
    gradient,
    parabola_minimum,
    parabola_value,
    rupture,
)
from softlub.lubrication.solvers.finite_volume.scaled import LOAD
from softlub.lubrication.solvers.modules.contact import EvenContact, Fields
from softlub.lubrication.solvers.modules.iteration import Budget

LONGEST_HISTORY = 400
"""Residuals kept; of longer histories every second, third … one."""


def outcome(
    contact: EvenContact, fields: Fields, residual: float, tolerance: float, budget: Budget, solver: str
) -> LubricatedContact:
    """The contact in SI units; converged where its true residual is at most the tolerance."""
    problem, nodes = contact.problem, contact.nodes
    hertz = problem.hertz
    half_width, peak, height = hertz.half_width, hertz.peak_pressure, hertz.gap_scale
    weights = contact.scaled.space.widths
    converged = residual <= tolerance
    # The parabola through the lowest nodes of a jagged last iterate may fall below zero.
    lowest = parabola_minimum(nodes, fields.gap) if converged else float(fields.gap.min())
    every = -(-len(budget.history) // LONGEST_HISTORY) or 1
    return LubricatedContact(
        load=problem.load,
        speed=problem.speed,
        positions=half_width * nodes,
        weights=half_width * weights,
        fluid_pressure=peak * fields.fluid,
        solid_pressure=peak * fields.solid,
        separation=height * fields.gap,
        fluid_pressure_gradient=peak / half_width * gradient(nodes, fields.fluid),
        rigid_approach=height * fields.approach,
        separation_min=height * lowest,
        separation_central=height * parabola_value(nodes, fields.gap, 0.0),
        rupture=half_width * rupture(nodes, fields.fluid),
        converged=converged,
        iterations=budget.sweeps,
        residual=residual,
        load_error=abs(float(weights @ (fields.fluid + fields.solid)) - LOAD) / LOAD,
        solver=solver,
        seconds=budget.used_seconds,
        residual_history=tuple(budget.history[::every]),
    )
