#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <burin/base/check.hpp>
#include <burin/params/read_value.hpp>

/// Field tables: one declaration per parameter. A parameter struct gives each member a default by its initialiser and
/// one row in `fields()`; the reader, help, docs and schema all derive from the rows:
///
///   struct Params {
///     int levels = 5;
///     static constexpr auto fields() {
///       return std::tuple{field("levels", &Params::levels, {0, 1000}, "refinement levels")};
///     }
///   };
///   static_assert(params::ParamStruct<Params>);   // fires when a member has no row
namespace burin::params {

/// Which numbers a field accepts. Open ends exclude their bound.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open_low = false;
  bool open_high = false;

  constexpr bool contains(double x) const {
    return (open_low ? x > low : x >= low) && (open_high ? x < high : x <= high);
  }
};

/// "[0, 1000]", "(0, inf)"; empty when everything is accepted.
std::string range_text(const Range& range);

inline constexpr Range any_number{};
inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range not_negative{0.0, std::numeric_limits<double>::infinity(), false, false};

template <class S, class T>
struct Field {
  std::string_view name;
  T S::*member;
  Range range;
  std::string_view doc;
};

template <class S, class T>
constexpr Field<S, T> field(std::string_view name, T S::*member, std::string_view doc) {
  return {name, member, any_number, doc};
}

template <class S, class T>
constexpr Field<S, T> field(std::string_view name, T S::*member, Range range, std::string_view doc) {
  return {name, member, range, doc};
}

/// A row of a field table with its types forgotten: for help, docs and schema.
struct FieldInfo {
  std::string_view name;
  std::string type;
  std::string range;
  std::string default_text;
  std::string_view doc;
};

namespace detail {

/// Turns into anything: counts the members of an aggregate. Never called; defined only since clang 14 wants a
/// definition for types of an unnamed namespace.
struct AnyMember {
  template <class T>
  operator T&() const& noexcept {  // NOLINT(google-explicit-constructor)
    contract_broken("AnyMember is for counting");
  }
  template <class T>
  operator T&&() const&& noexcept {  // NOLINT(google-explicit-constructor)
    contract_broken("AnyMember is for counting");
  }
};

template <class S, std::size_t... I>
constexpr bool takes_members(std::index_sequence<I...>) {
  return requires {
    S{(void(I), AnyMember{})...};
  };
}

template <class S, std::size_t N = 0>
constexpr std::size_t member_count() {
  if constexpr (takes_members<S>(std::make_index_sequence<N + 1>{})) {
    return member_count<S, N + 1>();
  } else {
    return N;
  }
}

/// The number in a value that a range can be held against, if it has one.
template <class T>
std::optional<double> ranged_number(const T& value) {
  if constexpr (std::is_same_v<T, Length>) {
    return value.mm;
  } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    return static_cast<double>(value);
  } else {
    return std::nullopt;
  }
}
template <class T>
std::optional<double> ranged_number(const std::optional<T>& value) {
  return value ? ranged_number(*value) : std::nullopt;
}

void report_out_of_range(const Where& where, std::string_view name, double number, const Range& range, bool length,
                         ReadContext& context);
void report_unknown_key(const Entry& entry, std::string_view what, const std::vector<std::string_view>& known,
                        ReadContext& context);

}  // namespace detail

/// An aggregate all of whose members have a row in fields().
template <class S>
concept ParamStruct = requires {
  S::fields();
}
&&std::is_aggregate_v<S>&& std::tuple_size_v<decltype(S::fields())> == detail::member_count<S>();

template <ParamStruct S>
std::vector<FieldInfo> field_infos() {
  const S defaults{};
  return std::apply(
      [&](const auto&... rows) {
        return std::vector<FieldInfo>{
            FieldInfo{rows.name, ValueType<std::remove_cvref_t<decltype(defaults.*(rows.member))>>::name(),
                      range_text(rows.range),
                      ValueType<std::remove_cvref_t<decltype(defaults.*(rows.member))>>::text(defaults.*(rows.member)),
                      rows.doc}...};
      },
      S::fields());
}

template <ParamStruct S>
std::vector<std::string_view> field_names() {
  return std::apply([](const auto&... rows) { return std::vector<std::string_view>{rows.name...}; }, S::fields());
}

/// Reads one value into one field; checks its range. False after reporting.
template <class S, class T>
bool read_field(const Field<S, T>& row, const Value& value, S& target, ReadContext& context) {
  T read = target.*(row.member);
  const std::size_t problems_before = context.problems.size();
  if (!ValueType<T>::read(value, read, context)) {
    if (context.problems.size() == problems_before + 1) {
      context.problems.back().message = "'" + std::string(row.name) + "': " + context.problems.back().message;
    }
    return false;
  }
  if (const std::optional<double> number = detail::ranged_number(read); number && !row.range.contains(*number)) {
    constexpr bool length = std::is_same_v<T, Length> || std::is_same_v<T, std::optional<Length>>;
    detail::report_out_of_range(value.where, row.name, *number, row.range, length, context);
    return false;
  }
  target.*(row.member) = std::move(read);
  return true;
}

/// Reads a table into a parameter struct: every key must be a row (or be listed in `also_known`, for keys that somebody
/// else reads from the same table). Reports all problems; true when there was none. `what` names the table in messages:
/// "curve 'two-point'".
template <ParamStruct S>
bool read_fields(const Table& table, S& target, std::string_view what, ReadContext& context,
                 const std::vector<std::string_view>& also_known = {}) {
  const std::size_t problems_before = context.problems.size();
  std::vector<std::string_view> known = field_names<S>();
  known.insert(known.end(), also_known.begin(), also_known.end());
  for (const Entry& entry : table.entries) {
    const bool is_row = std::apply(
        [&](const auto&... rows) {
          return ((rows.name == entry.key ? (read_field(rows, entry.value, target, context), true) : false) || ...);
        },
        S::fields());
    if (!is_row && std::find(also_known.begin(), also_known.end(), entry.key) == also_known.end()) {
      detail::report_unknown_key(entry, what, known, context);
    }
  }
  return context.problems.size() == problems_before;
}

}  // namespace burin::params
