"""Panel: one scene, swept over any of its fields, all loads and all speeds, by one solver, in one job."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.lubrication.solvers import finer, make_solver
from softlub.lubrication.speed_sweep import Arrays, dimensions, stack, sweep_arrays
from softlub.protocols import Compliance
from softlub.solid.compliance import MeshedCompliance
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.stages import scene as scenes
from softlub.stages.design import sample_points
from softlub.stages.scene import Scene
from softlub.stages.tabulated import SweptSurface, read_law

Spec = Mapping[str, Any]
Variables = dict[str, tuple[tuple[str, ...], np.ndarray]]


class Read(NamedTuple):
    """What one scene reads: the rough contact of a tabulated law, the compliance of finite elements."""

    law: SweptSurface | None = None
    body: Compliance | None = None


Case = tuple[Scene, Read]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Solve the panel and write its dataset.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: scene, sweeps or sample, load, speed, solver, fields, and which law and which
        stiffness each scene reads, where one does.
    inputs : mapping
        ``law``: swept rough contacts; ``stiffness``: reduced stiffnesses; both in the plan's order.
    outputs : sequence of Path
        The dataset.
    """
    laws = [read_law(path) for path in inputs.get("law", ())]
    bodies = [_compliance(path) for path in inputs.get("stiffness", ())]
    read = [
        Read(None if law is None else laws[law], None if body is None else bodies[body])
        for law, body in itertools.zip_longest(spec.get("laws", ()), spec.get("stiffnesses", ()))
    ]
    dataset = sampled(spec, read) if spec.get("sample") else gridded(spec, read)
    store.write(dataset, outputs[0], {"spec": dict(spec)})


def _compliance(path: Path) -> Compliance:
    return MeshedCompliance.of(ReducedStiffness.from_dataset(store.read(path)))


def gridded(spec: Spec, read: Sequence[Read] = ()) -> xr.Dataset:
    """Scene swept over the product of given values; dimensions: the sweeps, load, speed, node."""
    sweeps = spec["sweeps"]
    shape = tuple(len(sweep["values"]) for sweep in sweeps)
    leading = tuple(sweep["dimension"] for sweep in sweeps)
    swept = _cases(_swept_scenes(spec), read)
    curves = stack([_solve(spec, case, spec["load"]) for case in swept])
    variables: Variables = {
        name: (leading + dimensions(name), values.reshape(shape + values.shape[1:]))
        for name, values in curves.items()
    }
    variables |= {name: (leading, values.reshape(shape)) for name, values in _parameters(swept).items()}
    variables |= {
        name: ((*leading, "load"), values.reshape((*shape, -1)))
        for name, values in _domains(swept, [spec["load"]] * len(swept)).items()
    }
    labels = {sweep["dimension"]: np.array(sweep["labels"]) for sweep in sweeps}
    return _dataset(variables, labels | {"load": np.array(spec["load"]), "speed": np.array(spec["speed"])})


def sampled(spec: Spec, read: Sequence[Read] = ()) -> xr.Dataset:
    """Scenes drawn from ranges; dimensions: sample, speed, node; the drawn values stand beside the results."""
    points = sample_points(spec["sample"])
    loads = points.pop("load", None)
    if loads is None:
        loads = np.full(spec["sample"]["size"], spec["load"][0])
    drawn = _cases(
        [_drawn_scene(spec["scene"], points, index) for index in range(len(loads))], [*read] * len(loads)
    )
    curves = stack([_solve(spec, case, [load]) for case, load in zip(drawn, loads, strict=True)])
    variables: Variables = {
        name: (("sample", *dimensions(name)[1:]), values[:, 0]) for name, values in curves.items()
    }
    described = _parameters(drawn) | {path.rpartition(".")[2]: values for path, values in points.items()}
    described |= {name: values[:, 0] for name, values in _domains(drawn, loads[:, None]).items()}
    variables |= {name: (("sample",), values) for name, values in described.items()}
    first = spec["sample"]["first"]
    coordinates = {"sample": np.arange(first, first + len(loads)), "speed": np.array(spec["speed"])}
    return _dataset(variables, coordinates).assign_coords(load=("sample", loads))


def _swept_scenes(spec: Spec) -> list[Scene]:
    scenes_so_far = [spec["scene"]]
    for sweep in spec["sweeps"]:
        pairs = itertools.product(scenes_so_far, sweep["values"])
        scenes_so_far = [scenes.with_value(scene, sweep["path"], value) for scene, value in pairs]
    return scenes_so_far


def _drawn_scene(scene: Scene, points: Mapping[str, np.ndarray], index: int) -> Scene:
    for path, values in points.items():
        scene = scenes.with_value(scene, path, float(values[index]))
    return scene


def _cases(swept: Sequence[Scene], read: Sequence[Read]) -> list[Case]:
    return list(zip(swept, read or [Read()] * len(swept), strict=True))


def _solve(spec: Spec, case: Case, loads: Sequence[float]) -> Arrays:
    scene, read = case
    solver = make_solver(**spec["solver"])
    problem = scenes.problem(scene, loads[0], spec["speed"][0], *read)
    return sweep_arrays(problem, loads, spec["speed"], solver, finer(solver), fields=spec["fields"])


def _parameters(cases: Sequence[Case]) -> dict[str, np.ndarray]:
    """What later stages and figures need to know of every curve's scene."""
    return {
        "viscosity": np.array([scene["lubricant"]["viscosity"] for scene, _ in cases]),
        "rms_roughness": np.array([scenes.rms_roughness(scene, read.law) for scene, read in cases]),
        "long_term_modulus": np.array([scenes.material(scene).long_term_modulus for scene, _ in cases]),
        "plane_strain_modulus": np.array([scenes.material(scene).plane_strain_modulus for scene, _ in cases]),
        "radius": np.array([scenes.problem(scene, 1.0, 1.0, *read).body.radius for scene, read in cases]),
    }


def _domains(cases: Sequence[Case], loads: Sequence[Sequence[float]] | np.ndarray) -> dict[str, np.ndarray]:
    """Domain and dry half-width of every curve at each of its loads, shape (curves, loads)."""
    contacts = [
        [scenes.problem(scene, load, 1.0, *read) for load in row]
        for (scene, read), row in zip(cases, loads, strict=True)
    ]
    return {
        "half_domain": np.array([[contact.domain for contact in row] for row in contacts]),
        "hertz_half_width": np.array([[contact.hertz.half_width for contact in row] for row in contacts]),
    }


def _dataset(variables: Variables, coordinates: dict[str, np.ndarray]) -> xr.Dataset:
    fields = {"x": variables.pop("x")} if "x" in variables else {}
    # A swept parameter is its own coordinate already.
    own = {name: value for name, value in variables.items() if name not in coordinates}
    return store.describe(xr.Dataset(own, coords=coordinates | fields))
