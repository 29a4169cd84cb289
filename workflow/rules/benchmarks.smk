# Benchmarks: one module of benchmarks/ a dataset. Timed jobs want the machine for themselves: `make benchmarks` takes one core.

BENCHMARKS = [
    "work_precision",
    "agreement",
    "modules",
    "relaxation",
    "elasticity",
    "domain",
    "map_throughput",
    "start_up",
    "condensation",
    "specimen_meshes",
    "specimen_stability",
    "meshed_film",
    "contact_scaling",
]
STRESS_CHUNKS = range(8)
BENCHMARK_CODE = str(ROOT / "benchmarks" / "{name}.py")
RESULT = "results/benchmarks/{name}"


rule benchmarks:
    input:
        expand(RESULT + ".nc", name=BENCHMARKS),


rule benchmark:
    input:
        code=BENCHMARK_CODE,
    output:
        dataset=RESULT + ".nc",
        pictures=multiext(RESULT, ".pdf", ".png", ".svg", ".csv"),
    wildcard_constraints:
        name="|".join(BENCHMARKS),
    script:
        "../scripts/run_benchmark.py"


rule stress:
    input:
        code=BENCHMARK_CODE.format(name="stress"),
        parts=expand("results/benchmarks/stress/{chunk}.nc", chunk=STRESS_CHUNKS),
    output:
        dataset="results/benchmarks/stress.nc",
        pictures=multiext("results/benchmarks/stress", ".pdf", ".png", ".svg", ".csv"),
        failures=directory("results/benchmarks/stress-failures"),
    script:
        "../scripts/run_benchmark.py"


rule stress_chunk:
    input:
        code=BENCHMARK_CODE.format(name="stress_chunk"),
    output:
        dataset="results/benchmarks/stress/{chunk}.nc",
    wildcard_constraints:
        chunk=r"\d+",
    params:
        chunk=lambda wildcards: int(wildcards.chunk),
    script:
        "../scripts/run_benchmark.py"


# Other projects' solvers, in an environment of their own; not part of `benchmarks`, since ASPHER must be compiled.
# A job a grid and one for the sweep: what was killed goes on from there. Each takes all cores, to be timed alone.
PEER_SIZES = (256, 512, 1024, 2048, 4096)
PEER_CODE = [
    BENCHMARK_CODE.format(name=name)
    for name in ("contact_errors", "contact_solvers", "peer_solvers")
]
PEER_PARTS = [
    *expand("results/benchmarks/peers/{points}.nc", points=PEER_SIZES),
    "results/benchmarks/peers/sweep.nc",
]


rule peers:
    input:
        expand(
            RESULT + ".nc", name=("peers", "peers_area", "peers_ratios", "peers_fine")
        ),


rule peers_environment:
    input:
        code=str(ROOT / "workflow" / "scripts" / "make_peers_environment.py"),
        requirements=str(ROOT / "benchmarks" / "peers-requirements.txt"),
    output:
        touch(".venv-peers/ready"),
    shell:
        "python {input.code} {input.requirements} .venv-peers"


rule peers_size:
    input:
        code=BENCHMARK_CODE.format(name="peers_size"),
        others=PEER_CODE,
        environment=".venv-peers/ready",
    output:
        dataset="results/benchmarks/peers/{points}.nc",
    wildcard_constraints:
        points=r"\d+",
    threads: workflow.cores
    params:
        points=lambda wildcards: int(wildcards.points),
        python=".venv-peers/bin/python",
    script:
        "../scripts/run_benchmark.py"


rule peers_sweep:
    input:
        code=BENCHMARK_CODE.format(name="peers_sweep"),
        others=PEER_CODE,
        environment=".venv-peers/ready",
    output:
        dataset="results/benchmarks/peers/sweep.nc",
    threads: workflow.cores
    params:
        python=".venv-peers/bin/python",
    script:
        "../scripts/run_benchmark.py"


rule peers_fine:
    input:
        code=BENCHMARK_CODE.format(name="peers_fine"),
        drawing=BENCHMARK_CODE.format(name="peers_drawing"),
        others=PEER_CODE + [BENCHMARK_CODE.format(name="peers_size")],
        environment=".venv-peers/ready",
    output:
        dataset=RESULT.format(name="peers_fine") + ".nc",
        pictures=multiext(
            RESULT.format(name="peers_fine"), ".pdf", ".png", ".svg", ".csv"
        ),
    threads: workflow.cores
    params:
        python=".venv-peers/bin/python",
    script:
        "../scripts/run_benchmark.py"


rule peers_joined:
    input:
        code=BENCHMARK_CODE.format(name="peers"),
        drawing=BENCHMARK_CODE.format(name="peers_drawing"),
        parts=PEER_PARTS,
    output:
        dataset=RESULT.format(name="peers") + ".nc",
        pictures=multiext(RESULT.format(name="peers"), ".pdf", ".png", ".svg", ".csv"),
    script:
        "../scripts/run_benchmark.py"


rule peers_derived:
    input:
        code=BENCHMARK_CODE,
        drawing=BENCHMARK_CODE.format(name="peers_drawing"),
        parts=["results/benchmarks/peers.nc"],
    output:
        dataset=RESULT + ".nc",
        pictures=multiext(RESULT, ".pdf", ".png", ".svg", ".csv"),
    wildcard_constraints:
        name="peers_area|peers_ratios",
    script:
        "../scripts/run_benchmark.py"
