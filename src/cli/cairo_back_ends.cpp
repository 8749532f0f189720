#include <cli/cairo_back_ends.hpp>

#if defined(BURIN_CAIRO_LIBRARY)
#include <dlfcn.h>
#include <stdexcept>
#include <string>
#endif
#ifdef BURIN_HAS_CAIRO
#include <burin/output_cairo/back_ends.hpp>
#endif

namespace burin::cli {

#if defined(BURIN_CAIRO_LIBRARY)

namespace {

std::span<const BackEnd> loaded() {
  // For good: what it hands out is code.
  void* const library = dlopen(BURIN_CAIRO_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library == nullptr ? nullptr : dlsym(library, "burin_cairo_back_ends");
  if (symbol == nullptr) throw std::runtime_error(std::string("Cairo's back ends are not installed: ") + dlerror());
  std::span<const BackEnd> rows;
  reinterpret_cast<decltype(&burin_cairo_back_ends)>(symbol)(rows);
  return rows;
}

}  // namespace

std::span<const BackEnd> cairo_back_ends() {
  static const std::span<const BackEnd> rows = loaded();
  return rows;
}

#elif defined(BURIN_HAS_CAIRO)

std::span<const BackEnd> cairo_back_ends() {
  return output_cairo::back_ends();
}

#else

std::span<const BackEnd> cairo_back_ends() {
  return {};
}

#endif

}  // namespace burin::cli
