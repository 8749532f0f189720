#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <burin/base/check.hpp>

namespace burin {

/// Says where along a line its dashes lie: on, off, on ... again and again; an odd list is read twice. Source: SVG 1.1,
/// 11.4. O(1) memory.
class DashWalk {
 public:
  /// The pattern begins `offset` before the line, or after it begins when negative. Pre: no length is below 0, and one
  /// is above.
  DashWalk(std::vector<double> lengths, double offset) : lengths_(std::move(lengths)) {
    const std::size_t count = lengths_.size();
    for (std::size_t i = 0; count % 2 == 1 && i < count; ++i) lengths_.push_back(lengths_[i]);
    for (const double length : lengths_) period_ += length;
    BURIN_EXPECT(period_ > 0.0);
    offset_ = std::fmod(offset, period_);
    restart();
  }

  double period() const { return period_; }

  /// Goes back to the line's beginning.
  void restart() {
    dash_ = 0;
    left_ = lengths_[0];
    skip(offset_ < 0.0 ? offset_ + period_ : offset_);
  }

  /// Goes on without looking.
  void skip(double length) {
    double rest = std::fmod(length, period_);
    while (rest >= left_ && rest > 0.0) {
      rest -= left_;
      next();
    }
    left_ -= rest;
  }

  /// Goes on, and calls visit(from, to), 0 <= from <= to <= length, for what of that way is dashes, in order. A dash
  /// that goes on behind the end is visited up to there; one without length is a dot. Time: O(dashes).
  template <class Visit>
  void go(double length, const Visit& visit) {
    double at = 0.0;
    while (length - at > left_) {
      const double end = at + left_;
      if (on() && (left_ > 0.0 || lengths_[dash_] == 0.0)) visit(at, end);
      at = end;
      next();
    }
    if (on() && length > at) visit(at, length);
    left_ -= length - at;
  }

 private:
  bool on() const { return dash_ % 2 == 0; }
  void next() {
    dash_ = dash_ + 1 < lengths_.size() ? dash_ + 1 : 0;
    left_ = lengths_[dash_];
  }

  std::vector<double> lengths_;
  double period_ = 0.0;
  double offset_ = 0.0;
  std::size_t dash_ = 0;  ///< index into lengths_; even: on
  double left_ = 0.0;     ///< of that dash
};

}  // namespace burin
