#include <cli/cairo_back_ends.hpp>

#if defined(BURIN_CAIRO_LIBRARY)
#include <dlfcn.h>
#include <filesystem>
#include <string>

#include <burin/output/back_ends.hpp>
#endif
#ifdef BURIN_HAS_CAIRO
#include <burin/output_cairo/back_ends.hpp>
#endif

namespace burin::cli {

#if defined(BURIN_CAIRO_LIBRARY)

namespace {

/// The library lies beside the core's, which is where those rows are.
std::string library_path() {
  Dl_info core{};
  if (dladdr(output::back_ends().data(), &core) == 0 || core.dli_fname == nullptr) return BURIN_CAIRO_LIBRARY;
  return (std::filesystem::path(core.dli_fname).parent_path() / BURIN_CAIRO_LIBRARY).string();
}

std::span<const BackEnd> loaded() {
  // For good: what it hands out is code.
  void* const library = dlopen(library_path().c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library == nullptr ? nullptr : dlsym(library, "burin_cairo_back_ends");
  if (symbol == nullptr) {
    throw MissingLibrary(std::string(dlerror()) + ": install all of burin, or draw with --backend native");
  }
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
