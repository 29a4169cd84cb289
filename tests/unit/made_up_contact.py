"""A contact that no solver made, simple enough to integrate by hand, and a solver that returns such contacts."""

from dataclasses import replace

import numpy as np

from softlub.lubrication.film import Lubricant
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.result import LubricatedContact

HALF_DOMAIN = 1e-2
LOAD = 100.0
SPEED = 0.1
VISCOSITY = 0.1


class LinearArea:
    """A law whose area is in proportion to the pressure, valid above one micrometre."""

    separation_range = (1e-6, np.inf)
    table = None

    def area_ratio(self, pressure):
        return pressure / 1e6


def problem(radius=0.1, load=LOAD):
    return Problem(HalfSpaceCylinder(radius, 1e7), LinearArea(), Lubricant(VISCOSITY), load, SPEED)


def contact(nodes=201, **changes):
    """Gap of 10 µm everywhere, triangular fluid pressure from -1 to 1 mm with the load as its area."""
    x = np.linspace(-HALF_DOMAIN, HALF_DOMAIN, nodes)
    weights = np.full(nodes, x[1] - x[0])
    weights[[0, -1]] *= 0.5
    fluid = np.maximum(0.0, 1e5 * (1 - np.abs(x) / 1e-3))
    made = LubricatedContact(
        load=LOAD,
        speed=SPEED,
        positions=x,
        weights=weights,
        fluid_pressure=fluid,
        solid_pressure=np.zeros(nodes),
        separation=np.full(nodes, 1e-5),
        fluid_pressure_gradient=np.zeros(nodes),
        rigid_approach=1e-6,
        separation_min=1e-5,
        separation_central=1e-5,
        rupture=1e-3,
        converged=True,
        iterations=3,
        residual=1e-12,
        load_error=1e-13,
        solver="made up",
    )
    return replace(made, **changes)


class Returning:
    """A solver that returns given contacts, one a speed, and remembers what it was asked."""

    def __init__(self, *contacts, order=8, finer=None):
        self.contacts = contacts
        self.order = order
        self.finer = finer
        self.asked = []

    def refined(self):
        return self.finer

    def sweep(self, problem, speeds):
        self.asked.append((problem.load, list(speeds)))
        return list(self.contacts)

    def correct(self, problem, contacts):
        self.asked.append((problem.load, [contact.speed for contact in contacts]))
        return list(self.contacts)

    def solve(self, problem, start=None):
        self.asked.append((problem.load, [problem.speed]))
        return self.contacts[0]
