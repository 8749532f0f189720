#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/random.hpp>
#include <burin/base/suggest.hpp>
#include <burin/preset/knobs.hpp>

namespace burin::preset {

namespace {

using params::Range;
using params::ReadContext;
using params::Table;
using params::Value;
using params::ValueType;

/// Key of the draws of random knobs among all uses of a seed: "knob".
constexpr std::uint64_t knob_purpose = 0x6B6E6F62;

/// FNV-1a of 64 bits.
constexpr std::uint64_t name_hash(std::string_view name) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  }
  return hash;
}

bool is_ordered(KnobKind kind) {
  return kind == KnobKind::integer || kind == KnobKind::number || kind == KnobKind::length;
}

std::string_view kind_text(KnobKind kind) {
  switch (kind) {
    case KnobKind::integer:
      return "whole number";
    case KnobKind::number:
      return "number";
    case KnobKind::length:
      return "length";
    case KnobKind::color:
      return "color";
    case KnobKind::text:
      return "text";
    case KnobKind::flag:
      return "true or false";
  }
  return {};
}

/// Reads T and gives back what stands for it in the tree.
template <class T>
std::optional<Value> checked(const Value& value, ReadContext& context) {
  T read{};
  if (!ValueType<T>::read(value, read, context)) return std::nullopt;
  if constexpr (std::is_same_v<T, params::Length> || std::is_same_v<T, Colour>) {
    return value;
  } else {
    return Value{value.where, std::move(read)};
  }
}

/// The value as one of this kind; nothing after reporting.
std::optional<Value> as_kind(const Value& value, KnobKind kind, ReadContext& context) {
  switch (kind) {
    case KnobKind::integer:
      return checked<std::int64_t>(value, context);
    case KnobKind::number:
      return checked<double>(value, context);
    case KnobKind::length:
      return checked<params::Length>(value, context);
    case KnobKind::color:
      return checked<Colour>(value, context);
    case KnobKind::text:
      return checked<std::string>(value, context);
    case KnobKind::flag:
      return checked<bool>(value, context);
  }
  return std::nullopt;
}

/// What a range is held against: the number itself, millimetres of a length. Pre: of an ordered kind, and read before.
double measure_of(const Value& value, KnobKind kind, ReadContext& context) {
  if (kind == KnobKind::length) {
    params::Length length;
    ValueType<params::Length>::read(value, length, context);
    return length.mm;
  }
  double number = 0.0;
  params::read_number(value, number, context);
  return number;
}

bool names_knob(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto follows = [&](char c) { return letter(c) || (c >= '0' && c <= '9'); };
  return !name.empty() && letter(name.front()) && std::all_of(name.begin(), name.end(), follows);
}

/// Reads one knob; reports with the knob's name.
class KnobReader {
 public:
  KnobReader(Knob& knob, const Where& where, ReadContext& context) : knob_(knob), where_(where), context_(context) {}

  void read(const Table& table, std::uint64_t seed) {
    const std::size_t before = context_.problems.size();
    if (!params::read_fields(table, knob_.spec, "knob '" + knob_.name + "'", context_)) return;
    infer_kind();
    check_combination(table);
    if (context_.problems.size() != before) return;
    read_range();
    read_choices();
    if (context_.problems.size() != before) return;
    usable_ = true;
    if (knob_.spec.random) {
      draw(table, seed);
    } else {
      set(*knob_.spec.preset_value);
    }
  }

  /// A value from outside, as text.
  void turn(const std::string& text, const Where& where) {
    if (!usable_) return;  // the declaration is wrong, which has been said
    Value value{where, text};
    if (knob_.kind == KnobKind::flag && (text == "true" || text == "false")) value.data = text == "true";
    set(value);
  }

 private:
  void report(const Where& where, std::string message) { context_.report(where, std::move(message)); }

  void infer_kind() {
    const KnobSpec& spec = knob_.spec;
    if (spec.kind) {
      knob_.kind = *spec.kind;
      return;
    }
    if (spec.random) {
      knob_.kind = KnobKind::number;
      return;
    }
    const auto real = [](const Value& value) { return std::holds_alternative<double>(value.data); };
    if (!spec.preset_value) return;
    const Value& value = *spec.preset_value;
    if (std::holds_alternative<bool>(value.data)) {
      knob_.kind = KnobKind::flag;
    } else if (std::holds_alternative<std::int64_t>(value.data)) {
      // { default = 1, max = 2.5 } is meant as a number, not as a whole one.
      const bool fraction = (spec.min && real(*spec.min)) || (spec.max && real(*spec.max)) ||
                            std::any_of(spec.choices.begin(), spec.choices.end(), real);
      knob_.kind = fraction ? KnobKind::number : KnobKind::integer;
    } else if (real(value)) {
      knob_.kind = KnobKind::number;
    } else {
      knob_.kind = KnobKind::text;
    }
  }

  void check_combination(const Table& table) {
    const KnobSpec& spec = knob_.spec;
    if (!names_knob(knob_.name)) {
      report(where_, fmt::format("'{}' cannot name a knob; use letters, digits and _", knob_.name));
    } else if (knob_.name == "seed") {
      report(where_, "a knob cannot be called 'seed': $seed is the seed of the preset");
    }
    if (!spec.preset_value && !spec.random) {
      report(where_, fmt::format("knob '{}' needs a 'default' or 'random = [low, high]'", knob_.name));
    }
    if (spec.preset_value && spec.random) {
      report(where_, fmt::format("knob '{}' has both 'default' and 'random'; keep one", knob_.name));
    }
    if (spec.random && !spec.choices.empty()) {
      report(where_, fmt::format("knob '{}' has both 'choices' and 'random'; keep one", knob_.name));
    }
    if (spec.random && knob_.kind != KnobKind::number && knob_.kind != KnobKind::integer) {
      report(where_, fmt::format("knob '{}' draws numbers, so its kind is number or integer", knob_.name));
    }
    if (const Value* choices = table.find("choices"); choices != nullptr && spec.choices.empty()) {
      report(choices->where, fmt::format("knob '{}' has no choices to choose from", knob_.name));
    }
    for (const char* key : {"min", "max"}) {
      const Value* bound = table.find(key);
      if (bound == nullptr || is_ordered(knob_.kind)) continue;
      report(bound->where,
             fmt::format("'{}' is for numbers and lengths; knob '{}' is a {}", key, knob_.name, kind_text(knob_.kind)));
    }
  }

  void read_bound(std::optional<Value>& bound, double& target) {
    if (!bound) return;
    bound = named(*bound);
    if (bound) target = measure_of(*bound, knob_.kind, context_);
  }

  void read_range() {
    read_bound(knob_.spec.min, range_.low);
    read_bound(knob_.spec.max, range_.high);
    if (range_.low > range_.high) {
      report(where_, fmt::format("knob '{}': min {} lies above max {}", knob_.name, shortest_text(range_.low),
                                 shortest_text(range_.high)));
    }
  }

  void read_choices() {
    for (Value& choice : knob_.spec.choices) {
      if (std::optional<Value> read = named(choice)) choice = *std::move(read);
    }
  }

  /// as_kind with the knob's name in what it reports.
  std::optional<Value> named(const Value& value) {
    const std::size_t before = context_.problems.size();
    std::optional<Value> read = as_kind(value, knob_.kind, context_);
    for (std::size_t i = before; i < context_.problems.size(); ++i) {
      context_.problems[i].message = fmt::format("'{}': {}", knob_.name, context_.problems[i].message);
    }
    return read;
  }

  bool in_range(const Value& value) {
    if (!is_ordered(knob_.kind)) return true;
    const double number = measure_of(value, knob_.kind, context_);
    if (range_.contains(number)) return true;
    params::detail::report_out_of_range(value.where, knob_.name, number, range_, knob_.kind == KnobKind::length,
                                        context_);
    return false;
  }

  bool is_choice(const Value& value) {
    const std::vector<Value>& choices = knob_.spec.choices;
    if (choices.empty()) return true;
    const std::string text = scalar_text(value);
    std::vector<std::string> texts;
    for (const Value& choice : choices) texts.push_back(scalar_text(choice));
    if (std::find(texts.begin(), texts.end(), text) != texts.end()) return true;
    report(value.where, fmt::format("'{}' = {} is none of its choices{}", knob_.name, text,
                                    suggestion(text, std::vector<std::string_view>(texts.begin(), texts.end()))));
    return false;
  }

  void set(const Value& value) {
    std::optional<Value> read = named(value);
    if (!read || !in_range(*read) || !is_choice(*read)) return;
    knob_.value = std::move(read);
    knob_.drawn = false;
  }

  void draw(const Table& table, std::uint64_t seed) {
    const auto [low, high] = *knob_.spec.random;
    const Where& where = table.find("random")->where;
    const bool whole = knob_.kind == KnobKind::integer;
    if (low > high) {
      report(where, fmt::format("knob '{}': the low end {} lies above the high end {}", knob_.name, shortest_text(low),
                                shortest_text(high)));
      return;
    }
    if (whole && (low != std::floor(low) || high != std::floor(high) || std::max(-low, high) > 0x1p52)) {
      report(where, fmt::format("knob '{}' draws whole numbers, so both ends must be whole numbers", knob_.name));
      return;
    }
    const double u = uniform(seed, knob_purpose, name_hash(knob_.name));
    Value drawn{where, 0.0};
    if (whole) {
      drawn.data = static_cast<std::int64_t>(low + std::floor(u * (high - low + 1.0)));
    } else {
      drawn.data = low == high ? low : std::min(low + u * (high - low), std::nextafter(high, low));
    }
    if (!in_range({where, low}) || !in_range({where, high})) return;
    knob_.value = std::move(drawn);
    knob_.drawn = true;
  }

  Knob& knob_;
  Where where_;
  ReadContext& context_;
  Range range_;
  bool usable_ = false;
};

void report_unknown(const std::string& name, const Where& where, const std::vector<Knob>& knobs, ReadContext& context) {
  std::vector<std::string_view> names;
  for (const Knob& knob : knobs) names.push_back(knob.name);
  context.report(where, names.empty() ? fmt::format("no knob '{}': this preset has no knobs", name)
                                      : fmt::format("no knob '{}'{}", name, suggestion(name, names)));
}

}  // namespace

std::string scalar_text(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value.data)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value.data)) return shortest_text(*real);
  const std::string* text = value.text();
  return text == nullptr ? std::string{} : *text;
}

KnobInfo Knob::info() const {
  KnobInfo info{name, std::string(kind_text(kind)), {}, {}, spec.doc};
  if (spec.random) {
    info.kind = "random";
    const bool whole = kind == KnobKind::integer;
    info.range =
        fmt::format("[{}, {}{}", shortest_text((*spec.random)[0]), shortest_text((*spec.random)[1]), whole ? ']' : ')');
    info.default_text = "drawn from the seed";
    return info;
  }
  if (spec.preset_value) info.default_text = scalar_text(*spec.preset_value);
  for (const Value& choice : spec.choices) {
    info.range += (info.range.empty() ? "" : " | ") + scalar_text(choice);
  }
  if (info.range.empty() && (spec.min || spec.max)) {
    info.range = fmt::format("{}, {}", spec.min ? '[' + scalar_text(*spec.min) : "(-inf",
                             spec.max ? scalar_text(*spec.max) + ']' : "inf)");
  }
  return info;
}

std::vector<Knob> read_knobs(const Table& root, std::uint64_t seed, const Overrides& overrides, ReadContext& context) {
  std::vector<Knob> knobs;
  std::vector<KnobReader> readers;
  const Value* section = root.find("knobs");
  const Table* table = section == nullptr ? nullptr : section->table();
  if (section != nullptr && table == nullptr) params::report_kind(*section, "the table [knobs]", context);
  if (table != nullptr) {
    knobs.resize(table->entries.size());
    for (std::size_t i = 0; i < knobs.size(); ++i) {
      const params::Entry& entry = table->entries[i];
      knobs[i].name = entry.key;
      readers.emplace_back(knobs[i], entry.where, context);
      if (const Table* spec = entry.value.table()) {
        readers.back().read(*spec, seed);
      } else {
        context.report(entry.value.where, fmt::format("knob '{}' is written {{ default = {} }}", entry.key,
                                                      entry.value.text() != nullptr ? '"' + *entry.value.text() + '"'
                                                                                    : scalar_text(entry.value)));
      }
    }
  }
  for (const auto& option : overrides.knobs) {
    const std::string& name = option.first;
    const Where where{fmt::format("-D {}={}", name, option.second)};
    const auto knob = std::find_if(knobs.begin(), knobs.end(), [&](const Knob& k) { return k.name == name; });
    if (knob == knobs.end()) {
      report_unknown(name, where, knobs, context);
    } else {
      readers[static_cast<std::size_t>(knob - knobs.begin())].turn(option.second, where);
    }
  }
  return knobs;
}

}  // namespace burin::preset
