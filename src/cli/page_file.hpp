#pragma once

#include <functional>
#include <string>

#include <burin/path/path_sink.hpp>
#include <burin/path/sheet.hpp>
#include <cli/console.hpp>

namespace burin::cli {

/// A page that is no preset: what it is called, and how it is drawn.
struct PageDrawing {
  Sheet sheet;
  std::function<Flow(PathSink& sink)> draw;
};

/// Writes a page to `path` in the format of its suffix ("-": SVG to stdout), whole or not at all. `who` ("burin show")
/// is whose usage is told when the file's name is wrong.
ExitCode write_page(const PageDrawing& page, const std::string& path, const std::string& who, const Console& console);

}  // namespace burin::cli
