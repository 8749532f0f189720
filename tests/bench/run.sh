#!/usr/bin/env bash
# Builds the tool as it is shipped, runs every bench, and writes their tables, with machine and date, into README.md
# beside this file. On a machine with nothing else to do: about ten minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=tests/bench

cmake --preset release -DBURIN_TESTS=ON > /dev/null
cmake --build --preset release --target test_bench
log=$(mktemp)
trap 'rm -f "$log"' EXIT
passed=true
# Each in a process of its own, whose memory is then its own.
ctest --test-dir build/release -R "^bench[.]" -V | sed "s/^[0-9]*: //" | tee "$log" || passed=false

table() { sed -n "s/^$1 |/|/p" "$log"; }
{
  sed '/^<!-- made by run.sh -->$/q' "$folder/README.md"
  printf '\n%s, %s threads, %s, %s.\n' "$(sed -n 's/^model name\s*: //p;T;q' /proc/cpuinfo)" "$(nproc)" "$(g++ --version | head -1)" \
    "$(date -u +%F)"
  printf '\n| Ratio of CPU times | median | least | most |\n| --- | ---: | ---: | ---: |\n%s\n' "$(table ratio)"
  printf '\n| Cost | CPU s | wall s | peak MiB |\n| --- | ---: | ---: | ---: |\n%s\n' "$(table cost)"
} > "$log.md"
mv "$log.md" "$folder/README.md"
$passed
