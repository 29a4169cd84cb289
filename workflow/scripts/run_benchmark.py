"""The adapter between Snakemake and the benchmarks: a module of benchmarks/ measures, the rest is written here."""

import os
import sys
from importlib import import_module
from pathlib import Path

# Times of one thread, however many the machine has; before anything imports numpy.
for variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"):
    os.environ[variable] = "1"

job = snakemake  # noqa: F821  (Snakemake puts it there)
code = Path(job.input.code)
sys.path.insert(0, str(code.parent))

from measuring import machine  # noqa: E402

from softlub.datasets import store  # noqa: E402

module = import_module(code.stem)
arguments = dict(job.params.items())
if "parts" in dict(job.input.items()):
    arguments["parts"] = [store.read(path) for path in job.input.parts]
dataset = module.measure(**arguments)
store.write(dataset, job.output.dataset, machine())

if "failures" in dict(job.output.items()):
    module.write_failures(dataset, Path(job.output.failures))
pictures = [path for path in job.output if Path(path).suffix in (".pdf", ".png", ".svg", ".csv")]
if pictures:
    from softlub.figures.save import save

    save(module.draw(dataset), pictures)
