# Aktina: two commands. `make demo` shows it, `make check` proves it. The rest is for daily work.
BUILD ?= build
CMAKE_FLAGS ?=
JOBS ?= $(shell nproc)

.PHONY: all setup setup-tests configure demo check test bench fuzz install lint format docs clean

all: configure
	@cmake --build $(BUILD) -j$(JOBS)

setup:
	@scripts/setup.sh

setup-tests:
	@scripts/setup.sh --tests

configure: setup
	@[ -f $(BUILD)/build.ninja ] || cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release $(CMAKE_FLAGS)

demo: all
	@scripts/demo.sh $(BUILD) out

check: setup-tests all
	@scripts/check.sh $(BUILD)

test: setup-tests all
	@ctest --test-dir $(BUILD) --output-on-failure -j$(JOBS)

bench: all
	@scripts/bench.sh $(BUILD)

fuzz: setup
	@scripts/fuzz.sh $(BUILD)-fuzz

install: all
	@cmake --install $(BUILD)

lint: configure
	@scripts/lint.sh $(BUILD)

format:
	@git ls-files '*.h' '*.cpp' | xargs clang-format -i

docs: all
	@scripts/generate_docs.sh $(BUILD)

clean:
	@rm -rf $(BUILD)
