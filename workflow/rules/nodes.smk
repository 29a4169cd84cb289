# One rule a kind of node. What a job is to compute stands in its spec, so a changed spec is a changed job.


wildcard_constraints:
    results="results(/smoke)?",
    key="[a-z0-9_.-]+",
    study="[A-Za-z0-9_-]+",
    figure="[A-Za-z0-9_-]+",
    table="[a-z0-9_]+",


rule topography:
    input:
        files=outside_files_of("topography"),
    output:
        "{results}/topography/{key}.nc",
    params:
        spec=spec_of("topography", "{key}"),
    script:
        "../scripts/run_stage.py"


rule law:
    input:
        files=outside_files_of("law"),
    output:
        "{results}/law/{key}.nc",
    resources:
        mem_mb=memory_of_law,
    params:
        spec=spec_of("law", "{key}"),
    script:
        "../scripts/run_stage.py"


rule state:
    input:
        unpack(inputs_of("state", "{key}")),
        files=outside_files_of("state"),
    output:
        "{results}/state/{key}.nc",
    params:
        spec=spec_of("state", "{key}"),
    script:
        "../scripts/run_stage.py"


rule stiffness:
    input:
        unpack(inputs_of("stiffness", "{key}")),
        files=outside_files_of("stiffness"),
    output:
        "{results}/stiffness/{key}.nc",
    params:
        spec=spec_of("stiffness", "{key}"),
    script:
        "../scripts/run_stage.py"


rule equivalence:
    input:
        unpack(inputs_of("equivalence", "{key}")),
        files=outside_files_of("equivalence"),
    output:
        "{results}/equivalence/{key}.nc",
    params:
        spec=spec_of("equivalence", "{key}"),
    script:
        "../scripts/run_stage.py"


rule panel:
    input:
        unpack(inputs_of("panel", "{key}")),
    output:
        "{results}/panel/{key}.nc",
    params:
        spec=spec_of("panel", "{key}"),
    script:
        "../scripts/run_stage.py"


rule study:
    input:
        unpack(inputs_of("study", "{study}")),
    output:
        "{results}/studies/{study}.nc",
    params:
        spec=spec_of("study", "{study}"),
    script:
        "../scripts/run_stage.py"


rule figure:
    input:
        unpack(inputs_of("figure", "{study}/{figure}")),
        judged=judged_studies,
        claims=CLAIMS,
    output:
        pdf="{results}/figures/{study}/{figure}.pdf",
        png="{results}/figures/{study}/{figure}.png",
        svg=report(
            "{results}/figures/{study}/{figure}.svg",
            caption="../report/figure.rst",
            category=heading,
            subcategory="{study}",
            labels={"figure": "{figure}"},
        ),
        csv="{results}/figures/{study}/{figure}.csv",
        caption="{results}/figures/{study}/{figure}.rst",
    params:
        spec=spec_of("figure", "{study}/{figure}"),
    script:
        "../scripts/run_stage.py"


rule surface_table:
    input:
        study="{results}/studies/{study}.nc",
    output:
        "{results}/tables/{study}/{table}.csv",
    params:
        spec=lambda wildcards: {
            "stage": "surface_table",
            "revision": 1,
            "table": wildcards.table,
        },
    script:
        "../scripts/run_stage.py"
