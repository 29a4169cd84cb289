"""Equivalence fit: the hyperelastic body that ends the same steps in a viscoelastic one's shape.

The state of the best run as `softlub.stages.solid_state` tells it, with `coefficient`, `shape_difference`,
`shape_difference_normalised`, `fit_converged`, and over `run` every `tried_coefficient` and `tried_difference`. Where
the viscoelastic body or one of the runs did not complete its steps there is no shape to fit: `coefficient` is NaN,
`completed` 0, and `stop_reason` says why.
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
from softlub.solid.equivalence import EquivalentModel, final_shape, fit_coefficient
from softlub.solid.history import History
from softlub.solid.plate import PlateContact
from softlub.solid.steps import run as go_through
from softlub.stages import solid_bodies
from softlub.stages.solid_state import state

Spec = Mapping[str, Any]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Search the coefficient and write the body that it gives.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: body (its material at rest), contact, steps, bounds.
    inputs : mapping
        ``state``: the viscoelastic body; ``law``, ``files`` as of a state.
    outputs : sequence of Path
        The dataset.
    """
    reference = store.read(inputs["state"][0])
    clock = time.process_time()
    trial = Trial(spec, inputs)
    found, reason = None, str(reference["stop_reason"].item())
    if not reason:
        target = reference["displacement"].isel(increment=-1).values
        try:
            found = fit_coefficient(target, trial.shape, bounds=tuple(spec["bounds"]))
        except ValueError as error:
            reason = str(error)
    dataset = trial.state(1.0 if found is None else found.coefficient)
    seconds = time.process_time() - clock
    dataset = dataset.assign({**_facts(found, reason), "solver_seconds": seconds})
    dataset = dataset.assign_coords(run=np.arange(dataset.sizes["run"]))
    store.write(dataset, outputs[0], {"spec": dict(spec)})


class Trial:
    """Runs of the hyperelastic body by its coefficient.

    Parameters
    ----------
    spec, inputs : mapping
        As of `run`.
    """

    def __init__(self, spec: Spec, inputs: Mapping[str, Sequence[Path]]) -> None:
        self._rest = solid_bodies.make_material(spec["body"]["material"])
        self._mesh = solid_bodies.make_mesh(spec["body"], inputs.get("files", ()))
        self._element = spec["body"]["element"]
        self._contact = PlateContact(solid_bodies.make_law(spec["contact"], inputs.get("law", ())))
        self._steps = solid_bodies.make_steps(spec["steps"])
        self._done: dict[float, tuple[Body, History]] = {}

    def shape(self, coefficient: float) -> np.ndarray:
        """Final displacement of the edge [m], shape (k, 2); ValueError where the steps were not completed."""
        return final_shape(self._run(coefficient)[1])

    def state(self, coefficient: float) -> xr.Dataset:
        """What one run went through."""
        return state(*self._run(coefficient))

    def _run(self, coefficient: float) -> tuple[Body, History]:
        if coefficient not in self._done:
            body = Body(self._mesh, self._rest.scaled(coefficient), self._element)
            self._done[coefficient] = body, go_through(body, self._contact, self._steps)
        return self._done[coefficient]


def _facts(found: EquivalentModel | None, reason: str) -> dict[str, Any]:
    """What the search came to, beside the body itself."""
    if found is None:
        return {
            "coefficient": np.nan,
            "shape_difference": np.nan,
            "shape_difference_normalised": np.nan,
            "fit_converged": 0,
            "completed": 0,
            "tried_coefficient": ("run", np.empty(0)),
            "tried_difference": ("run", np.empty(0)),
            "stop_reason": reason,
        }
    return {
        "coefficient": found.coefficient,
        "shape_difference": found.shape_difference,
        "shape_difference_normalised": found.normalised,
        "fit_converged": int(found.converged and found.at_bound is None),
        "tried_coefficient": ("run", found.coefficients),
        "tried_difference": ("run", found.differences),
    }
