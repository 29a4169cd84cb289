# What a run says at its end: how many points of every study that it made converged, and what is known against the others.

import sys
import time

BEGAN = time.time()


def studies_made():
    """Datasets of the studies asked for that this run has written."""
    paths = [
        Path(f"{results}/studies/{study}.nc")
        for results, plan in PLANS.items()
        for study in plan.studies
    ]
    return [path for path in paths if path.exists() and path.stat().st_mtime >= BEGAN]


def told(path):
    """One study's points in a line."""
    from softlub.datasets.state import convergence, flagged
    from softlub.datasets.store import read

    dataset = read(path)
    parts = [part for part in (convergence(dataset), flagged(dataset)) if part]
    return f"{path.stem}: {' '.join(parts)}" if parts else ""


def summarise():
    """Print the lines of all studies made."""
    lines = [line for line in map(told, studies_made()) if line]
    if lines:
        print("", *lines, sep="\n", file=sys.stderr)
        if any(" flagged: " in line for line in lines):
            print(
                "What the flags mean stands in the captions and in docs/how-it-works.md.",
                file=sys.stderr,
            )


onsuccess:
    summarise()


onerror:
    summarise()
