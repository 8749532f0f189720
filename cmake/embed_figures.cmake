# cmake -D FOLDER=primitives -D OUTPUT=shipped_figures.cpp -P embed_figures.cmake
# Writes the table of the SVG files in FOLDER, by name in byte order.
file(GLOB figures ${FOLDER}/*.svg)
set(rows "")
set(names "")
foreach(figure IN LISTS figures)
  get_filename_component(name ${figure} NAME_WE)
  list(APPEND names ${name})
endforeach()
list(SORT names COMPARE STRING)
foreach(name IN LISTS names)
  file(READ ${FOLDER}/${name}.svg text)
  string(APPEND rows "    {\"${name}\", R\"~~(${text})~~\"},\n")
endforeach()
list(LENGTH names count)
file(WRITE ${OUTPUT} "// Written by cmake/embed_figures.cmake from primitives/*.svg.
#include <array>

#include <burin/primitives/library.hpp>

namespace burin::primitives {

std::span<const ShippedFigure> shipped_figures() {
  static constexpr std::array<ShippedFigure, ${count}> figures{{
${rows}  }};
  return figures;
}

}  // namespace burin::primitives
")
