#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include <burin/primitives/library.hpp>
#include <cli/figure_library.hpp>
#include <cli/file_io.hpp>
#include <cli/personal_folder.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

bool is_called(const std::vector<LibraryFigure>& figures, const std::string& name) {
  return std::any_of(figures.begin(), figures.end(), [&](const LibraryFigure& figure) { return figure.name == name; });
}

}  // namespace

std::vector<LibraryFigure> library_figures() {
  std::vector<LibraryFigure> figures;
  for (const primitives::ShippedFigure& figure : primitives::shipped_figures()) {
    figures.push_back({std::string(figure.name), false});
  }
  std::vector<std::string> own;
  if (const std::optional<std::string> folder = personal_folder("primitives")) {
    std::error_code error;
    for (fs::directory_iterator at(*folder, error), end; !error && at != end; at.increment(error)) {
      const std::string name = at->path().stem().string();
      if (at->path().extension() == ".svg" && at->is_regular_file(error) && !is_called(figures, name)) {
        own.push_back(name);
      }
    }
  }
  std::sort(own.begin(), own.end());
  for (std::string& name : own) figures.push_back({std::move(name), true});
  return figures;
}

bool is_library_figure(const std::string& name) {
  return is_called(library_figures(), name);
}

Result<primitives::Primitive> read_figure(const std::string& word) {
  return primitives::find_primitive(word, data_reader(""));
}

}  // namespace burin::cli
