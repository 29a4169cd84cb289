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
    "solid_meshes",
    "solid_stability",
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
rule peers:
    input:
        "results/benchmarks/peers.nc",


rule peers_environment:
    input:
        code=str(ROOT / "workflow" / "scripts" / "make_peers_environment.py"),
        requirements=str(ROOT / "benchmarks" / "peers-requirements.txt"),
    output:
        touch(".venv-peers/ready"),
    shell:
        "python {input.code} {input.requirements} .venv-peers"


rule benchmark_peers:
    input:
        code=BENCHMARK_CODE.format(name="peers"),
        peer=BENCHMARK_CODE.format(name="peer_solvers"),
        environment=".venv-peers/ready",
    output:
        dataset="results/benchmarks/peers.nc",
        pictures=multiext("results/benchmarks/peers", ".pdf", ".png", ".svg", ".csv"),
    params:
        python=".venv-peers/bin/python",
    script:
        "../scripts/run_benchmark.py"
