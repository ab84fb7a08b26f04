#!/usr/bin/env bash
# Draws Aktina's own room through the whole engine and says what each picture cost. `make demo` has built it before.
#   scripts/demo.sh BUILD OUT
# Files that are newer than the program and the scene are left as they are.
set -euo pipefail
cd "$(dirname "$0")/.."
program=$1/aktina out=$2 scene=scenes/room.glb
size=(--size 720x480)
light=(--quality draft)
mkdir -p "$out"

row() { printf '%-24s  %-52s  %8s\n' "$@"; }
drawn=0 kept=0

# make_file FILE METHOD COMMAND...: runs the command unless FILE is up to date.
make_file() {
  local file=$out/$1 method=$2 began ended
  shift 2
  if [ "$file" -nt "$program" ] && [ "$file" -nt "$scene" ]; then
    row "$file" "$method" "kept"
    kept=$((kept + 1))
    return
  fi
  began=$(date +%s%N)
  "$program" "$@" -o "$file" --quiet
  ended=$(date +%s%N)
  row "$file" "$method" "$(printf '%d.%02d' $(((ended - began) / 1000000000)) $(((ended - began) / 10000000 % 100)))"
  drawn=$((drawn + 1))
}

row file method seconds
make_file gouraud.png "rasterized, Gouraud shading" render $scene "${size[@]}" --method raster --shading gouraud
make_file phong.png "rasterized, Phong shading" render $scene "${size[@]}" --method raster --shading phong
make_file whitted.png "ray traced, Whitted" render $scene "${size[@]}" --method whitted
make_file path.png "path traced, 16 samples a pixel" render $scene "${size[@]}" --method path --samples 16
make_file path.exr "the same at 4 samples, linear, with layers" \
  render $scene "${size[@]}" --method path --samples 4 --layers albedo,N,Z,direct,indirect,illuminance
make_file radiosity.png "radiosity" render $scene "${size[@]}" --method radiosity "${light[@]}"
make_file two_pass.png "two passes: radiosity, then rays, 8 samples a pixel" \
  render $scene "${size[@]}" --method two_pass --samples 8 "${light[@]}"
make_file room.lit.glb "radiosity as a lit model, for any glTF viewer" bake $scene "${light[@]}"
echo
if [ $drawn -eq 0 ]; then
  echo "All $kept files in $out/ are newer than the program and the scene: nothing to do."
else
  echo "The pictures and the lit model are in $(cd "$out" && pwd)"
fi
