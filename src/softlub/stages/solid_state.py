"""Solid state: one body pressed on the plate and slid over it, every increment recorded.

Over `increment`: `step` (its name), `step_number` (from 0), `time`, `applied_load`, `applied_friction`, `plate_height`,
`iterations`, `residual`, `converged`. Over `increment`, `node` (of the contact edge, at the reference positions `x`)
and `component` (x, y): `displacement`, `nodal_force`. Of the last increment a `mesh_dataset` with
`stress_von_mises` and `stress_vertical` of every cell. `completed` says whether all steps were gone through, and
`stop_reason` where and why not.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.solid.body import Body
from softlub.solid.history import History
from softlub.solid.mesh_dataset import mesh_dataset
from softlub.solid.plate import PlateContact
from softlub.solid.reduced_stiffness import COMPONENTS
from softlub.solid.steps import run as go_through
from softlub.solid.von_mises import von_mises
from softlub.stages import solid_bodies


def run(spec: Mapping[str, Any], inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Take a body through its steps and write what happened.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: body, contact, steps.
    inputs : mapping
        ``law``: the swept rough contact, where the plate's law comes from one; ``files``: that of a measured shape.
    outputs : sequence of Path
        The dataset.
    """
    body = solid_bodies.make_body(spec["body"], inputs.get("files", ()))
    contact = PlateContact(solid_bodies.make_law(spec["contact"], inputs.get("law", ())))
    clock = time.process_time()
    steps = solid_bodies.make_steps(spec["steps"])
    history = go_through(body, contact, steps, solid_bodies.make_stepping(spec["steps"]))
    seconds = time.process_time() - clock
    store.write(state(body, history).assign(solver_seconds=seconds), outputs[0], {"spec": dict(spec)})


def state(body: Body, history: History) -> xr.Dataset:
    """What a body went through, as a dataset (see the module)."""
    mesh, increments = body.mesh, history.increments
    count, nodes = len(increments), mesh.edge.size
    moved = np.array([one.edge_displacement for one in increments]).reshape(count, nodes, 2)
    forces = np.array([[one.shear, one.normal] for one in increments]).reshape(count, 2, nodes)
    along = ("increment", "node", "component")
    names = list(dict.fromkeys(one.step for one in increments))
    scalars = {
        "step_number": np.array([names.index(one.step) for one in increments], dtype=np.int32),
        "time": [one.time for one in increments],
        "applied_load": [one.load for one in increments],
        "applied_friction": [one.friction for one in increments],
        "plate_height": [one.plate_height for one in increments],
        "iterations": np.array([one.iterations for one in increments], dtype=np.int32),
        "residual": [one.residual for one in increments],
        "converged": np.array([one.converged for one in increments], dtype=bool),
    }
    edge = xr.Dataset(
        {
            **{name: ("increment", np.asarray(values)) for name, values in scalars.items()},
            "displacement": (along, moved),
            "nodal_force": (along, np.moveaxis(forces, 1, 2)),
            "base_gap": ("node", mesh.base_gap),
            "node_width": ("node", mesh.edge_widths),
            "completed": int(history.converged),
            "rejected_increments": history.rejected,
            "stop_reason": "" if history.failure is None else str(history.failure),
        },
        coords={
            "increment": np.arange(count),
            "step": ("increment", np.array([one.step for one in increments], dtype=str)),
            "node": np.arange(nodes),
            "x": ("node", mesh.edge_positions),
            "component": list(COMPONENTS),
        },
    )
    return edge.merge(_deformed(body, history))


def _deformed(body: Body, history: History) -> xr.Dataset:
    """All nodes and the stress at the last good increment."""
    body.forces(history.displacement)
    stress = body.stress()
    fields = {"stress_von_mises": von_mises(stress), "stress_vertical": stress[:, 1, 1]}
    return mesh_dataset(body.mesh, history.displacement, fields)
