"""The comparison with other projects on a surface with waves down to two points, as the source's tables have them.

Such a surface is the harder one for solvers that begin on coarser grids, ours and ASPHER: these know nothing of its
shortest waves. Only the quickest of the others are run.
"""

import peers_drawing
import xarray as xr
from contact_errors import quickest, surface
from contact_solvers import OURS, all_solvers
from peers_size import compare

from softlub.figures.panel import DataFigure

POINTS, SHORTEST_WAVE = 1024, 2
COMPARED = (OURS, "ASPHER", "tamaas, system's FFTW")
ALL_LOADS = (OURS, "ASPHER")
"""The others take more than a minute at some loads: they are run at one."""


def measure(python: str) -> xr.Dataset:
    """Runs over `solver`, `points` (one), `load` and `step`, and ratios of the quickest to ours."""
    solvers = {name: solver for name, solver in all_solvers(python).items() if name in COMPARED}
    for name in set(solvers) - set(ALL_LOADS):
        solvers[name] = solvers[name]._replace(loads_to=POINTS // 2)
    runs = compare(solvers, surface(POINTS, SHORTEST_WAVE)).expand_dims(points=[POINTS])
    title = f"Rough contact beside other projects' solvers, waves down to {SHORTEST_WAVE} points"
    return with_ratios(runs).assign_attrs(title=title)


def with_ratios(runs: xr.Dataset) -> xr.Dataset:
    """The runs, and the CPU time of the quickest within the limits over ours."""
    seconds = quickest(runs)["cpu_time"]
    return runs.assign(quickest_cpu_time=seconds, cpu_time_ratio=seconds / seconds.sel(solver=OURS))


def draw(dataset: xr.Dataset) -> DataFigure:
    """Gap error over CPU time."""
    return peers_drawing.one_grid(dataset, "gap_error")
