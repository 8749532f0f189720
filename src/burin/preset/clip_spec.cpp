#include <algorithm>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/geom/direction.hpp>
#include <burin/preset/clip_spec.hpp>
#include <burin/preset/piece.hpp>
#include <burin/preset/piece_values.hpp>
#include <burin/preset/slot_layout.hpp>

namespace burin::preset {

namespace {

std::vector<Vec2> box_outline(Vec2 low, Vec2 high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

std::vector<Vec2> disc_outline(Vec2 centre, double radius_mm) {
  constexpr double sagitta_mm = 1e-3;
  constexpr double least_corners = 16.0;
  // The edge of a polygon of n corners lies r (1 - cos(pi / n)) inside, about r pi^2 / (2 n^2).
  const double corners = std::ceil(math::pi * std::sqrt(radius_mm / (2.0 * sagitta_mm)));
  const auto count = static_cast<int>(std::clamp(corners, least_corners, 1e5));
  std::vector<Vec2> outline;
  for (int i = 0; i < count; ++i) {
    const double angle = math::tau * i / count;
    outline.push_back(centre + radius_mm * direction(angle));
  }
  return outline;
}

}  // namespace

std::vector<Vec2> clip_outline(const ClipTable& clip, const SlotFrame& slot, const PageSpec& page) {
  const Vec2 offset = clip.at.size() == 2 ? Vec2{clip.at[0].mm, -clip.at[1].mm} : Vec2{};
  const Vec2 centre = slot.centre_mm + offset;
  const auto about = [](Vec2 middle, double width_mm, double height_mm) {
    const Vec2 half{0.5 * width_mm, 0.5 * height_mm};
    return box_outline(middle - half, middle + half);
  };
  switch (clip.shape) {
    case ClipShape::disc:
      return disc_outline(centre, clip.r.mm);
    case ClipShape::rectangle:
      return about(centre, clip.width.mm, clip.height.mm);
    case ClipShape::slot:
      return about(slot.centre_mm, slot.width_mm, slot.height_mm);
    case ClipShape::live:
      return box_outline({page.margin.left_mm, page.margin.top_mm},
                         {page.size.width_mm - page.margin.right_mm, page.size.height_mm - page.margin.bottom_mm});
    case ClipShape::page:
      return box_outline({0.0, 0.0}, {page.size.width_mm, page.size.height_mm});
  }
  return {};
}

}  // namespace burin::preset

namespace burin::params {

using preset::ClipShape;
using preset::ClipSpec;

bool ValueType<ClipSpec>::read(const Value& value, ClipSpec& clip, ReadContext& context) {
  if (const std::string* layer = value.text()) {
    clip.layer = *layer;
    return true;
  }
  const Table* table = value.table();
  if (table == nullptr)
    return report_kind(value, "the name of a layer, or { shape = \"disc\", r = \"70mm\" }", context);
  if (!read_fields(*table, clip.table, "clip", context)) return false;
  const std::size_t problems_before = context.problems.size();
  const auto needs = [&](std::string_view key, const Length& length) {
    if (!(length.mm > 0.0)) context.report(value.where, "the shape needs '" + std::string(key) + "' above 0");
  };
  if (clip.table.shape == ClipShape::disc) needs("r", clip.table.r);
  if (clip.table.shape == ClipShape::rectangle) {
    needs("width", clip.table.width);
    needs("height", clip.table.height);
  }
  if (!clip.table.at.empty() && clip.table.at.size() != 2) {
    context.report(table->find("at")->where, "'at' is a list of two lengths: [x, y]");
  }
  return context.problems.size() == problems_before;
}

std::string ValueType<ClipSpec>::text(const ClipSpec& clip) {
  return clip.layer.empty() ? std::string() : ValueType<std::string>::text(clip.layer);
}

}  // namespace burin::params
