# What one asks for by name.


def everything(results, chapter=None):
    """Datasets, figures and tables of all studies asked for, or of one chapter's."""
    plan = PLANS[results]
    wanted = [
        study
        for study in plan.studies
        if chapter is None or plan.chapters.get(study) == chapter
    ]
    nodes = [plan.node("study", study) for study in wanted]
    nodes += [figure for study in wanted for figure in plan.figures(study)]
    tables = [
        f"{results}/tables/{study}/{table}.csv"
        for study in wanted
        for table in tables_of(study)
    ]
    return files_of(results, nodes) + tables


CHAPTERS = sorted(set(PLANS[RESULTS].chapters.values()))


rule all:
    input:
        everything(RESULTS),
        # One file's run must not rewrite the verdicts on all the others.
        [] if "study" in config else ["results/claims.csv"],


for chapter in CHAPTERS:

    rule:
        name:
            f"chapter{chapter}"
        input:
            everything(RESULTS, chapter),


rule smoke:
    input:
        everything(SMOKE),


rule claims:
    input:
        studies=[f"{RESULTS}/studies/{study}.nc" for study in PLANS[RESULTS].studies],
        claims=CLAIMS,
    output:
        table="results/claims.csv",
        page="results/claims.md",
    params:
        spec={"stage": "claims", "revision": 1},
    script:
        "../scripts/run_stage.py"
