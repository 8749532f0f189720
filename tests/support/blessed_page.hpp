#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/burin.hpp>

/// Pages of docs/ that are written from the code, with pictures. BURIN_BLESS=1 writes them anew, and fails.
namespace burin::test {

inline std::filesystem::path docs_folder() {
  return std::filesystem::path(BURIN_SOURCE_DIR) / "docs";
}

/// Holds a file to what it should say.
inline void hold_file(const std::filesystem::path& file, const std::string& expected) {
  std::ostringstream kept;
  kept << std::ifstream(file).rdbuf();
  if (std::getenv("BURIN_BLESS") != nullptr) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << expected;
  }
  // Not compared by EXPECT_EQ, which would print a whole picture.
  EXPECT_TRUE(kept.str() == expected) << file << ": run again with BURIN_BLESS=1 to write it anew";
}

struct PagePicture {
  std::string name;
  std::string svg;
};

/// Holds the pictures of a page, docs/images/FOLDER/NAME.svg, to these: no other, and small enough together.
inline void hold_pictures(const std::string& folder_name, const std::vector<PagePicture>& pictures) {
  constexpr std::size_t most_bytes = 600'000;
  const std::filesystem::path folder = docs_folder() / "images" / folder_name;
  std::size_t total_bytes = 0;
  for (const PagePicture& picture : pictures) {
    hold_file(folder / (picture.name + ".svg"), picture.svg);
    total_bytes += picture.svg.size();
  }
  EXPECT_LT(total_bytes, most_bytes);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_TRUE(std::ranges::count(pictures, entry.path().stem().string(), &PagePicture::name) == 1)
        << entry.path() << " is no picture of the page";
  }
}

/// A sheet as a small SVG on its paper; `draw` draws it.
inline std::string page_svg(const Sheet& sheet, const std::function<void(PathSink&)>& draw) {
  StringSink bytes;
  OutputOptions options;
  options.paper = true;
  options.decimals = 2;
  const BackEnd& svg = output::back_ends().front();
  EXPECT_EQ(svg.format, "svg");
  const std::unique_ptr<OutputSink> sink = svg.open(bytes, sheet, options);
  draw(*sink);
  EXPECT_TRUE(sink->finish().ok());
  return bytes.take();
}

}  // namespace burin::test
