#include <cmath>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/params/fields.hpp>

namespace burin::params {

namespace {

std::string bound_text(double bound) {
  if (std::isinf(bound)) return bound < 0.0 ? "-inf" : "inf";
  return shortest_text(bound);
}

}  // namespace

std::string range_text(const Range& range) {
  if (std::isinf(range.low) && std::isinf(range.high)) return {};
  const bool open_low = range.open_low || std::isinf(range.low);
  const bool open_high = range.open_high || std::isinf(range.high);
  return fmt::format("{}{}, {}{}", open_low ? '(' : '[', bound_text(range.low), bound_text(range.high),
                     open_high ? ')' : ']');
}

namespace detail {

void report_out_of_range(const Where& where, std::string_view name, double number, const Range& range, bool length,
                         ReadContext& context) {
  context.report(where, fmt::format("'{}' = {}{} is outside {}{}", name, shortest_text(number), length ? " mm" : "",
                                    range_text(range), length ? " mm" : ""));
}

void report_unknown_key(const Entry& entry, std::string_view what, const std::vector<std::string_view>& known,
                        ReadContext& context) {
  context.report(entry.where, fmt::format("unknown key '{}' in {}{}", entry.key, what, suggestion(entry.key, known)));
}

}  // namespace detail

}  // namespace burin::params
