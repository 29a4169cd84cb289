# What is to be made: the studies asked for, planned at the accuracy in force and, for `smoke`, as drafts.

RESULTS = "results"
SMOKE = "results/smoke"


def study_files():
    """The one file of `--config study=PATH`, else those that config.yaml lists."""
    if "study" in config:
        return [Path(config["study"])]
    return [ROOT / "config" / "studies" / f"{name}.yaml" for name in config["studies"]]


def planned(**accuracy):
    """All nodes of the studies asked for; a mistake in a file ends the run with its message alone."""
    try:
        return merge([plan(load(path, **accuracy)) for path in study_files()])
    except StudyError as error:
        raise WorkflowError(str(error)) from None


PLANS = {RESULTS: planned(accuracy=config["accuracy"])}


def node(kind, wildcards):
    return PLANS[wildcards.results].node(kind, wildcards.key)


def spec_of(kind):
    """Param function of a rule: the spec of the node that its job makes."""
    return lambda wildcards: node(kind, wildcards).spec


def inputs_of(kind, input_kind):
    """Input function of a rule: the files of the nodes of one kind that its job reads."""
    return lambda wildcards: [
        f"{wildcards.results}/{source.path}"
        for source in PLANS[wildcards.results].inputs(node(kind, wildcards))
        if source.kind == input_kind
    ]
