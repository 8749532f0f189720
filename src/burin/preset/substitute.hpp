#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <burin/params/value.hpp>
#include <burin/preset/findings.hpp>
#include <burin/preset/knobs.hpp>

namespace burin::preset {

/// Puts the values of knobs into the texts of a preset. "$k" or "${k}" alone becomes the knob's value with its type;
/// inside a longer text it becomes text, a negative number in parentheses so that expressions stay right. "$$" is a
/// dollar, "$seed" the seed. Texts put in are not searched again.
class Substitution {
 public:
  Substitution(const std::vector<Knob>& knobs, std::uint64_t seed, Findings& findings)
      : knobs_(knobs), seed_(seed), findings_(findings) {}

  /// In every text of the tree. Knobs that are unknown are reported, their texts and those of wrong knobs hushed.
  void apply(params::Value& value);

  /// Whether $seed or the value of a drawn knob was put in anywhere.
  bool seed_was_used() const { return seed_was_used_; }

 private:
  std::optional<std::string> text_of(std::string_view name, const Where& where);
  void apply_text(params::Value& value);

  const std::vector<Knob>& knobs_;
  std::uint64_t seed_;
  Findings& findings_;
  bool seed_was_used_ = false;
  std::size_t bytes_left_ = std::size_t{1} << 22U;  ///< how much text all substitutions together may make
};

}  // namespace burin::preset
