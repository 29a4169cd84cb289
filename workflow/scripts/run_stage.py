"""The one adapter between Snakemake and the stages: a rule's spec and files go to the stage that its spec names."""

from importlib import import_module
from pathlib import Path


def paths(files):
    """Paths of a named input, which Snakemake gives as a list or, where it is one file, as a string."""
    return [Path(path) for path in ([files] if isinstance(files, str) else files)]


job = snakemake  # noqa: F821  (Snakemake puts it there)
import_module(f"softlub.stages.{job.params.spec['stage']}").run(
    spec=job.params.spec,
    inputs={name: paths(files) for name, files in job.input.items()},
    outputs=[Path(path) for path in job.output],
)
