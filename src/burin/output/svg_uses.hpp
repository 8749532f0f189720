#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <burin/output/path_data.hpp>
#include <burin/path/back_end.hpp>
#include <burin/path/recording.hpp>

namespace burin::output {

/// Figures that an SVG holds once, in <defs>, and shows by <use>. A pen's width must not scale, so each size of a
/// figure is a definition of its own, in millimetres; a use only turns, mirrors and moves it. Memory: 64 figures.
class SvgUses {
 public:
  static constexpr std::size_t most_definitions = 64;
  static constexpr std::uint64_t most_uses = 200'000;

  explicit SvgUses(int decimals) : data_(decimals) {}

  /// The elements that show the figure, the first time with its definition; empty for one that must be drawn as paths:
  /// with areas where the layer has lines (or the other way around), bent out of shape, too large, or beyond the
  /// limits.
  std::string show(const Figure& figure, const Affine2& at, Paint layer_paint);

 private:
  struct Definition {
    Figure figure;
    std::int64_t size_nm = 0;  ///< of the figure's unit
  };

  std::string define(const Figure& figure, double scale, std::size_t number);
  std::string path_text(const Recording& drawing, const Recording::Path& path, double scale);

  PathData data_;
  std::vector<Definition> definitions_;
  std::uint64_t uses_ = 0;
};

}  // namespace burin::output
