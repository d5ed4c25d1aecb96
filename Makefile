# s7-interrupts: `make` lists the targets.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
ENGINE := trace_checker/engine/target/s7-trace-engine.jar
NATIVE := trace_checker/engine/target/s7-trace-engine
WINDOWS := $(NATIVE).exe
WASM   := trace_checker/engine/target/wasm/engine.wasm
PAGE   := build/page/s7check.html
PLC    := examples/soft_plc/build/soft_plc
SEARCH := build/npm/node_modules/minisearch/dist/umd/index.js
AWLSIM := build/awlsim/awlsim/__init__.py
KIT    := build/views/kit/programs
# The page is tested where a browser is.
TESTED := $(if $(shell which chromium chromium-browser google-chrome),$(PAGE))

.DEFAULT_GOAL := help
.PHONY: help setup engine native native-windows page equal verify kit test test-checker test-evidence test-engine test-plc requirements models models-smoke models-full controls models-distributed mutants mutants-sample witnesses agreement agreement-sample since typecheck apalache prove fuzz wheel wheel-windows release lint bench results views kept clean site pictures

help:  ## list the targets
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## /\t/' | expand -t 16

setup: $(BIN)/s7check $(ENGINE) $(PLC) $(KIT)  ## install .venv, the engine, the soft PLC, the programs of the kit

engine: $(ENGINE)  ## build the trace checker's engine

native: $(NATIVE)  ## build the engine as an executable, which s7check takes from then on: a minute of CPU, a C compiler

native-windows: $(WINDOWS)  ## the executable for Windows, by mingw-w64; wine runs it, nobody has tried it on Windows

page: $(PAGE)  ## build/page/s7check.html: the checker as one file for a browser, without network: a minute of CPU

verify: setup  ## the main job: models of the CI lane, the soft PLC run live, all shipped logs, random logs, a few mutants
	$(BIN)/s7spec verify

test: lint test-evidence test-checker test-engine test-plc  ## all tests, with `make -j2 -Otarget test` two kinds at a time

test-checker: setup $(AWLSIM) $(TESTED)
	@test -n "$(TESTED)" || echo "not run: the page in a browser, for lack of Chromium"
	@test -n "$$(which firefox-esr firefox)" || echo "not run: the page in Firefox, for lack of it"
	$(BIN)/python -m pytest -q -n logical --dist loadfile --durations=20 trace_checker/tests

test-evidence: setup $(TESTED)
	@command -v npm >/dev/null && $(MAKE) -s $(SEARCH) || echo "not run: the search of the site, for lack of npm"
	$(BIN)/python -m pytest -q -n logical --dist loadfile --durations=20 evidence/tests

test-engine: setup
	cd trace_checker/engine && mvn -q -B test

test-plc: setup
	$(MAKE) -s -C examples/soft_plc test

requirements: $(BIN)/s7check  ## every requirement has its formula, property, model and logs, or a written reason
	$(BIN)/s7spec views requirements

models: setup  ## model-check the CI lane; SHARD=1/4 does a quarter of it
	$(BIN)/s7spec models --lane ci $(if $(SHARD),--shard $(SHARD))

models-smoke: setup  ## model-check the smoke lane
	$(BIN)/s7spec models --lane smoke

models-full: setup  ## model-check everything; SHARD=1/4 does a quarter of it
	$(BIN)/s7spec models --lane full $(if $(SHARD),--shard $(SHARD))

controls: setup  ## the negative controls: model, change, exit code and property, result
	$(BIN)/s7spec models 'neg-*'

WORKERS ?= 2
MODELS  ?= airt queue hold
models-distributed: setup  ## TLC's distributed mode: MODELS="airt queue" on WORKERS=2 workers here (docs/project/distributed.md)
	$(BIN)/s7spec models --distributed $(WORKERS) $(MODELS)

mutants: setup  ## mutate the specification: every mutant before the shipped logs and the models of the CI lane
	$(BIN)/s7spec mutants --against all --lane ci --json build/mutants/report.json

mutants-sample: setup  ## the same for 60 mutants
	$(BIN)/s7spec mutants --against all --lane ci --sample 60

witnesses: setup  ## is anything checked in vain? models of the CI lane and shipped logs on a specification with marks
	$(BIN)/s7spec witnesses --json build/witnesses/report.json

LOGS ?= 10000
agreement: setup  ## LOGS=10000 random logs: the engine and TLC give the same verdict at the same line
	$(BIN)/s7spec logs agree --logs $(LOGS) --json build/agreement/report.json

agreement-sample: setup  ## the same for 100 logs, as in make verify
	$(BIN)/s7spec logs agree --logs 100

TOY_RUN := $(BIN)/s7check kit run --offer examples/adapters/toy_offer.json
kit: setup $(AWLSIM)  ## run the conformance kit on the soft PLC, on the toy CPU of the template and on awlsim; results in build/kit, outcomes in kit/implementations.ndjson
	mkdir -p build/kit
	$(BIN)/s7check kit run --output build/kit/soft_plc.html --output build/kit/soft_plc.json -- $(PLC) --kit
	-$(TOY_RUN) --output build/kit/toy.html --output build/kit/toy.json -- $(BIN)/python examples/adapters/template.py
	-PYTHONPATH=build/awlsim $(BIN)/s7check kit run --offer examples/adapters/awlsim_offer.json --output build/kit/awlsim.html --output build/kit/awlsim.json -- $(BIN)/python examples/adapters/awlsim_adapter.py
	$(BIN)/python -m evidence.kit.implementations soft_PLC=build/kit/soft_plc.json toy_CPU=build/kit/toy.json awlsim=build/kit/awlsim.json

equal: setup native  ## the executable and Java give the same answers: all cases, LOGS=10000 random logs, 1,000 damaged ones
	$(BIN)/s7spec logs engines --logs $(LOGS) --json build/engines/report.json

REV ?= HEAD^
since: setup  ## REV=HEAD^: the same verdict at the same line for every log, the same pins for every model, as at that revision
	$(BIN)/s7spec since $(REV) --json build/since/report.json

typecheck: $(BIN)/s7check  ## type-check every module of spec/ with Apalache (APALACHE_HOME or PATH)
	models/apalache.sh typecheck

apalache: $(BIN)/s7check  ## bounded checks with Apalache (APALACHE_HOME or PATH)
	models/apalache.sh check

SHARD ?= 1/1
JOBS ?= 2
prove: setup  ## the proofs about System and the abstract specifications by Apalache; SHARD=1/4 for a part, JOBS=2 queries at a time
	$(BIN)/s7spec prove --resume --shard $(SHARD) --jobs $(JOBS) --json build/proofs/report-$(subst /,-of-,$(SHARD)).json

FUZZ ?= 24000
fuzz: setup  ## FUZZ=24000 damaged logs and sources: each gets its verdict or its refusal, in one sentence
	$(BIN)/python -m tests.fuzz --inputs $(FUZZ)

wheel: setup native page  ## build/wheel/*.whl: s7check for this kind of machine with all it needs but Python
	$(BIN)/pip wheel -q --disable-pip-version-check --no-build-isolation --no-deps --wheel-dir build/wheel .

CYCLONEDX ?= cyclonedx-py
RELEASE := build/release
release: wheel site  ## build/release: wheel, page, site, lists of what is inside (CycloneDX), checksums; CYCLONEDX=cyclonedx-py
	rm -rf $(RELEASE) build/runtime && mkdir -p $(RELEASE)
	cp build/wheel/*.whl $(PAGE) $(RELEASE)
	tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner -C build -c site | gzip -n > $(RELEASE)/site.tar.gz
	$(PYTHON) -m venv --without-pip build/runtime
	$(BIN)/pip -q --disable-pip-version-check --python build/runtime/bin/python install $(firstword $(wildcard build/wheel/*linux*.whl))
	$(CYCLONEDX) environment --pyproject pyproject.toml --output-reproducible -o $(RELEASE)/python.cdx.json build/runtime/bin/python
	cd trace_checker/engine && mvn -q -B org.cyclonedx:cyclonedx-maven-plugin:2.9.1:makeBom -DoutputFormat=json -DoutputName=engine.cdx
	cp trace_checker/engine/target/engine.cdx.json $(RELEASE)
	cd build/npm && npm sbom --sbom-format cyclonedx > ../release/site.cdx.json
	cd $(RELEASE) && sha256sum * > SHA256SUMS

wheel-windows: setup native-windows page  ## the same for Windows
	S7CHECK_WHEEL=win_amd64 $(BIN)/pip wheel -q --disable-pip-version-check --no-build-isolation --no-deps --wheel-dir build/wheel .

lint: setup  ## ruff and mypy
	$(BIN)/ruff check
	$(BIN)/mypy
	$(BIN)/mypy bench/run.py bench/compare.py

bench: setup native  ## speed of the trace checker beside TLC, kept for docs/project/results.md; with REV=... beside that revision
	$(if $(filter command line,$(origin REV)),$(BIN)/python bench/compare.py --rev $(REV),$(BIN)/s7spec views results bench)

RUNS ?= --write
results: setup  ## docs/project/results.md from the kept numbers; RUNS="models logs" runs these commands first
	$(BIN)/s7spec views results $(RUNS)

views: setup  ## build/views: pages, sources of experiments and the programs of the kit, from the kept data
	$(BIN)/s7spec views make

kept: setup  ## the kept data that are made by TLC and the soft PLC, anew: minutes; `make kit` keeps its outcomes itself
	$(BIN)/s7spec kit paths --write
	$(MAKE) $(KIT)
	$(BIN)/s7spec kit reached --write

site: setup page $(SEARCH)  ## build/site: the book, docs, specification, edge cases and explorer as static pages, with a search (by npm)
	$(BIN)/s7spec views site

pictures: setup  ## docs/pictures, for the README; the explorer's needs Chromium
	$(BIN)/python -m evidence.views.pictures

clean:  ## remove everything built
	rm -rf $(VENV) build trace_checker/engine/target examples/soft_plc/build

$(BIN)/s7check: requirements.lock pyproject.toml evidence/pyproject.toml
	@echo "setting up $(VENV)"
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install -q --disable-pip-version-check --require-hashes -r requirements.lock
	$(BIN)/pip install -q --disable-pip-version-check --no-build-isolation --no-deps -e . -e evidence
	@touch $@

$(SEARCH): evidence/views/site/package-lock.json
	@echo "installing minisearch for the site"
	@mkdir -p build/npm
	@cp evidence/views/site/package*.json build/npm
	@cd build/npm && npm ci --silent --ignore-scripts --no-audit --no-fund --fetch-retries=0 --fetch-timeout=20000
	@touch $@

$(AWLSIM): examples/adapters/requirements-awlsim.txt $(BIN)/s7check
	@echo "installing awlsim for the kit"
	$(BIN)/pip install -q --disable-pip-version-check --no-build-isolation --no-deps --require-hashes --upgrade --target build/awlsim -r $<
	@touch $@

$(ENGINE): trace_checker/engine/pom.xml $(shell find trace_checker/engine/src/main -name '*.java')
	@echo "building the engine"
	cd trace_checker/engine && mvn -q -B package -DskipTests
	@touch $@

# TeaVM's collector reads the size of each chunk that was free, but an object may lie there by now. It took the identity
# hash code of that object for the size, and changed memory behind its table of cards.
COLLECTOR = $(dir $(NATIVE))c/c/o/t/r/GC.c
CHUNK_SIZE := TEAVM_FIELD(teavm_local_2, cls_otr_FreeChunk, fld_size)
CHUNK_IS_FREE := TEAVM_FIELD(teavm_local_2, cls_otr_FreeChunk, fld_classReference) == 0

# The evaluator relies on what TeaVM leaves to these flags: values of other types, and integers that wrap.
NATIVE_FLAGS := -O3 -w -fno-strict-aliasing -fwrapv -static -s
$(NATIVE): $(ENGINE) $(wildcard trace_checker/engine/src/main/c/*)
	@echo "building the engine as an executable"
	rm -rf $(dir $(NATIVE))c
	cd trace_checker/engine && mvn -q -B -Pnative process-classes
	sed -i '/^void meth_otr_GC_storeGapsInCardTable/,/^}/s/$(CHUNK_SIZE)/($(CHUNK_IS_FREE) ? $(CHUNK_SIZE) : 0)/' $(COLLECTOR)
	grep -q '$(CHUNK_IS_FREE) ?' $(COLLECTOR)
	cd trace_checker/engine && $(CC) $(NATIVE_FLAGS) -I src/main/c -o target/s7-trace-engine target/c/all.c src/main/c/streams.c -lm

$(WASM): $(ENGINE)
	@echo "building the engine as WebAssembly"
	cd trace_checker/engine && mvn -q -B -Ppage process-classes
	@touch $@

$(PAGE): $(WASM) $(KIT) $(wildcard trace_checker/s7check/page/* trace_checker/s7check/report/report.css) $(wildcard docs/rules/*.md) evidence/views/checker_page.py $(shell find spec -name '*.tla')
	@echo "building the page"
	$(BIN)/python -m evidence.views.checker_page

# TeaVM takes gcc for a sign of Unix, and expects a compiler of Microsoft on Windows.
ON_WINDOWS := \#ifdef _WIN32\n\#undef TEAVM_WINDOWS\n\#define TEAVM_WINDOWS 1\n\#include <stdalign.h>\n\#elif defined(__GNUC__)
$(WINDOWS): $(NATIVE)
	@echo "building the engine as an executable for Windows"
	rm -rf $(NATIVE)-windows
	cp -r $(dir $(NATIVE))c $(NATIVE)-windows
	sed -i 's/^#ifdef __GNUC__/$(ON_WINDOWS)/' $(NATIVE)-windows/definitions.h
	mkdir $(NATIVE)-windows/include
	echo '#include <windows.h>' > $(NATIVE)-windows/include/Windows.h
	x86_64-w64-mingw32-gcc $(NATIVE_FLAGS) '-D__assume(x)=__builtin_unreachable()' -I $(NATIVE)-windows/include \
	  -I trace_checker/engine/src/main/c -o $@ $(NATIVE)-windows/all.c trace_checker/engine/src/main/c/streams.c -lm -luuid -lole32

$(KIT): $(BIN)/s7check $(shell find evidence/common evidence/kit trace_checker/s7check/kit kit traces gallery models/models.txt -type f -not -name '*.pyc')
	@echo "making the programs of the kit, and the edge cases"
	$(BIN)/python -m evidence.kit.programs
	$(BIN)/python -m evidence.common.gallery
	@touch $@

$(PLC): $(filter-out examples/soft_plc/build/%,$(wildcard examples/soft_plc/*/*.[ch] instrumentation/*.h))
	@echo "building the soft PLC"
	$(MAKE) -s -C examples/soft_plc
