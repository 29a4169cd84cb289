# One rule a kind of node. What a job is to compute stands in its spec, so a changed spec is a changed job.


wildcard_constraints:
    results="results(/smoke)?",
    key="[a-z0-9_.-]+",
    study="[A-Za-z0-9_-]+",
    figure="[A-Za-z0-9_-]+",


rule panel:
    output:
        dataset="{results}/panel/{key}.nc",
    params:
        spec=spec_of("panel"),
    script:
        "../scripts/run_stage.py"


rule study:
    input:
        panel=inputs_of("study", "panel"),
    output:
        dataset="{results}/studies/{key}.nc",
    params:
        spec=spec_of("study"),
    script:
        "../scripts/run_stage.py"
