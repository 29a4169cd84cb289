"""A study of one's own, from anywhere, through the whole workflow."""

import xarray as xr


def jobs_run(result) -> dict[str, int]:
    """Jobs by rule from Snakemake's own table, printed before it starts."""
    lines = result.stderr.splitlines() + result.stdout.splitlines()
    table = {}
    for line in lines:
        words = line.split()
        if len(words) == 2 and words[1].isdigit() and words[0] != "total":
            table[words[0]] = int(words[1])
    return table


def test_study_gives_dataset_and_figure_and_reruns_only_what_changed(workspace):
    workspace.write()
    first = workspace.run()
    assert first.returncode == 0, first.stderr[-3000:]
    with xr.open_dataset(workspace.made("studies/tiny.nc")[0]) as dataset:
        assert dataset.sizes["speed"] == 5
        assert bool((dataset["converged"] == 1).all())
        assert float(dataset["friction_coefficient"].max()) < 1
        assert dataset["friction_coefficient"].attrs["units"] == "1"
    names = {path.suffix for path in workspace.made("figures/tiny/*")}
    assert names >= {".pdf", ".png", ".svg", ".csv"}

    told = "tiny: All 5 points converged."
    assert told in first.stderr

    unchanged = workspace.run()
    assert "Nothing to be done" in unchanged.stderr + unchanged.stdout
    assert told not in unchanged.stderr

    workspace.write(shear="0.2 E")
    sheared = workspace.run("--dry-run")
    assert sheared.returncode == 0, sheared.stderr[-3000:]
    assert "panel" not in jobs_run(sheared)
    assert jobs_run(sheared)["study"] == 1

    workspace.write(points=6)
    regridded = workspace.run("--dry-run")
    assert jobs_run(regridded)["panel"] == 1


def test_bad_study_is_refused_before_any_job_with_one_message(workspace):
    workspace.write(shear="0,1 E")
    refused = workspace.run()
    said = refused.stderr + refused.stdout
    assert refused.returncode != 0
    assert "tiny.yaml" in said
    assert "shear_strength" in said
    assert "Traceback" not in said
    assert not workspace.made("**/*.nc")
