#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/preset/substitute.hpp>

namespace burin::preset {

namespace {

using params::Value;

bool continues_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// "$name", "${name}" or "$$" at a dollar sign.
struct Reference {
  std::string_view name;   ///< empty for "$$" and for a dollar that refers to nothing
  std::size_t length = 1;  ///< of the reference in the text
};

Reference reference_at(std::string_view text) {
  if (text.substr(0, 2) == "$$") return {{}, 2};
  if (text.substr(0, 2) == "${") {
    const std::size_t end = text.find('}');
    if (end == std::string_view::npos) return {};
    return {text.substr(2, end - 2), end + 1};
  }
  std::size_t end = 1;
  while (end < text.size() && continues_name(text[end])) ++end;
  return {text.substr(1, end - 1), end};
}

Value seed_value(std::uint64_t seed, const Where& where) {
  if (seed <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return {where, static_cast<std::int64_t>(seed)};
  }
  return {where, static_cast<double>(seed)};
}

/// As part of a text: a negative number must stay one operand.
std::string operand_text(const Value& value) {
  std::string text = scalar_text(value);
  const bool number = !std::holds_alternative<bool>(value.data) && value.text() == nullptr;
  return number && text.front() == '-' ? '(' + text + ')' : text;
}

}  // namespace

void Substitution::apply(Value& value) {
  if (auto* array = std::get_if<params::Array>(&value.data)) {
    for (Value& item : *array) apply(item);
  } else if (auto* table = std::get_if<params::Table>(&value.data)) {
    for (params::Entry& entry : table->entries) apply(entry.value);
  } else if (value.text() != nullptr) {
    apply_text(value);
  }
}

/// What the name stands for in a text; nothing after reporting an unknown one, and silently for a knob that is wrong.
std::optional<std::string> Substitution::text_of(std::string_view name, const Where& where) {
  if (name == "seed") {
    seed_was_used_ = true;
    return std::to_string(seed_);
  }
  const auto knob = std::find_if(knobs_.begin(), knobs_.end(), [&](const Knob& k) { return k.name == name; });
  if (knob != knobs_.end()) {
    seed_was_used_ = seed_was_used_ || knob->drawn;
    return knob->value ? std::optional(operand_text(*knob->value)) : std::nullopt;
  }
  std::vector<std::string_view> names{"seed"};
  for (const Knob& each : knobs_) names.push_back(each.name);
  findings_.report_and_hush(where, 1, fmt::format("no knob '{}'{}", name, suggestion(name, names)));
  return std::nullopt;
}

void Substitution::apply_text(Value& value) {
  const std::string source = *value.text();
  if (source.find('$') == std::string::npos) return;
  const auto give_up = [&] { findings_.hush(value.where, source.size() + 1); };
  std::string text;
  for (std::size_t at = 0; at < source.size();) {
    if (source[at] != '$') {
      text += source[at++];
      continue;
    }
    const Reference reference = reference_at(std::string_view(source).substr(at));
    if (reference.name.empty() && reference.length != 2) {
      findings_.report_and_hush(value.where, source.size() + 1,
                                fmt::format("a '$' without the name of a knob in '{}'; write $$ for a dollar", source));
      return;
    }
    const std::optional<std::string> put =
        reference.name.empty() ? std::optional<std::string>("$") : text_of(reference.name, value.where);
    if (!put) return give_up();
    const bool alone = reference.length == source.size();
    if (alone && reference.name == "seed") {
      value = seed_value(seed_, value.where);
      return;
    }
    if (alone && !reference.name.empty()) {
      const auto knob =
          std::find_if(knobs_.begin(), knobs_.end(), [&](const Knob& k) { return k.name == reference.name; });
      value.data = knob->value->data;
    }
    if (put->size() > bytes_left_) {
      findings_.report_and_hush(value.where, source.size() + 1, "the knobs put in make too long a text");
      return;
    }
    bytes_left_ -= put->size();
    if (alone && !reference.name.empty()) return;
    text += *put;
    at += reference.length;
  }
  value.data = std::move(text);
}

}  // namespace burin::preset
