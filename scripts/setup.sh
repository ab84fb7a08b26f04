#!/usr/bin/env bash
# Installs what Aktina builds with, and says so first; with --tests also what tests of baked models run. Does nothing
# where everything is there already. Debian 12; as root, or as a user with sudo.
set -eu
tests=${1:-}

packages=(
  # build
  g++ cmake ninja-build make git ca-certificates pkg-config
  # core libraries
  libembree-dev libtbb-dev libhwy-dev libglm-dev
  libassimp-dev libdraco-dev libmeshoptimizer-dev
  libopenexr-dev libspng-dev libturbojpeg0-dev libwebp-dev libhdf5-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev
  # Python module
  python3 python3-dev python3-numpy pybind11-dev python3-pytest mypy
  # tests, benchmarks, style
  libgtest-dev libgmock-dev librapidcheck-dev
  clang clang-format clang-tidy libclang-rt-14-dev
  # the comparison against Mesa in `make bench`, and graphics hardware
  libegl-dev libepoxy-dev libgl1-mesa-dri libegl-mesa0
)
# the Khronos glTF validator and three.js (npm)
[ -z "$tests" ] || packages+=(nodejs npm)

installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' 2>/dev/null | sed -n 's/^installed //p')
missing=()
for package in "${packages[@]}"; do
  grep -qxF "$package" <<<"$installed" || missing+=("$package")
done
# A Node.js that is already there (a newer one often conflicts with Debian's npm package) is good enough.
if command -v npm >/dev/null && command -v node >/dev/null; then
  kept=()
  for package in "${missing[@]}"; do case "$package" in nodejs | npm) ;; *) kept+=("$package") ;; esac; done
  missing=("${kept[@]}")
fi

if [ ${#missing[@]} -gt 0 ]; then
  echo "Aktina needs these Debian packages and will install them now:"
  printf '  %s\n' "${missing[*]}" | fold -s -w 100
  sudo=""
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "error: not root and no sudo: install the packages above, then run again" >&2; exit 1; }
    sudo=sudo
  fi
  $sudo apt-get update -q
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
fi

[ -n "$tests" ] || exit 0
# The validator and three.js go into node_modules/ here, where the tests look for them. Tests that show models in a
# browser run where chromium is installed.
here=$(cd "$(dirname "$0")/.." && pwd)
packages=(gltf-validator@2.0.0-dev.3.10 three@0.187.0)
wanted=()
for package in "${packages[@]}"; do
  grep -qs "\"version\": \"${package#*@}\"" "$here/node_modules/${package%@*}/package.json" || wanted=("${packages[@]}")
done
if [ ${#wanted[@]} -gt 0 ]; then
  echo "Aktina's tests need the Khronos glTF validator and three.js (npm) and will install them now:  ${wanted[*]}"
  npm install --prefix "$here" --no-save --no-package-lock --no-audit --no-fund --loglevel=error "${wanted[@]}" >/dev/null || {
    echo "error: npm could not install them: is its registry within reach?" >&2
    exit 1
  }
fi
