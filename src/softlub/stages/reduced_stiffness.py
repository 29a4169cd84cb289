"""Reduced stiffness: a body condensed onto its contact edge at its initial state.

What `ReducedStiffness.dataset` holds, with `degrees_of_freedom` and `stored_entries` of the matrix that was condensed,
and `solver_seconds`.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from softlub.datasets import store
from softlub.solid.materials.moduli import material_at_frequency
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
    files, fits = inputs.get("files", ()), inputs.get("equivalence", ())
    body = solid_bodies.make_body(spec["body"], files, material(spec, fits))
    clock = time.process_time()
    reduced = ReducedStiffness.of(body)
    seconds = time.process_time() - clock
    free = body.mesh.free_dofs
    facts = {
        "degrees_of_freedom": free.size,
        "stored_entries": body.tangent()[free][:, free].nnz,
        "solver_seconds": seconds,
    }
    store.write(reduced.dataset().assign(facts), outputs[0], {"spec": dict(spec)})


def material(spec: Spec, fits: Sequence[Path]) -> Any:
    """The material without memory that is condensed."""
    made = solid_bodies.make_material(spec["body"]["material"])
    if "frequency" in spec:
        return material_at_frequency(made, spec["frequency"])
    rest = solid_bodies.at_rest(made)
    return rest.scaled(float(store.read(fits[0])["coefficient"])) if fits else rest
