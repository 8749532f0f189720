#!/usr/bin/env bash
# consume.sh WAY FOLDER: builds a program that uses burin in one of several ways and looks at what it draws.
# From the environment: BURIN_PREFIX (where it is installed), BURIN_LIBDIR, BURIN_CXX, BURIN_CMAKE.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
way=$1
folder=$2

expect_picture() {
  local svg
  svg=$("$@")
  [[ $svg == *'<svg '*'width="210mm"'*'<path '*'</svg>'* ]] || { echo "no picture: ${svg:0:300}" >&2; exit 1; }
}

fresh() {
  rm -rf "$folder"
  mkdir -p "$folder"
}

configure() {
  fresh
  "$BURIN_CMAKE" -S "$here/$1" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER="$BURIN_CXX" "${@:2}"
}

case $way in
  install)
    rm -rf "$BURIN_PREFIX"
    "$BURIN_CMAKE" --install "$folder" --prefix "$BURIN_PREFIX"
    "$BURIN_PREFIX/bin/burin" --version
    ;;
  find_package)
    configure find_package -DCMAKE_PREFIX_PATH="$BURIN_PREFIX" -DBURIN_INCLUDE_DIR="$BURIN_PREFIX/include"
    "$BURIN_CMAKE" --build "$folder"
    expect_picture "$folder/draw_snowflake"
    ;;
  headers)
    configure find_package -DCMAKE_PREFIX_PATH="$BURIN_PREFIX" -DBURIN_INCLUDE_DIR="$BURIN_PREFIX/include"
    "$BURIN_CMAKE" --build "$folder" --target headers_alone
    ;;
  pkg_config)
    fresh
    export PKG_CONFIG_PATH="$BURIN_PREFIX/$BURIN_LIBDIR/pkgconfig"
    pkg-config --exists --print-errors burin burin-cairo
    read -ra flags <<< "$(pkg-config --cflags --libs burin)"
    "$BURIN_CXX" -std=c++20 "$here/draw_snowflake.cpp" "${flags[@]}" -o "$folder/draw_snowflake"
    expect_picture env LD_LIBRARY_PATH="$BURIN_PREFIX/$BURIN_LIBDIR" "$folder/draw_snowflake"
    ;;
  add_subdirectory)
    # Configures everything and compiles the consumer; building the whole library once more is left to the full check.
    configure add_subdirectory -DBURIN_SOURCE_DIR="$here/../.."
    "$BURIN_CMAKE" --build "$folder" --target CMakeFiles/draw_snowflake.dir"$here"/draw_snowflake.cpp.o
    ;;
  add_subdirectory_build)
    configure add_subdirectory -DBURIN_SOURCE_DIR="$here/../.."
    "$BURIN_CMAKE" --build "$folder" --target draw_snowflake
    expect_picture "$folder/draw_snowflake"
    ;;
  *)
    echo "consume.sh: unknown way '$way'" >&2
    exit 2
    ;;
esac
