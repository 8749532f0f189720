#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <burin/path/recording.hpp>
#include <burin/primitives/placing_spec.hpp>
#include <burin/primitives/spacing.hpp>
#include <burin/primitives/walk.hpp>

namespace burin::primitives {

/// The figures of a PlacingSpec, one for each name of `use.of`; null: "none".
using Figures = std::vector<std::shared_ptr<const Figure>>;

/// Lets one of several pens place what it draws.
struct PenFilter {
  const Choice<std::string>* pens = nullptr;
  std::size_t pen = 0;
};

/// Takes a curve's paths, draws none of them and puts figures along them instead: u -> P + s R(phi) u, in model units.
/// Only `distinct` and `apart` keep anything in mind (Spacing). Source: reference curves H.
class Placing final : public PathSink {
 public:
  /// `spec` and `figures` must outlive the sink and be nobody else's meanwhile.
  Placing(PathSink& next, const PlacingSpec& spec, const Figures& figures, const Setting& setting,
          const PenFilter& filter);

  /// `item` is counted up at each place, also where another pen or no figure is its turn.
  void count_items(std::uint64_t& item) { item_ = &item; }

  /// Call before each level that is drawn. `retained_every`: see curves::Family.
  void begin_level(std::uint64_t retained_every);

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override { return walk_.points(points); }
  Flow contour() override;
  Flow end() override { return walk_.finish(); }
  /// What is placed already stays as it is.
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override {
    return next_.place(head, figure, at);
  }

  /// Whether `distinct` or `apart` left out a place since it could remember no more.
  bool overflowed() const { return (distinct_ && distinct_->full()) || (apart_ && apart_->full()); }

 private:
  bool is_turn(std::uint64_t index) const;
  Flow visit(const Frame& frame);
  Vec2 jittered(const Frame& frame) const;
  bool is_mirrored(const Frame& frame) const;

  PathSink& next_;
  const PlacingSpec& spec_;
  const Figures& figures_;
  Setting setting_;
  PenFilter filter_;
  PositionUse used_;
  double mm_per_unit_;
  Walk walk_;
  std::optional<Spacing> distinct_;
  std::optional<Spacing> apart_;

  std::uint64_t* item_ = nullptr;
  PathHead head_{};
  PathPlace place_{};
  std::uint64_t next_path_ = 0;
  std::uint64_t retained_every_ = 0;
};

}  // namespace burin::primitives
