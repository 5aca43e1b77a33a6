# make demo    from nothing to a page of labelled homes: .venv, install, 12 scenes, gallery
# make test    what every change must pass: ruff, mypy, pytest on all cores
# make test-library  what takes minutes and hangs on the models alone: all of them checked, told apart
# make lint    ruff and mypy only
# make docs    write the reference anew from code and schemas, and run the notebook
# make site    the guides as a site, in build/site
# make assets  make all models again with Blender (minutes to hours; not needed to build homes)
# make clean   remove what the targets above left, .venv too

PYTHON3 := $(firstword $(foreach name,python3 python3.11 python3.10 python,$(shell command -v $(name))))
BIN := .venv/bin
BLENDER ?= blender
DEMO_OUT ?= output/demo
DEMO_OPTIONS ?= --n 12 --seed 7 --views 6 --size 480x360
PYTEST_OPTIONS ?=
#: One process a core; more than eight would want more memory than most machines have.
PYTEST := $(BIN)/python -m pytest -n logical --maxprocesses 8 --dist loadgroup --durations 10

.PHONY: help demo test test-library lint docs site assets clean env dev-env
.DEFAULT_GOAL := help

help:
	@sed -n 's/^# make/make/p' Makefile

env:
	@test -n "$(PYTHON3)" || { echo "error: no Python 3 found; install Python 3.11" >&2; exit 1; }
	@$(PYTHON3) scripts/setup_env.py

dev-env:
	@test -n "$(PYTHON3)" || { echo "error: no Python 3 found; install Python 3.11" >&2; exit 1; }
	@$(PYTHON3) scripts/setup_env.py --extras dev

demo: env
	$(BIN)/sdgen build $(DEMO_OPTIONS) --out $(DEMO_OUT)
	$(BIN)/sdgen view $(DEMO_OUT)

lint: dev-env
	$(BIN)/ruff check .
	$(BIN)/ruff format --check --quiet .
	$(BIN)/mypy

test: lint
	$(PYTEST) $(PYTEST_OPTIONS)

test-library: dev-env
	$(PYTEST) -m library $(PYTEST_OPTIONS)
	$(BIN)/python scripts/library_digest.py --record

docs: dev-env
	$(BIN)/python scripts/command_reference.py > docs/commands.md
	$(BIN)/python scripts/file_reference.py > docs/files.md
	$(BIN)/python scripts/api_reference.py > docs/api.md
	$(BIN)/python scripts/hazard_pages.py
	$(BIN)/python scripts/run_notebook.py

site: dev-env
	NO_MKDOCS_2_WARNING=1 $(BIN)/python -m mkdocs build --strict

assets:
	@command -v $(BLENDER) >/dev/null || { echo "error: 'make assets' needs Blender 3.4 or newer (apt-get install blender), or BLENDER=/path/to/blender" >&2; exit 1; }
	PYTHONDONTWRITEBYTECODE=1 $(BLENDER) --background --factory-startup --python assets/blender/build.py -- --all
	@$(PYTHON3) scripts/setup_env.py --extras dev,assets
	$(BIN)/python -B assets/blender/assemble.py

clean:
	rm -rf .venv build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis $(DEMO_OUT)
	find assets benchmarks examples generator scripts tests -name __pycache__ -prune -exec rm -rf {} + 2>/dev/null || true
