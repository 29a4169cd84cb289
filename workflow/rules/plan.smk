# What is to be made: the studies asked for, planned at the accuracy in force and, for `smoke`, as drafts.

RESULTS = "results"
SMOKE = "results/smoke"
CLAIMS = str(ROOT / "config" / "claims.csv")


def planned(**accuracy):
    """All nodes of the studies asked for; a mistake in a file ends the run with its message alone."""
    try:
        files = select(config, ROOT / "config")
        return merge(
            plan(load(path, config_dir=ROOT / "config", **accuracy)) for path in files
        )
    except StudyError as error:
        raise WorkflowError(str(error)) from None


PLANS = {
    RESULTS: planned(accuracy=config.get("accuracy", "standard")),
    SMOKE: planned(accuracy="draft", overrule=True),
}


def files_of(results, nodes):
    """Paths of all files of some nodes."""
    return [f"{results}/{path}" for node in nodes for path in node.paths]


def spec_of(kind, name):
    """Param function of a rule: the spec of the node that its job makes."""
    return lambda wildcards: dict(
        PLANS[wildcards.results].node(kind, name.format(**wildcards)).spec
    )


def inputs_of(kind, name):
    """Input function of a rule: the files that its job reads, by the kind of node that makes them."""

    def inputs(wildcards):
        plan = PLANS[wildcards.results]
        by_kind = {}
        for node in plan.inputs(plan.node(kind, name.format(**wildcards))):
            by_kind.setdefault(node.kind, []).extend(
                files_of(wildcards.results, [node])
            )
        return by_kind

    return inputs


def outside_files_of(kind):
    """Input function of a rule: the instruments' files that its job reads."""
    return lambda wildcards: list(
        PLANS[wildcards.results].node(kind, wildcards.key).files
    )


def memory_of_law(wildcards):
    """What a law's job needs [MB]; two large ones side by side are more than many a machine has."""
    spec = PLANS[wildcards.results].node("law", wildcards.key).spec
    points = spec["surface"].get("points", 1024)
    return int(estimated_bytes((points, points), spec["boundary"] != "free") / 1e6)


def judged_studies(wildcards):
    """The studies that a figure's caption reads, besides its own: those that the source's statements are held against."""
    plan = PLANS[wildcards.results]
    return [
        f"{wildcards.results}/studies/{study}.nc"
        for study in studies_of(wildcards.figure, read_claims(CLAIMS))
        if study in plan.studies and study != wildcards.study
    ]


def heading(wildcards):
    """Where a figure stands in the report."""
    chapter = PLANS[wildcards.results].chapters.get(wildcards.study)
    return "Studies of one's own" if chapter is None else f"Chapter {chapter}"
