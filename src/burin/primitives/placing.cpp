#include <cmath>

#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/primitives/placing.hpp>

namespace burin::primitives {

namespace {

constexpr std::uint64_t mirror_purpose = 5;
constexpr std::uint64_t jitter_purpose = 6;

Stops stops_of(const PlacingSpec& spec) {
  if (spec.every.length_mm > 0.0) return Stops::lengths;
  return spec.at == PlaceAt::edges ? Stops::midpoints : Stops::points;
}

PositionUse used_by_all(const PlacingSpec& spec, const PenFilter& filter) {
  const PositionUse used = variables_used(spec);
  return filter.pens == nullptr ? used : used | filter.pens->used();
}

template <class T>
double value_of(const Choice<T>& choice, const PositionValues& values) {
  return choice.of[choice.pick(values)].value(values);
}

/// u -> P + s R(phi) u, of a figure that is mirrored first.
Affine2 placement(Vec2 point, double scale, double degrees, bool mirrored) {
  return translation(point) * rotation_degrees(degrees) * scaling(scale, mirrored ? -scale : scale);
}

}  // namespace

Placing::Placing(PathSink& next, const PlacingSpec& spec, const Figures& figures, const Setting& setting,
                 const PenFilter& filter)
    : next_(next),
      spec_(spec),
      figures_(figures),
      setting_(setting),
      filter_(filter),
      used_(used_by_all(spec, filter)),
      mm_per_unit_(setting.slot_from_model.scale()),
      walk_(stops_of(spec), spec.every.length_mm / mm_per_unit_, [this](const Frame& frame) { return visit(frame); }) {
  if (spec.distinct) distinct_.emplace(distinct_mm);
  if (spec.apart.mm > 0.0) apart_.emplace(spec.apart.mm);
}

void Placing::begin_level(std::uint64_t retained_every) {
  retained_every_ = spec_.mode == PlaceMode::fresh ? retained_every : 0;
  next_path_ = 0;
}

Flow Placing::begin(const PathHead& head) {
  head_ = head;
  place_ = {head.level, next_path_++};
  walk_.begin(head.closed);
  return Flow::go;
}

Flow Placing::contour() {
  if (walk_.finish() == Flow::stop) return Flow::stop;
  place_.path = next_path_++;
  walk_.begin(head_.closed);
  return Flow::go;
}

/// Whether this point is new, and its turn among those that are.
bool Placing::is_turn(std::uint64_t index) const {
  if (retained_every_ > 1) {
    if (index % retained_every_ == 0) return false;
    index -= index / retained_every_ + 1;
  }
  return index % static_cast<std::uint64_t>(spec_.every.count) == 0;
}

Vec2 Placing::jittered(const Frame& frame) const {
  if (!(spec_.jitter.mm > 0.0)) return frame.point;
  const auto chance = [&](std::uint64_t which) {
    return uniform(setting_.seed, jitter_purpose, place_.level, place_.path, frame.index, which);
  };
  // Evenly over the disc.
  const double radius = std::sqrt(chance(0)) * spec_.jitter.mm / mm_per_unit_;
  const double degrees = 360.0 * chance(1);
  return frame.point + radius * Vec2{math::cos_degrees(degrees), math::sin_degrees(degrees)};
}

bool Placing::is_mirrored(const Frame& frame) const {
  switch (spec_.mirror) {
    case PlaceMirror::none:
      return false;
    case PlaceMirror::all:
      return true;
    case PlaceMirror::alternate:
      return (frame.index / static_cast<std::uint64_t>(spec_.every.count)) % 2 == 1;
    case PlaceMirror::random:
      return uniform(setting_.seed, mirror_purpose, place_.level, place_.path, frame.index) < 0.5;
  }
  return false;
}

Flow Placing::visit(const Frame& frame) {
  if (!is_turn(frame.index)) return Flow::go;
  const PositionValues values = position_values(setting_, place_, frame, used_);
  if (!(value_of(spec_.when, values) > 0.0)) return Flow::go;
  const Vec2 point = jittered(frame);
  // Spaced on the page, and before figures and pens are chosen: all pens see the same places.
  if (distinct_ && !distinct_->take(mm_per_unit_ * (setting_.origin + frame.point))) return Flow::go;
  if (apart_ && !apart_->take(mm_per_unit_ * (setting_.origin + point))) return Flow::go;
  if (item_ != nullptr) ++*item_;
  const Figure* figure = figures_[spec_.use.pick(values)].get();
  if (figure == nullptr) return Flow::go;
  if (filter_.pens != nullptr && filter_.pens->pick(values) != filter_.pen) return Flow::go;
  const double scale = value_of(spec_.scale, values) / mm_per_unit_;
  const double degrees = value_of(spec_.rotate, values);
  if (!(scale > 0.0 && std::isfinite(scale) && std::isfinite(degrees) && is_finite(point))) return Flow::go;
  return next_.place(head_, *figure, placement(point, scale, degrees, is_mirrored(frame)));
}

}  // namespace burin::primitives
