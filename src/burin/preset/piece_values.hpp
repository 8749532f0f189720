#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <burin/params/number_list.hpp>
#include <burin/params/read_value.hpp>
#include <burin/preset/piece.hpp>

/// How the values of a Piece are written in a preset. Include this wherever a field table of piece.hpp is read.
namespace burin {

constexpr auto words(Cap) {
  return std::array<params::Word<Cap>, 3>{{{"round", Cap::round}, {"butt", Cap::butt}, {"square", Cap::square}}};
}

constexpr auto words(Join) {
  return std::array<params::Word<Join>, 3>{{{"round", Join::round}, {"miter", Join::miter}, {"bevel", Join::bevel}}};
}

}  // namespace burin

namespace burin::preset {

/// The parts of a text between blanks that stand outside parentheses: "5mm ($w * 2)mm" has two.
std::vector<std::string> split_words(std::string_view text);

}  // namespace burin::preset

namespace burin::params {

template <>
struct ValueType<Colour> {
  static std::string name() { return "color"; }
  static bool read(const Value& value, Colour& colour, ReadContext& context);
  static std::string text(const Colour& colour);
};

template <>
struct ValueType<preset::PageSize> {
  static std::string name() { return "paper"; }
  static bool read(const Value& value, preset::PageSize& size, ReadContext& context);
  static std::string text(const preset::PageSize& size);
};

template <>
struct ValueType<preset::Margins> {
  static std::string name() { return "one to four lengths"; }
  static bool read(const Value& value, preset::Margins& margins, ReadContext& context);
  static std::string text(const preset::Margins& margins);
};

template <>
struct ValueType<preset::SlotRect> {
  static std::string name() { return "x y w h"; }
  static bool read(const Value& value, preset::SlotRect& rect, ReadContext& context);
  static std::string text(const preset::SlotRect& rect);
};

template <>
struct ValueType<preset::Align> {
  static std::string name() { return "one or two words"; }
  static bool read(const Value& value, preset::Align& align, ReadContext& context);
  static std::string text(const preset::Align& align);
};

template <>
struct ValueType<preset::Grid> {
  static std::string name() { return "[columns, rows]"; }
  static bool read(const Value& value, preset::Grid& grid, ReadContext& context);
  static std::string text(const preset::Grid& grid);
};

template <>
struct ValueType<preset::SymmetryName> {
  static std::string name() { return "symmetry"; }
  static bool read(const Value& value, preset::SymmetryName& symmetry, ReadContext& context);
  static std::string text(const preset::SymmetryName& symmetry);
};

template <>
struct ValueType<preset::PenChoice> {
  static std::string name() { return "pen, list or bands"; }
  static bool read(const Value& value, preset::PenChoice& choice, ReadContext& context);
  static std::string text(const preset::PenChoice& choice);
};

/// Any value, kept as it is.
template <>
struct ValueType<Value> {
  static std::string name() { return "any value"; }
  static bool read(const Value& value, Value& target, ReadContext&) {
    target = value;
    return true;
  }
  static std::string text(const Value&) { return {}; }
};

}  // namespace burin::params
