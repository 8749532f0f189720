#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <burin/preset/load.hpp>

/// Presets as short texts.
namespace burin::preset {

/// A layer that is right, for presets whose point is elsewhere. Four lines.
inline constexpr std::string_view one_layer = "[[layer]]\ncurve = { family = \"two-point\" }\n";

inline Result<Piece> load_text(std::string_view text, const Overrides& overrides = {}, const ReadFile& read_file = {}) {
  return load({"p.toml", std::string(text)}, overrides, read_file);
}

/// The piece of a preset that must be right: "burin = 1", then `text`, then a layer.
inline Piece piece_of(std::string_view text, const Overrides& overrides = {}) {
  Result<Piece> piece = load_text("burin = 1\n" + std::string(text) + "\n" + std::string(one_layer), overrides);
  if (piece) return *std::move(piece);
  ADD_FAILURE() << problems_text(piece.problems());
  return {};
}

/// What is wrong with a preset, a line each, without the source lines; empty when nothing is.
inline std::string complaints(std::string_view text, const Overrides& overrides = {}) {
  const Result<Piece> piece = load_text(text, overrides);
  if (piece) return {};
  std::string all;
  for (Problem problem : piece.problems()) {
    problem.source_line.clear();
    all += problem_text(problem) + '\n';
  }
  return all;
}

/// The same for "burin = 1" on line 1, `text` from line 2 on, and then a layer.
inline std::string complaints_in(std::string_view text, const Overrides& overrides = {}) {
  return complaints("burin = 1\n" + std::string(text) + "\n" + std::string(one_layer), overrides);
}

}  // namespace burin::preset
