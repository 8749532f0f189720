#!/usr/bin/env bash
# run.sh SECONDS: builds the fuzz targets and lets each run that long, seeded with the shipped presets.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seconds=${1:-30}

cmake --preset fuzz > /dev/null
cmake --build --preset fuzz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for target in svg_path png preset; do
  mkdir "$work/$target"
  if [[ $target == preset ]]; then
    cp presets/*.toml "$work/$target"
  elif [[ $target == png ]]; then
    cp gallery/*.png "$work/$target"
  else
    printf 'M0 0c1 1 2-1e-3.5.5zm1 1a1 1 0 01.5.5' > "$work/$target/seed"
  fi
  echo "fuzz_$target: $seconds s"
  if ! "build/fuzz/tests/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -close_fd_mask=3 \
    -artifact_prefix=build/fuzz/ -print_final_stats=1 "$work/$target" > "$work/$target.log" 2>&1; then
    echo "error: fuzz_$target found something; its input is in build/fuzz/" >&2
    tail -n 40 "$work/$target.log" >&2
    exit 1
  fi
done
