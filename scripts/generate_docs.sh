#!/usr/bin/env bash
# Writes docs/methods/ from the catalogue of the program that was built.
set -euo pipefail
/usr/bin/python3 "$(dirname "$0")/generate_docs.py" "${1:-build}"
