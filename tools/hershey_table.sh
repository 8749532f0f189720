#!/usr/bin/env bash
# Writes a C++ table of glyphs from a Hershey font in James Hurt's format (.jhf, as in Debian's hershey-fonts-data):
#   tools/hershey_table.sh rowmans /usr/share/hershey-fonts/rowmans.jhf > src/burin/curves/text/hershey/rowmans.cpp
# A record is the glyph's number (5 characters), how many pairs of letters follow (3), and the pairs; only the pairs are
# kept. The 95 glyphs of printable ASCII are taken; the 96th record of a font stands for DEL.
set -euo pipefail

if (($# != 2)); then
  echo "usage: $0 NAME FILE.jhf" >&2
  exit 2
fi

cat << HEAD
// Made by tools/hershey_table.sh from $(basename "$2"). The Hershey Fonts were originally created by Dr. A. V. Hershey while
// working at the U. S. National Bureau of Standards; the format of the data by James Hurt. See LICENSE-hershey.
#include <burin/curves/text/hershey/hershey.hpp>

namespace burin::curves::lettering::hershey {

// clang-format off
const GlyphTexts $1{
HEAD
awk '{ sub(/\r$/, "") }
  NR <= 95 {
    pairs = substr($0, 9)
    if (length(pairs) != 2 * substr($0, 6, 3)) { print FILENAME ":" NR ": not one record a line" > "/dev/stderr"; exit 1 }
    printf "    /* %c */ R\"~(%s)~\",\n", 31 + NR, pairs
  }' "$2"
cat << TAIL
};
// clang-format on

}  // namespace burin::curves::lettering::hershey
TAIL
