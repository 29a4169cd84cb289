"""softlub: the source's studies and one's own. `snakemake --cores 2` makes what config/config.yaml lists."""


include: "workflow/Snakefile"


rule default:
    default_target: True
    input:
        rules.all.input,
