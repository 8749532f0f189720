#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <burin/geom/vec2.hpp>
#include <burin/params/fields.hpp>

namespace burin::preset {

struct PageSpec;
struct SlotFrame;

enum class ClipShape : std::uint8_t { disc, rectangle, slot, live, page };
constexpr auto words(ClipShape) {
  return std::array<params::Word<ClipShape>, 5>{{{"disc", ClipShape::disc},
                                                 {"rectangle", ClipShape::rectangle},
                                                 {"slot", ClipShape::slot},
                                                 {"live", ClipShape::live},
                                                 {"page", ClipShape::page}}};
}

/// A shape of the page along which lines are cut: what the closed paths of a layer enclose, or a plain shape.
struct ClipTable {
  ClipShape shape = ClipShape::disc;
  params::Length r;
  params::Length width;
  params::Length height;
  std::vector<params::Length> at;

  static constexpr auto fields() {
    return std::tuple{
        params::field("shape", &ClipTable::shape,
                      "disc or rectangle about the slot's centre; slot, live (the page without its margins) or page"),
        params::field("r", &ClipTable::r, params::not_negative, "radius of a disc"),
        params::field("width", &ClipTable::width, params::not_negative, "of a rectangle"),
        params::field("height", &ClipTable::height, params::not_negative, "of a rectangle"),
        params::field("at", &ClipTable::at, "[x, y]: a disc's or rectangle's centre from the slot's, y up")};
  }
};

struct ClipSpec {
  std::string layer;  ///< empty: the table's shape
  ClipTable table;
};

/// The outline of a plain shape in page millimetres; a disc's corners lie on its rim, its edges at most 1 µm inside.
/// Pre: the spec names no layer.
std::vector<Vec2> clip_outline(const ClipTable& clip, const SlotFrame& slot, const PageSpec& page);

}  // namespace burin::preset

/// "layer name" or { shape = "disc", r = "70mm" }.
template <>
struct burin::params::ValueType<burin::preset::ClipSpec> {
  static std::string name() { return "layer or shape"; }
  static bool read(const Value& value, burin::preset::ClipSpec& clip, ReadContext& context);
  static std::string text(const burin::preset::ClipSpec& clip);
};
