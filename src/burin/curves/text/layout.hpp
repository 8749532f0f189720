#pragma once

#include <map>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/curves/text/glyph.hpp>
#include <burin/curves/text/text.hpp>

namespace burin::curves::lettering {

/// Text set in lines: which glyph stands where. Model units: a capital is 1 high, the first baseline is y = 0.
class Layout {
 public:
  /// Characters without a glyph become a hollow box, as do bytes that are not UTF-8. Places count from `origin`.
  /// O(characters).
  explicit Layout(const TextParams& params, Vec2 origin = {});

  struct Letter {
    const Glyph* glyph = nullptr;
    Vec2 at;  ///< of its pen on the baseline
  };
  const std::vector<Letter>& letters() const { return letters_; }

  /// A point of a glyph set at `at`.
  Vec2 point(Vec2 glyph_point, Vec2 at) const {
    const double y = glyph_point.y / units_per_cap;
    return {at.x + (glyph_point.x / units_per_cap + shear_ * y), at.y + y};
  }

  /// The longest line from its first pen to its last.
  double width() const { return width_; }

 private:
  std::map<char32_t, Glyph> glyphs_;
  std::vector<Letter> letters_;
  double shear_ = 0.0;
  double width_ = 0.0;
};

}  // namespace burin::curves::lettering
