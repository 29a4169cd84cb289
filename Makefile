# `make reproduce` and `make test` need Python 3.11 or newer, git and make; they set up .venv by themselves.

PYTHON ?= $(shell command -v python3.11 || command -v python3)
BIN := .venv/bin
SNAKEMAKE = $(BIN)/python workflow/scripts/run_locked.py .venv/snakemake.lock \
	$(BIN)/python -m snakemake --cores $(CORES) --nolock
CORES ?= 2
# Jobs and tests run side by side: one thread each.
export OPENBLAS_NUM_THREADS ?= 1
export OMP_NUM_THREADS ?= 1
export NUMBA_NUM_THREADS ?= 1
KERNELS := $(shell grep -rlE "njit|@compiled" src --include=*.py)

.PHONY: reproduce test smoke benchmarks stress claims lint clean help

reproduce: .venv/compiled ## the source's studies and figures, the claims and the report
	$(SNAKEMAKE) $(ARGS)
	$(SNAKEMAKE) --report results/report.html --report-stylesheet workflow/report/report.css

smoke: .venv/compiled ## everything at draft accuracy, under results/smoke
	$(SNAKEMAKE) smoke

benchmarks: CORES = 1
benchmarks: .venv/compiled ## run time against error of every solver; takes the machine for itself
	$(SNAKEMAKE) benchmarks

stress: .venv/compiled ## tens of thousands of random contacts: what converged and what was flagged
	$(SNAKEMAKE) stress

claims: .venv/compiled ## the source's claims held against the results
	$(SNAKEMAKE) claims

test: .venv/compiled ## the whole test suite
	$(BIN)/python -m pytest -n 2 tests

lint: .venv/ready ## style and types
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/snakefmt --check Snakefile workflow

clean: ## remove what was computed, keep the environment
	rm -rf results/[!R]* .snakemake

help: ## this list
	@grep -hE '^[a-z]+:.*##' Makefile | sed -E 's/:.*## /\t/' | expand -t 14

.venv/ready: pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "softlub needs Python 3.11 or newer; found $$($(PYTHON) --version). Name one: make PYTHON=/path/to/python3.11"; exit 1; }
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[dev]'
	touch $@

# numba looks at a function's own file only, not at those it calls: whatever is compiled is compiled anew together.
.venv/compiled: .venv/ready $(KERNELS)
	find src -name '*.nb[ci]' -delete
	$(BIN)/python workflow/scripts/compile_kernels.py
	touch $@
