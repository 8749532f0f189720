#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/grey_picture.hpp"
#include "support/run_tool.hpp"
#include "support/temporary_folder.hpp"

/// The tool and the programs of others, as these tests call them.
namespace burin::test {

/// Runs a program of this machine in the folder; it must succeed.
inline Finished run_in(const TemporaryFolder& folder, const std::vector<std::string>& words) {
  ToolSetup setup;
  setup.folder = folder.path().string();
  Finished finished = RunningTool(words, setup).wait(std::chrono::minutes(10));
  EXPECT_EQ(finished.code, 0) << words.front() << (finished.code == 127 ? " is not installed" : "") << '\n'
                              << finished.out << finished.err;
  return finished;
}

/// The same, and it must have nothing to say.
inline void run_silently_in(const TemporaryFolder& folder, const std::vector<std::string>& words) {
  const Finished finished = run_in(folder, words);
  EXPECT_EQ(finished.out + finished.err, "") << words.front();
}

/// Draws a shipped preset into a file of the folder.
inline void draw(const TemporaryFolder& folder, const std::string& preset, const std::string& file,
                 const std::vector<std::string>& options = {}) {
  std::vector<std::string> words = {BURIN_TOOL_PATH, "draw", preset, "--quiet", "-o", file};
  words.insert(words.end(), options.begin(), options.end());
  run_silently_in(folder, words);
}

/// How large to draw, in the words of a program.
struct DrawnAs {
  std::vector<std::string> rsvg;
  std::vector<std::string> mupdf;
};

inline DrawnAs in_pixels(const GreyPicture& like) {
  const std::vector<std::string> size = {"-w", std::to_string(like.width), "-h", std::to_string(like.height)};
  return {size, size};
}

inline DrawnAs in_dots_per_inch(int dpi) {
  const std::string dots = std::to_string(dpi);
  return {{"-d", dots, "-p", dots}, {"-r", dots}};
}

/// An SVG file as librsvg shows it; `file` without its suffix.
inline GreyPicture seen_by_rsvg(const TemporaryFolder& folder, const std::string& file, const DrawnAs& as) {
  std::vector<std::string> words = {"rsvg-convert", file + ".svg", "-o", file + ".rsvg.png"};
  words.insert(words.end(), as.rsvg.begin(), as.rsvg.end());
  run_silently_in(folder, words);
  return read_png(folder.file(file + ".rsvg.png"));
}

/// The page of a PDF file as MuPDF shows it; `file` without its suffix.
inline GreyPicture seen_by_mupdf(const TemporaryFolder& folder, const std::string& file, const DrawnAs& as) {
  std::vector<std::string> words = {"mutool", "draw", "-q", "-o", file + ".mupdf.png"};
  words.insert(words.end(), as.mupdf.begin(), as.mupdf.end());
  words.push_back(file + ".pdf");
  run_in(folder, words);
  return read_png(folder.file(file + ".mupdf.png"));
}

inline constexpr double most_rmse = 6.0;  ///< of 255, that two renderers may differ
inline constexpr double most_ink = 0.01;  ///< of the ink, likewise

/// Leaves what both pictures of a page have: one may have a column or row more, where the page ends within a dot.
inline void crop_to_each_other(GreyPicture& a, GreyPicture& b) {
  EXPECT_NEAR(a.width, b.width, 1);
  EXPECT_NEAR(a.height, b.height, 1);
  const int width = std::min(a.width, b.width);
  const int height = std::min(a.height, b.height);
  a = top_left(a, width, height);
  b = top_left(b, width, height);
}

/// `difference` is one that two renderers may have, and far from that of the same ink at another place.
inline void expect_small(double difference, const GreyPicture& ours) {
  EXPECT_LE(difference, std::min(most_rmse, rmse(ours, moved(ours, ours.width / 10)) / 2.0));
}

inline void expect_alike(GreyPicture ours, GreyPicture theirs) {
  crop_to_each_other(ours, theirs);
  const double difference = rmse(ours, theirs);
  const double ratio = ink(theirs) / ink(ours);
  std::printf("rmse %5.3f of 255, ink x %.4f\n", difference, ratio);
  expect_small(difference, ours);
  EXPECT_NEAR(ratio, 1.0, most_ink);
}

}  // namespace burin::test
