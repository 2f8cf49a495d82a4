# Two commands: `make reproduce` and `make test`. Each creates its own environment; nothing is installed by hand.
VENV ?= .venv
PYTHON ?= python3
WORKERS ?= auto
PIP = $(VENV)/bin/python -m pip install --disable-pip-version-check --quiet
RUN = $(VENV)/bin/python -m

# Tests start hundreds of interpreters: where the machine forbids bytecode, each would compile all modules again.
export PYTHONDONTWRITEBYTECODE =

.PHONY: reproduce test test-thorough test-share matrix lint docs tables benchmarks locks mutants weakened proofs wheel clean

reproduce: $(VENV)/.reproduce
	$(RUN) paper_checks --report build/report

# Asserts as they stand: to rewrite those of a thousand files takes half a minute of a fresh checkout.  What failed runs once more,
# with the values on both sides of its asserts.
test: $(VENV)/.test
	$(RUN) pytest -n $(WORKERS) -m "not slow" --assert=plain || \
	    { [ $$? = 1 ] && $(RUN) pytest -m "not slow" --last-failed --last-failed-no-failures none; exit 1; }

test-thorough: $(VENV)/.test
	HYPOTHESIS_PROFILE=nightly FUZZ_EXAMPLES=200 $(RUN) pytest -n $(WORKERS) --dist worksteal
	$(MAKE) matrix

# A quarter of what `make test` leaves out, that of the week of the year: no slow test goes without a run for longer than a month.
SHARE ?= $(shell date +%V)
test-share: $(VENV)/.test
	SHARE=$(SHARE) HYPOTHESIS_PROFILE=nightly FUZZ_EXAMPLES=200 $(RUN) pytest -n $(WORKERS) --dist worksteal -m slow

# The tests under every Python that is installed and both number types of SymPy, which must not change a result.
PYTHONS ?= python3.11 python3.12 python3.13 python3.14
matrix:
	@for python in $(PYTHONS); do \
	    $$python -c pass 2>/dev/null || { echo "$$python is not installed: not tested"; continue; }; \
	    for types in flint python; do \
	        echo "$$python, SymPy on $$types numbers"; \
	        SYMPY_GROUND_TYPES=$$types $(MAKE) --no-print-directory test PYTHON=$$python VENV=.venv-$$(basename $$python) || exit 1; \
	    done; \
	done

# Every named table at 30 digits, with its provenance: build/tables/index.md says what there is.
tables: $(VENV)/.reproduce
	$(RUN) asymptotics.shell.standard_tables build/tables

lint: $(VENV)/.test
	$(RUN) ruff check .
	$(RUN) ruff format --check --quiet .
	$(RUN) mypy

# The pages in build/docs, offline and without a script; warnings are errors, every code block is run, every page is looked at
# in Chromium where that is installed, and every result type is shown in a notebook of its own.
docs: $(VENV)/.docs
	$(RUN) sphinx -W --keep-going -q -b html docs build/docs
	$(RUN) sphinx -W --keep-going -q -b doctest docs build/doctest
	$(RUN) tests.docs_drawn build/docs
	$(RUN) tests.docs_searched build/docs
	$(RUN) tests.notebook build/notebook

# What a release would ship, tried: built, its metadata checked, installed into a fresh environment and used there from an empty folder.
wheel: $(VENV)/.reproduce
	$(RUN) tests.wheel build/dist

# Ratios beside the peers, as a page of the docs; the peers have an environment of their own, and one that is missing is an error.
# QUICK=1: smaller sizes, a minute or so. PEERS=none: ours alone.
PEERS ?= .peers
benchmarks: $(VENV)/.test $(filter-out none/.ready,$(PEERS)/.ready)
	$(RUN) benchmarks --report docs $(if $(QUICK),--quick) $(if $(filter none,$(PEERS)),--no-peers)

# Every lock, installed in fresh environments; weekly, as a lock may rot without a change here.
locks:
	rm -rf build/locks
	$(MAKE) --no-print-directory VENV=build/locks/docs build/locks/docs/.docs
	$(MAKE) --no-print-directory VENV=build/locks/mutants PEERS=build/locks/peers build/locks/mutants/.mutants build/locks/peers/.ready
	@for each in docs mutants peers; do build/locks/$$each/bin/python -m pip check --disable-pip-version-check || exit 1; done

# A sample of planted faults in each group of modules, and how many the tests notice; SAMPLE=500 for a longer look.
SAMPLE ?= 60
mutants: $(VENV)/.mutants
	$(RUN) benchmarks.mutants --sample $(SAMPLE)

# Each bound of benchmarks/weakened_bounds.json is halved or dropped, and its test must fail; PART=flow/wells/ for some of them.
weakened: $(VENV)/.test
	$(RUN) benchmarks.weakened $(PART)

# The two lemmas behind a certificate, and a turning point to ten digits from its coefficients, compiled by Coq, with the axioms they
# rest on: Debian has all it takes.
COQC ?= coqc
proofs:
	@command -v $(COQC) >/dev/null || { echo "$(COQC) is not installed: no proof was compiled (Debian: coq libcoq-coquelicot)"; exit 0; }; \
	rm -rf build/coq && mkdir -p build/coq && cp derivations/coq/*.v build/coq && cd build/coq && \
	for file in $$(cat ../../derivations/coq/order.txt); do \
	    echo "$$file"; $(COQC) -w none $$file || exit 1; \
	done

# Each environment is the one before it and what its lock adds; a change of pyproject.toml alone installs the package anew.
$(VENV)/.lock: requirements/reproduce.txt
	@$(PYTHON) -c "import sys; sys.exit(None if sys.version_info >= (3, 11) else 'Python 3.11 or later is needed: make PYTHON=python3.x')"
	@echo "Creating the environment in $(VENV) (once; about half a minute) ..."
	$(PYTHON) -m venv --clear $(VENV)
	$(PIP) --require-hashes --only-binary :all: -r requirements/reproduce.txt
	touch $@

$(VENV)/.reproduce: pyproject.toml $(VENV)/.lock
	$(PIP) --no-deps --no-build-isolation -e .
	touch $@

$(VENV)/.tools: requirements/test.txt $(VENV)/.lock
	@echo "Adding the tools of the tests to $(VENV) (once) ..."
	$(PIP) --require-hashes --only-binary :all: -r requirements/test.txt
	touch $@

$(VENV)/.test: $(VENV)/.tools $(VENV)/.reproduce
	touch $@

$(VENV)/.docs: requirements/docs.txt $(VENV)/.test
	@echo "Adding the tools of the docs to $(VENV) (once) ..."
	$(PIP) --require-hashes --only-binary :all: -r requirements/docs.txt
	touch $@

$(PEERS)/.ready: requirements/peers.txt
	@echo "Creating the environment of the peers in $(PEERS) (once) ..."
	$(PYTHON) -m venv --clear $(PEERS)
	$(PEERS)/bin/python -m pip install --disable-pip-version-check --quiet --require-hashes --only-binary :all: -r $<
	touch $@

$(VENV)/.mutants: requirements/mutants.txt $(VENV)/.test
	$(PIP) --require-hashes --only-binary :all: -r requirements/mutants.txt
	touch $@

clean:
	rm -rf build docs/auto_gallery .peers $(VENV) .venv-*
