#!/usr/bin/env bash
# same_bytes.sh: builds the tool with g++ and clang at -O0 and -O3, draws every shipped preset with each as SVG, PNG, CSV
# and dump, and fails on the first file that is not the same byte for byte. Each must also draw the goldens as they are.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

builds=(g++:-O0 g++:-O3 clang++-14:-O0 clang++-14:-O3)
work=build/same_bytes
first=

for build in "${builds[@]}"; do
  compiler=${build%%:*}
  level=${build##*:}
  folder=$work/$compiler$level
  cmake -S . -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$level" \
    -DBURIN_TESTS=OFF -DBURIN_CAIRO=OFF > /dev/null
  cmake --build "$folder"
  pictures=$folder/pictures
  rm -rf "$pictures"
  mkdir -p "$pictures"
  printf '%s\n' presets/*.toml | xargs -P "$(nproc)" -I {} "$folder/bin/burin" draw {} --threads 1 \
    -o "$pictures/{preset}.svg" -o "$pictures/{preset}.png" -o "$pictures/{preset}.csv" -o "$pictures/{preset}.dump" \
    > /dev/null
  "$folder/bin/burin" golden tests/golden --quiet
  if [[ -z $first ]]; then
    first=$pictures
  elif ! diff -rq "$first" "$pictures"; then
    echo "error: $build draws other bytes than ${builds[0]}" >&2
    exit 1
  fi
done
echo "$(find "$first" -type f | wc -l) files, the same from ${builds[*]}"
