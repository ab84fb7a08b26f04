#!/usr/bin/env bash
# Draws the picture of each method and writes docs/methods/, both from the catalogue of the program that was built.
set -euo pipefail
cd "$(dirname "$0")/.."
/usr/bin/python3 -B scripts/render_pictures.py "${1:-build}"
/usr/bin/python3 -B scripts/generate_docs.py "${1:-build}"
