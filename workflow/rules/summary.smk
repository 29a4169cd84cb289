# What a run says at its end: how many points of every study that it made converged, and what is known against the others.

import sys


def written():
    """When each study's dataset was written, of those that there are."""
    paths = [
        Path(f"{results}/studies/{study}.nc")
        for results, plan in PLANS.items()
        for study in plan.studies
    ]
    return {path: path.stat().st_mtime_ns for path in paths if path.exists()}


WRITTEN_BEFORE = written()


def told(path):
    """One study's points in a line."""
    from softlub.datasets.state import convergence, flagged
    from softlub.datasets.store import read

    try:
        dataset = read(path)
    except (OSError, ValueError) as error:
        return f"{path.stem}: {path} cannot be read ({error})"
    parts = [part for part in (convergence(dataset), flagged(dataset)) if part]
    return f"{path.stem}: {' '.join(parts)}" if parts else ""


def summarise():
    """Print a line a study that this run has made."""
    made = [
        path for path, when in written().items() if WRITTEN_BEFORE.get(path) != when
    ]
    lines = [line for line in map(told, made) if line]
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
