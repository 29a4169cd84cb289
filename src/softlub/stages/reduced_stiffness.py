"""Reduced stiffness: a body condensed onto its contact edge at its initial state.

What `ReducedStiffness.dataset` holds, with `degrees_of_freedom` and `stored_entries` of the matrix that was condensed,
and `solver_seconds`.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.solid.materials.moduli import material_at_frequency
from softlub.solid.materials.viscoelastic import at_rest
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.stages import solid_bodies

Spec = Mapping[str, Any]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Condense a body and write its stiffness.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: body and, for the storage modulus at some frequency, ``frequency`` [rad/s].
    inputs : mapping
        ``equivalence``: a fit whose coefficient the material is scaled with; ``files``: that of a measured shape.
    outputs : sequence of Path
        The dataset.
    """
    fits = inputs.get("equivalence", ())
    coefficient = float(store.read(fits[0])["coefficient"]) if fits else None
    known = coefficient is None or np.isfinite(coefficient)
    made = material(spec, coefficient if known else None)
    body = solid_bodies.make_body(spec["body"], inputs.get("files", ()), made)
    clock = time.process_time()
    dataset = ReducedStiffness.of(body).dataset()
    seconds = time.process_time() - clock
    if not known:
        # A search that found nothing is told as such, and stops no other body's study.
        dataset = dataset.assign(stiffness=xr.full_like(dataset["stiffness"], np.nan))
    free = body.mesh.free_dofs
    facts = {
        "degrees_of_freedom": free.size,
        "stored_entries": body.tangent()[free][:, free].nnz,
        "solver_seconds": seconds,
    }
    store.write(dataset.assign(facts), outputs[0], {"spec": dict(spec)})


def material(spec: Spec, coefficient: float | None) -> Any:
    """The material without memory that is condensed, scaled by an equivalence coefficient where there is one."""
    made = solid_bodies.make_material(spec["body"]["material"])
    if "frequency" in spec:
        return material_at_frequency(made, spec["frequency"])
    rest: Any = at_rest(made)
    return rest if coefficient is None else rest.scaled(coefficient)
