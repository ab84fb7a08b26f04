#!/usr/bin/env bash
# Runs the benchmark programs of a build, prints one table and writes BUILD/bench.json.
set -euo pipefail
exec /usr/bin/python3 -B "$(dirname "$0")/bench.py" "${1:-build}"
