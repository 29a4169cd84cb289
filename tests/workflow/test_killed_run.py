"""A run killed in the middle leaves nothing half-written, and the next one finishes with the same data."""

import os
import signal
import time

import xarray as xr


def test_killed_run_is_finished_by_the_next_with_the_same_data(workspace, tmp_path):
    workspace.write(points=40)
    process = workspace.start("--nolock")
    deadline = time.monotonic() + 120
    # The moment between the panel and what follows from it: some work done, some in flight.
    while not workspace.made("panel/*.nc") and process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert not workspace.made("figures/tiny/*.png"), "the run ended before it could be killed"

    resumed = workspace.run("--nolock")
    assert resumed.returncode == 0, resumed.stderr[-3000:]
    assert not workspace.made("**/*.part")
    with xr.open_dataset(workspace.made("studies/tiny.nc")[0]) as dataset:
        after_kill = dataset.drop_vars("solver_seconds").load()

    for path in workspace.made("**/*.nc"):
        path.unlink()
    undisturbed = workspace.run("--nolock")
    assert undisturbed.returncode == 0, undisturbed.stderr[-3000:]
    with xr.open_dataset(workspace.made("studies/tiny.nc")[0]) as dataset:
        xr.testing.assert_identical(after_kill, dataset.drop_vars("solver_seconds").load())


def test_lock_is_held_by_the_kernel_and_dropped_with_the_process(tmp_path):
    import subprocess
    import sys

    from conftest import ROOT

    script = [sys.executable, str(ROOT / "workflow" / "scripts" / "run_locked.py"), str(tmp_path / "lock")]
    holder = subprocess.Popen(
        [*script, sys.executable, "-c", "import time; print('held', flush=True); time.sleep(60)"],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert holder.stdout.readline().strip() == "held"
    refused = subprocess.run([*script, "true"], capture_output=True, text=True)
    assert refused.returncode != 0
    assert "another run" in refused.stderr
    holder.kill()
    holder.wait()
    holder.stdout.close()
    assert subprocess.run([*script, "true"]).returncode == 0
