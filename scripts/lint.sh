#!/usr/bin/env bash
# clang-format and clang-tidy on what changed since main, or on the files named, or on everything with --all.
#   scripts/lint.sh [BUILD] [--all | FILE...]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build}
shift || true
case "${1:-}" in
  --all) mapfile -t files < <(git ls-files '*.h' '*.cpp') ;;
  "") mapfile -t files < <({ git diff --name-only main -- '*.h' '*.cpp'; git ls-files -o --exclude-standard '*.h' '*.cpp'; } | sort -u) ;;
  *) files=("$@") ;;
esac
existing=()
for file in "${files[@]}"; do [ -f "$file" ] && existing+=("$file"); done
[ ${#existing[@]} -gt 0 ] || { echo "lint: nothing changed"; exit 0; }

clang-format --dry-run -Werror "${existing[@]}"
sources=()
for file in "${existing[@]}"; do
  case "$file" in tests/install/* | fuzz/*) ;; *.cpp) sources+=("$file") ;; esac
done
[ ${#sources[@]} -eq 0 ] || printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy --quiet -p "$build"
echo "lint: ${#existing[@]} files are clean"
