"""Equilibrium of a body pressed on the plate: Newton's method for the displacement and the plate's height together.

Unknown are the displacements of the free nodes and, where the load is given, the height d of the plate:

    f(u) - c(u, d) = 0,    Σ N(u, d) = W,

f the body's nodal forces, c the contact's, N their normal part. The plate's row and column border the body's sparse
matrix K; one factorisation serves two right-hand sides, a = K⁻¹(f - c) and b = K⁻¹ ∂(f - c)/∂d, after which
δu = -a - b δd and the load decides δd. Hard contact is piecewise linear, and Newton's method on it the usual
active-set method: a node is in contact in the next step if it penetrates after this one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from softlub.solid.control import Control
from softlub.solid.elements import ElementInverted
from softlub.solid.free_system import FreeSystem, SingularStiffness
from softlub.solid.plate import PlateContact, PlateForces

if TYPE_CHECKING:
    from softlub.solid.body import Body

FloatArray = NDArray[np.float64]

ROUNDING = 4 * np.finfo(float).eps
"""Part of stiffness times displacement that no nodal force is more accurate than."""


@dataclass(frozen=True)
class NewtonSettings:
    """When Newton's method stops, and how far it may step.

    Parameters
    ----------
    tolerance : float, optional
        Largest unbalanced force of a solution, in units of the largest nodal force; rounding (a few times 1e-16 of
        stiffness times displacement) is allowed besides.
    most_iterations : int, optional
        Steps after which to give up.
    largest_step : float, optional
        Longest change of any displacement in one step, in units of the body's height.
    most_halvings : int, optional
        How often a step that turns an element inside out is halved.
    """

    tolerance: float = 1e-9
    most_iterations: int = 20
    largest_step: float = 0.1
    most_halvings: int = 6


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Where Newton's method ended.

    Attributes
    ----------
    displacement : ndarray, shape (n, 2)
        Of all nodes [m].
    plate_height : float
        d [m].
    contact : PlateForces
        At that state.
    converged : bool
    iterations : int
        Newton steps taken; each is one assembly and one factorisation.
    evaluations : int
        Nodal forces evaluated, those of halved steps included.
    residual : float
        Largest unbalanced nodal force over the largest nodal force.
    history : tuple of float
        The residual before each step and at the end.
    reason : str
        Why it did not converge; empty where it did.
    """

    displacement: FloatArray
    plate_height: float
    contact: PlateForces
    converged: bool
    iterations: int
    evaluations: int
    residual: float
    history: tuple[float, ...]
    reason: str


@dataclass(frozen=True, eq=False)
class _Iterate:
    displacement: FloatArray
    height: float
    forces: FloatArray
    contact: PlateForces
    unbalanced: FloatArray  # f - c at the free degrees of freedom
    missing_load: float
    scale: float

    @property
    def residual(self) -> float:
        return max(float(np.abs(self.unbalanced).max()), abs(self.missing_load)) / self.scale


class EquilibriumSolver:
    """Newton's method on one body, keeping what every solution shares.

    Parameters
    ----------
    body : Body
    settings : NewtonSettings, optional
    """

    def __init__(self, body: Body, settings: NewtonSettings | None = None) -> None:
        self.body = body
        self.settings = settings or NewtonSettings()
        mesh = body.mesh
        tangent = body.tangent()
        self._system = FreeSystem(tangent, mesh.free_dofs)
        self._place = np.full(2 * len(mesh.points), -1)
        self._place[mesh.free_dofs] = np.arange(mesh.free_dofs.size)
        self._longest = self.settings.largest_step * float(np.ptp(mesh.points[:, 1]))
        edge = np.asarray(mesh.edge)
        self._normal_entries = self._system.entries(2 * edge + 1, 2 * edge + 1)
        self._shear_entries = self._system.entries(2 * edge, 2 * edge + 1)
        self._edge_shear, self._edge_normal = self._place[2 * edge], self._place[2 * edge + 1]

    def solve(
        self, contact: PlateContact, control: Control, displacement: FloatArray, plate_height: float
    ) -> Equilibrium:
        """Find the equilibrium near a start.

        Parameters
        ----------
        contact : PlateContact
        control : Control
            `softlub.solid.control.HeightControl` or `LoadControl`.
        displacement : ndarray, shape (n, 2)
            Where to start, the held nodes as they stay [m].
        plate_height : float
            Where the plate starts if its load is given [m].

        Returns
        -------
        Equilibrium
            Converged or not; nothing is raised on a hard problem.
        """
        before = self.body.evaluations
        history: list[float] = []
        height = control.height(plate_height)
        try:
            iterate = self._evaluate(contact, control, displacement, height)
        except ElementInverted as error:
            lost = contact.forces(self.body.mesh, displacement, height)
            return Equilibrium(displacement, height, lost, False, 0, 1, np.inf, (np.inf,), str(error))
        reason, converged, rounding = "", False, 0.0
        while True:
            history.append(iterate.residual)
            converged = iterate.residual <= self.settings.tolerance + rounding / iterate.scale
            reason = "" if converged else self._hopeless(history)
            if converged or reason:
                break
            try:
                iterate, rounding = self._step(contact, control, iterate)
            except (ElementInverted, SingularStiffness) as error:
                reason = str(error)
                break
        return Equilibrium(
            iterate.displacement,
            iterate.height,
            iterate.contact,
            converged,
            len(history) - 1,
            self.body.evaluations - before,
            history[-1],
            tuple(history),
            reason,
        )

    def _hopeless(self, history: list[float]) -> str:
        """Why to give up, or nothing."""
        if not np.isfinite(history[-1]):
            return "Newton's method diverged: the forces are not finite"
        if len(history) > self.settings.most_iterations:
            return (
                f"no convergence in {self.settings.most_iterations} iterations (residual {history[-1]:.1e})"
            )
        return ""

    def _evaluate(
        self, contact: PlateContact, control: Control, displacement: FloatArray, height: float
    ) -> _Iterate:
        forces = self.body.forces(displacement)
        plate = contact.forces(self.body.mesh, displacement, height)
        unbalanced = forces[self._system.free]
        unbalanced[self._edge_shear] -= plate.shear
        unbalanced[self._edge_normal] -= plate.normal
        missing = control.imbalance(plate.load)
        largest = max(float(np.abs(forces).max()), float(plate.normal.max(initial=0.0)), abs(missing))
        scale = largest or 1.0  # nothing acts anywhere
        return _Iterate(displacement, height, forces, plate, unbalanced, missing, scale)

    def _step(self, contact: PlateContact, control: Control, start: _Iterate) -> tuple[_Iterate, float]:
        """One Newton step, capped, and halved as long as it turns an element inside out."""
        change, rise, rounding = self._direction(control, start)
        part = min(1.0, self._longest / max(float(np.abs(change).max()), abs(rise), np.finfo(float).tiny))
        for _ in range(self.settings.most_halvings):
            try:
                displacement = start.displacement + part * change
                return self._evaluate(contact, control, displacement, start.height + part * rise), rounding
            except ElementInverted:
                part /= 2
        displacement = start.displacement + part * change
        return self._evaluate(contact, control, displacement, start.height + part * rise), rounding

    def _direction(self, control: Control, start: _Iterate) -> tuple[FloatArray, float, float]:
        """Newton's changes of displacement (n, 2) and height, and the rounding of nodal forces [N/m]."""
        plate = start.contact
        data = self._with_contact(plate)
        rounding = ROUNDING * float(np.abs(data).max() * np.abs(start.displacement).max())
        by_height = np.zeros(self._system.free.size)
        by_height[self._edge_normal] = -plate.stiffness
        by_height[self._edge_shear] = -plate.friction * plate.stiffness
        factors = self._system.factorise(data)
        at_rest, per_rise = factors.solve(np.column_stack([start.unbalanced, by_height])).T
        # dN = Σ k (δd - δu_y) with δu = -a - b δd.
        missing = start.missing_load - plate.stiffness @ at_rest[self._edge_normal]
        rise = control.rise(missing, plate.stiffness @ (1 + per_rise[self._edge_normal]))
        change = np.zeros(start.displacement.size)
        change[self._system.free] = -at_rest - rise * per_rise
        return change.reshape(-1, 2), rise, rounding

    def _with_contact(self, plate: PlateForces) -> FloatArray:
        """Entries of the tangent of body and contact, in the pattern's order."""
        data: FloatArray = self.body.tangent().data
        data[self._normal_entries] += plate.stiffness
        data[self._shear_entries] += plate.friction * plate.stiffness
        return data
