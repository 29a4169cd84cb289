"""Study of a body pressed on a plate: finite elements, and what stands for them, under the same nodal forces.

Over the swept fields and `load`, then:

- `method` (``full`` and those compared: ``reduced``, ``constrained``), `node`, `component` (x, y): `displacement` of
  the contact edge at the end, the holder at rest; over `method`: `displacement_error`, the largest difference from
  ``full`` over the largest displacement; over `method` and `component`: `displacement_error_component`, each component
  over its own largest;
- `datum`, `node`, `component`: `displacement_half_space`, of a half-plane whose displacement is 0 at that distance from
  a line load; `displacement_half_space_error` and `displacement_half_space_error_component` likewise;
- `node`, `component`: `nodal_force`; `node`: `contact_pressure`; over neither: `applied_load` and
  `applied_friction` (those reached; a body that stopped falls short), `plate_height`, `converged` (all
  steps gone through), `iterations`, `increments`, `rejected_increments`, `residual`, `solver_seconds`, `stop_reason`,
  `reaches_edge_end` (1 where the contact goes beyond the contact edge, which is too narrow for it).

Over the swept fields: `x` and `node_width` of every node, `stiffness_diagonal` and `stiffness_apex_row` (entries of K_r
in the row of the apex) over `node` and `component`, `degrees_of_freedom`, `stored_entries`, `condensation_seconds`.
``outputs: [mesh]`` keeps `mesh_point`, `mesh_cell`, `mesh_edge`, `mesh_held` and over `load` `mesh_displacement`,
`stress_von_mises`, `stress_vertical`; ``[history]`` what a state records over `increment`, its names ending in
``_history``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.references.half_plane import surface_displacement
from softlub.solid.materials.viscoelastic import at_rest
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.stages import solid_bodies, solid_tables
from softlub.stages.surface_study import swept

Spec = Mapping[str, Any]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Join states and stiffnesses and write the study's dataset.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: sweeps, load, compare, datum, keep; and for every scene which states and which
        stiffness it reads, its penalty and its material.
    inputs : mapping
        ``state`` and ``stiffness``: files in the plan's order.
    outputs : sequence of Path
        The dataset.
    """
    states = [store.read(path).drop_attrs(deep=False) for path in inputs["state"]]
    stiffnesses = [store.read(path).drop_attrs(deep=False) for path in inputs.get("stiffness", ())]
    rows = []
    for index, places in enumerate(spec["states"]):
        stiffness = spec["stiffnesses"][index]
        own = None if stiffness is None else stiffnesses[stiffness]
        under_load = [_one(spec, index, states[place], own) for place in places]
        joined = solid_tables.over_loads(under_load, spec["load"])
        rows.append(joined if own is None else joined.merge(solid_tables.stiffness_entries(own)))
    store.write(swept(rows, spec["sweeps"], solid_tables.PADDED).set_coords("x"), outputs[0], dict(spec))


def _one(spec: Spec, index: int, state: xr.Dataset, stiffness: xr.Dataset | None) -> xr.Dataset:
    """One state, and what the others make of its nodal forces."""
    dataset = solid_tables.final(state, spec["keep"])
    full, forces = dataset["displacement"].values, dataset["nodal_force"].values
    found = {"full": full}
    if stiffness is not None:
        reduced = ReducedStiffness.from_dataset(stiffness)
        makers = {
            "reduced": lambda: reduced,
            "constrained": lambda: constrained(reduced, spec["penalties"][index]),
        }
        found |= {
            name: solid_tables.reduced_displacement(makers[name](), forces)
            for name in spec["compare"]
            if name in makers
        }
    dataset = dataset.assign(solid_tables.compared(found, "method"))
    if "half_space" not in spec["compare"]:
        return dataset
    resting = at_rest(solid_bodies.make_material(spec["materials"][index]))
    planes = {datum: half_plane(dataset, resting, datum) for datum in spec["datum"]}
    theory = solid_tables.compared({"full": full, **planes}, "datum", "displacement_half_space")
    # Labels that begin with a word are words all; those of the planes are lengths.
    lengths = {"datum": np.array(spec["datum"], dtype=float)}
    return dataset.assign(
        {name: value.isel(datum=slice(1, None)).assign_coords(lengths) for name, value in theory.items()}
    )


def constrained(reduced: ReducedStiffness, penalty: float | None) -> ReducedStiffness:
    """K_r with the hard contact left on where nodes touch the plate without load; its friction is left out."""
    assert penalty is not None, "checked when the study was read"
    return reduced.with_contact(np.where(reduced.base_gap == 0, penalty * reduced.widths, 0.0))


def half_plane(state: xr.Dataset, material: Any, datum: float) -> np.ndarray:
    """Displacement of a half-plane under a state's nodal forces, spread over the nodes' widths [m], shape (k, 2)."""
    x, width = state["x"].values, state["node_width"].values
    middles = (x[1:] + x[:-1]) / 2
    traction = state["nodal_force"].values / width[:, None]
    return surface_displacement(
        np.concatenate([x[:1], middles, x[-1:]]),
        traction[:, 1],
        traction[:, 0],
        material.young_modulus,
        material.poisson_ratio,
        datum,
        x,
    )
