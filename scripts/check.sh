#!/usr/bin/env bash
# Proves that Aktina works: format and direction of includes, then every test program. `make check` has built it before.
set -euo pipefail
build=$1
cd "$(dirname "$0")/.."
find app bench fuzz python src tests -name '*.h' -o -name '*.cpp' | xargs clang-format --dry-run -Werror
/usr/bin/python3 -B scripts/check_layers.py
/usr/bin/python3 -B scripts/check_catalogue.py "$build"
ctest --test-dir "$build" --output-on-failure -j"$(nproc)"
