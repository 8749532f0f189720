#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/params/fields.hpp>
#include <burin/preset/findings.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/piece_values.hpp>

namespace burin::preset {

enum class KnobKind : std::uint8_t { integer, number, length, color, text, flag };
constexpr auto words(KnobKind) {
  return std::array<params::Word<KnobKind>, 6>{{{"integer", KnobKind::integer},
                                                {"number", KnobKind::number},
                                                {"length", KnobKind::length},
                                                {"color", KnobKind::color},
                                                {"text", KnobKind::text},
                                                {"flag", KnobKind::flag}}};
}

/// A knob as it is declared.
struct KnobSpec {
  std::optional<params::Value> preset_value;
  std::optional<params::Value> min;
  std::optional<params::Value> max;
  std::vector<params::Value> choices;
  std::optional<KnobKind> kind;
  std::optional<std::array<double, 2>> random;
  std::string doc;

  static constexpr auto fields() {
    return std::tuple{
        params::field("default", &KnobSpec::preset_value, "its value when nobody turns it; gives it its kind"),
        params::field("min", &KnobSpec::min, "lowest number or length it takes"),
        params::field("max", &KnobSpec::max, "highest number or length it takes"),
        params::field("choices", &KnobSpec::choices, "the only values it takes"),
        params::field("kind", &KnobSpec::kind, "unset: as its default is written"),
        params::field("random", &KnobSpec::random,
                      "[low, high) to draw from by the seed, instead of a default; whole numbers with kind = "
                      "\"integer\", both ends included"),
        params::field("doc", &KnobSpec::doc, "what it does, for burin show")};
  }
};

/// A declared knob with the value it has now.
struct Knob {
  std::string name;
  KnobSpec spec;
  KnobKind kind = KnobKind::text;
  std::optional<params::Value> value;  ///< bool, whole number, number or text; nothing when it is wrong
  bool drawn = false;                  ///< the value came from the seed

  KnobInfo info() const;
};

/// Reads [knobs] and sets each knob: to its default or a draw from the seed, then as the overrides say. A draw is keyed
/// by (seed, name of the knob), so one knob more changes no other.
std::vector<Knob> read_knobs(const params::Table& root, std::uint64_t seed, const Overrides& overrides,
                             params::ReadContext& context);

/// A number, truth value or text as it would be written; "(-3)" is left to whoever puts it into an expression.
std::string scalar_text(const params::Value& value);

}  // namespace burin::preset
