#pragma once

#include <string>
#include <vector>

#include <burin/base/problem.hpp>
#include <cli/golden_folder.hpp>

namespace burin::cli {

/// What is asked of every case.
struct GoldenRequest {
  double new_px = 400.0;  ///< longer side of a picture that has no golden; others are as large as theirs
  bool wants_panels = false;
};

/// A golden that is not what the preset draws.
struct GoldenDifference {
  std::string file;     ///< its path
  std::string message;  ///< what is wrong with it, for people
  std::string drawn;    ///< the bytes that would be right
  bool is_new = false;  ///< there was none
};

/// What became of a case.
struct GoldenResult {
  std::string name;
  Problems problems;                          ///< the preset cannot be drawn: nothing else is known then
  std::vector<GoldenDifference> differences;  ///< none: all is as it should be
  std::vector<std::string> data;              ///< paths of the data files that the preset reads
  std::string panels;                         ///< PNG of golden, drawn and difference, when asked for and not equal
};

/// Draws the preset of that name and holds its goldens against it: the canonical dump by its text and the picture of
/// the native back end by its pixels, since another version of the compressor may write other bytes. The picture says
/// nothing of its origin, so that a comment in the preset changes no golden. May be called from several threads.
GoldenResult check_golden(const GoldenFolder& folder, const std::string& name, const GoldenRequest& request);

}  // namespace burin::cli
