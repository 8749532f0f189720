#pragma once

#include <memory>

#include <cairo.h>

namespace burin::output_cairo {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

/// Cairo's objects are never null: one that could not be made carries an error status and ignores every call.
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;
using Context = std::unique_ptr<cairo_t, DestroyContext>;

}  // namespace burin::output_cairo
