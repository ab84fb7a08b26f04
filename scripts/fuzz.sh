#!/usr/bin/env bash
# Builds the fuzzers with clang in BUILD and runs each for FUZZ_SECONDS (20), from real files as seeds. What a fuzzer finds
# stands in BUILD/fuzz/NAME/crash-*, timeout-* or oom-*; BUILD/fuzz/NAME_fuzzer FILE repeats it.
#   scripts/fuzz.sh BUILD [NAME...]
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1
shift
seconds=${FUZZ_SECONDS:-20}

[ -f "$build/build.ninja" ] || cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only" \
  -DAKTINA_FUZZ=ON -DAKTINA_TESTS=OFF -DAKTINA_PYTHON=OFF -DAKTINA_BENCH=OFF
cmake --build "$build" --target fuzzers -j"$(nproc)"

# Small files with one of the extensions, from the repository and from the third-party scenes beside it.
copy_seeds() {  # NAME FOLDER
  local extension match=()
  for extension in $(tr ';' ' ' <"$build/fuzz/$1.seeds"); do match+=(-o -iname "*.$extension"); done
  find scenes tests ../shared/scenes -type f -size -64k \( -false "${match[@]}" \) 2>/dev/null |
    while read -r file; do cp -f "$file" "$2/$(sha1sum <"$file" | cut -c1-40)"; done
}

run() {  # NAME
  local folder="$build/fuzz/$1"
  mkdir -p "$folder/seeds" "$folder/corpus"
  copy_seeds "$1" "$folder/seeds"
  echo "fuzz: $1, $(find "$folder/seeds" -type f | wc -l) seeds, $seconds s"
  "$build/fuzz/${1}_fuzzer" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1024 \
    -max_len=65536 -artifact_prefix="$folder/" -verbosity=0 -print_final_stats=1 "$folder/corpus" "$folder/seeds" \
    2>&1 | grep -E 'ERROR|SUMMARY|runtime error|number_of_executed|peak_rss|#[0-9]+ 0x|Test unit written' || true
  [ -z "$(find "$folder" -maxdepth 1 -name '*-*' -type f)" ] || { echo "fuzz: $1 found: $(ls "$folder"/*-*)"; return 1; }
}

names=("$@")
[ $# -gt 0 ] || for file in "$build"/fuzz/*.seeds; do names+=("$(basename "$file" .seeds)"); done
failed=0
for name in "${names[@]}"; do run "$name" || failed=1; done
exit $failed
