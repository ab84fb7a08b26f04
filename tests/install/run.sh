#!/usr/bin/env bash
# Installs into a fresh folder, then builds and runs a project outside the tree against it: with CMake and with pkg-config.
# CXX and CXXFLAGS are those of the build.
set -euo pipefail
build=$1 source=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/prefix
cmake --install "$build" --prefix "$prefix" >"$folder/log" || { cat "$folder/log"; exit 1; }

for file in bin/aktina share/man/man1/aktina.1 share/bash-completion/completions/aktina \
  share/zsh/site-functions/_aktina share/fish/vendor_completions.d/aktina.fish; do
  [ -s "$prefix/$file" ] || { echo "not installed: $file"; exit 1; }
done
bash -n "$prefix/share/bash-completion/completions/aktina"
"$prefix/bin/aktina" --version

echo "with CMake:"
cmake -S "$source/consumer" -B "$folder/cmake" -DCMAKE_PREFIX_PATH="$prefix" >"$folder/log" || { cat "$folder/log"; exit 1; }
cmake --build "$folder/cmake" >"$folder/log" || { cat "$folder/log"; exit 1; }
"$folder/cmake/consumer"

echo "with pkg-config:"
export PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name aktina.pc)")
flags=$(pkg-config --define-prefix --cflags --libs aktina)
# shellcheck disable=SC2086
"${CXX:-c++}" -std=c++20 ${CXXFLAGS:-} "$source/consumer/main.cpp" $flags -o "$folder/consumer"
LD_LIBRARY_PATH=$(pkg-config --define-prefix --variable=libdir aktina) "$folder/consumer"

echo "the installed headers need nothing of the source tree:"
for header in $(cd "$prefix/include" && find aktina -name '*.h' | sort); do echo "#include <$header>"; done >"$folder/all.cpp"
"${CXX:-c++}" -std=c++20 -fsyntax-only -I"$prefix/include" "$folder/all.cpp"
