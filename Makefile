# Every target sets up what it needs; nothing is installed twice.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
EXTENSION := python/freebody/_core.abi3.so
PEERS := .bench
RUST := $(shell find crates -name '*.rs' -o -name Cargo.toml) Cargo.toml Cargo.lock
PIP := $(BIN)/pip --disable-pip-version-check install --quiet -c constraints.txt
export PYO3_PYTHON := $(CURDIR)/$(BIN)/python

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help setup demo test check format bench docs clean

help: ## list the targets
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 16

setup: $(EXTENSION) $(VENV)/.dev ## make .venv, build the extension, install the developer's tools

demo: $(EXTENSION) ## simulate a real tumbling body and check its numbers
	$(BIN)/freebody verify --only toutatis
	$(BIN)/freebody run models/toutatis.toml

test: setup ## run every test: Rust, then Python
	cargo test --locked --quiet -p freebody-core
	$(BIN)/python -m pytest -n 2

check: setup ## formatting, linters, types, import arrows, inlining, the documents' truth
	cargo fmt --check
	cargo clippy --locked --quiet --all-targets -- -D warnings
	$(BIN)/ruff format --check
	$(BIN)/ruff check
	$(BIN)/pyright
	$(BIN)/lint-imports
	$(BIN)/python tools/check_inlining.py $(EXTENSION)
	$(BIN)/python -m pytest tests/repo

format: $(VENV)/.dev ## format Rust and Python
	cargo fmt
	$(BIN)/ruff format
	$(BIN)/ruff check --fix

bench: setup $(PEERS)/.installed ## measure the speeds that the documents state, beside those of the peers
	cargo bench --locked --quiet -p freebody-core --bench derivative
	$(BIN)/python bench/derivative.py
	$(BIN)/python bench/laws.py
	$(BIN)/python bench/equations.py
	$(BIN)/python bench/vehicles.py
	PYTHONPATH=python $(PEERS)/bin/python bench/side_by_side.py

docs: setup ## build the documentation into build/docs
	$(BIN)/python tools/gallery.py docs/generated
	$(BIN)/sphinx-build -W --keep-going -q docs build/docs
	@echo "docs: build/docs/index.html"

clean: ## remove what was built, keep .venv
	rm -rf target build out $(EXTENSION)

$(VENV)/.base: constraints.txt
	@command -v cargo >/dev/null || { echo "cargo is missing: install Rust (stable)"; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python 3.11 or newer is needed: make PYTHON=python3.11 ...")'
	$(PYTHON) -m venv $(VENV)
	$(PIP) --upgrade pip maturin
	@touch $@

$(VENV)/.dev: $(VENV)/.base pyproject.toml
	$(PIP) --group dev
	@touch $@

# numbalsoda has no wheels, and not every machine has a Fortran compiler: the bench says when it is not there.
$(PEERS)/.installed: bench/requirements.txt bench/constraints.txt
	$(PYTHON) -m venv $(PEERS)
	$(PEERS)/bin/pip --disable-pip-version-check install --quiet -c bench/constraints.txt -r bench/requirements.txt
	-$(PEERS)/bin/pip --disable-pip-version-check install --quiet -c bench/constraints.txt "numbalsoda>=0.3.4"
	@touch $@

$(EXTENSION): $(VENV)/.base pyproject.toml $(RUST)
	PIP_QUIET=1 PIP_CONSTRAINT=$(CURDIR)/constraints.txt $(BIN)/maturin develop --release --locked --quiet --extras cli,cluster,data,ensemble,plot
	@touch $@
