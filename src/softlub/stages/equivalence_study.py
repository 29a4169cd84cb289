"""Study of equivalent bodies: a viscoelastic body, the fitted hyperelastic one, and others with given coefficients.

Over the swept fields, `load` and `model` (``viscoelastic``, ``fitted``, ``alpha=1.5`` …): `coefficient`,
`shape_difference` and `shape_difference_normalised` from the viscoelastic body, `converged`, `plate_height`,
`iterations`, `stop_reason`, `reaches_edge_end`; over `node` besides `contact_pressure`, and over `component`
`displacement`, `nodal_force` and `displacement_reduced`, what the model's K_r makes of the viscoelastic body's nodal
forces, with `displacement_reduced_error` and, over `component`, `displacement_reduced_error_component` as in the study
of solids; the viscoelastic body has no stiffness of its own, and NaN there. Over `load` alone `shape_difference_rigid`,
what a body that does not deform scores, and `fit_converged`; over `run` `tried_coefficient` and `tried_difference`.
``outputs`` as in the study of solids.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.solid.equivalence import normalised_shape_difference, shape_difference
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.stages import solid_tables
from softlub.stages.surface_study import swept

Spec = Mapping[str, Any]
FIT = ("tried_coefficient", "tried_difference", "fit_converged")


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Join states, fits and stiffnesses and write the study's dataset.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: sweeps, load, coefficients, keep; and for every scene and load (``rows``) which
        states, fit and stiffnesses it reads.
    inputs : mapping
        ``state``, ``equivalence`` and ``stiffness``: files in the plan's order.
    outputs : sequence of Path
        The dataset.
    """
    files = {kind: [store.read(path).drop_attrs(deep=False) for path in inputs[kind]] for kind in inputs}
    rows = []
    for scene in spec["rows"]:
        under_load = [_one(spec, places, files) for places in scene]
        rows.append(solid_tables.over_loads(under_load, spec["load"]))
    dataset = swept(rows, spec["sweeps"], solid_tables.PADDED)
    store.write(dataset.set_coords("x"), outputs[0], dict(spec))


def _one(spec: Spec, places: Mapping[str, Any], files: Mapping[str, Sequence[xr.Dataset]]) -> xr.Dataset:
    """The bodies of one scene under one load, along `model`."""
    fit = files["equivalence"][places["fitted"]]
    given = [files["state"][place] for place in places["given"]]
    labels = ["viscoelastic", "fitted", *(f"alpha={value:g}" for value in spec["coefficients"])]
    states = [files["state"][places["viscoelastic"]], fit, *given]
    coefficients = [np.nan, float(fit["coefficient"]), *spec["coefficients"]]
    ends = [solid_tables.final(state, spec["keep"]) for state in states]
    dataset = solid_tables.along(ends, "model", labels).assign(coefficient=("model", coefficients))
    forces = dataset["nodal_force"].isel(model=0).values
    stiffnesses = [
        files["stiffness"][place] for place in (places["stiffness_fitted"], *places["stiffness_given"])
    ]
    reduced = [ReducedStiffness.from_dataset(one) for one in stiffnesses]
    moved = [solid_tables.reduced_displacement(one, forces) for one in reduced]
    return dataset.assign(
        {
            **_differences(dataset["displacement"].where(dataset["converged"]).values),
            **_reduced(dataset["displacement"].isel(model=0).values, moved, labels),
            **{name: fit[name] for name in FIT},
        }
    )


def _differences(shapes: np.ndarray) -> dict[str, Any]:
    """Equation 5-16 of every model against the first, and of a rigid body [m²]; NaN shapes give NaN."""
    reference, others = shapes[0], shapes[1:]
    plain = [shape_difference(shape, reference) for shape in others]
    normalised = [normalised_shape_difference(shape, reference) for shape in others]
    return {
        "shape_difference": ("model", np.array([np.nan, *plain])),
        "shape_difference_normalised": ("model", np.array([np.nan, *normalised])),
        "shape_difference_rigid": shape_difference(np.zeros_like(reference), reference),
    }


def _reduced(full: np.ndarray, moved: Sequence[np.ndarray], labels: Sequence[str]) -> dict[str, Any]:
    """Displacements by reduced stiffnesses, and how far they are from the viscoelastic body's."""
    table = solid_tables.compared(
        dict(zip(labels, [full, *moved], strict=True)), "model", "displacement_reduced"
    )
    whole = table["displacement_reduced"].values.copy()
    whole[0] = np.nan
    errors = {
        name: (value.dims, value.values) for name, value in table.items() if name != "displacement_reduced"
    }
    return {"displacement_reduced": (("model", *solid_tables.ALONG), whole), **errors}
