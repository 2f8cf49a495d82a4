# Two commands: `make reproduce` and `make test`. Each creates its own environment; nothing is installed by hand.
VENV ?= .venv
PYTHON ?= python3
PIP = $(VENV)/bin/python -m pip install --disable-pip-version-check --quiet
RUN = $(VENV)/bin/python -m

.PHONY: reproduce test test-thorough lint benchmarks clean

reproduce: $(VENV)/.ready
	$(RUN) paper_checks --report build/report

test: $(VENV)/.ready
	$(RUN) pytest -m "not slow"

test-thorough: $(VENV)/.ready
	HYPOTHESIS_PROFILE=thorough $(RUN) pytest

lint: $(VENV)/.ready
	$(RUN) ruff check .
	$(RUN) mypy

benchmarks: $(VENV)/.ready
	$(RUN) benchmarks

$(VENV)/.ready: requirements/lock.txt pyproject.toml
	@$(PYTHON) -c "import sys; sys.exit(None if sys.version_info >= (3, 11) else 'Python 3.11 or later is needed: make PYTHON=python3.x')"
	@echo "Creating the environment in $(VENV) (once; about half a minute) ..."
	$(PYTHON) -m venv --clear $(VENV)
	$(PIP) --require-hashes --only-binary :all: -r requirements/lock.txt
	$(PIP) --no-deps --no-build-isolation -e .
	touch $@

clean:
	rm -rf build $(VENV)
