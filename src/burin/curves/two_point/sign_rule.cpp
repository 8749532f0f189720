#include <array>

#include <burin/base/random.hpp>
#include <burin/curves/two_point/sign_rule.hpp>

namespace burin::curves::two_point {

constexpr auto words(SignRule::Kind) {
  using Kind = SignRule::Kind;
  return std::array<params::Word<Kind>, 5>{{{"constant", Kind::constant},
                                            {"edge", Kind::edge},
                                            {"level", Kind::level},
                                            {"level-edge", Kind::level_edge},
                                            {"random", Kind::random}}};
}

double SignRule::operator()(std::uint64_t seed, int level, std::uint64_t edge) const {
  switch (kind) {
    case Kind::constant:
      return 1.0;
    case Kind::edge:
      return edge % 2 == 0 ? 1.0 : -1.0;
    case Kind::level:
      return level % 2 == 1 ? 1.0 : -1.0;
    case Kind::level_edge:
      return (static_cast<std::uint64_t>(level) + edge) % 2 == 1 ? 1.0 : -1.0;
    case Kind::random:
      return (random_bits(seed, level, edge + 1) >> 63U) != 0 ? -1.0 : 1.0;
    case Kind::list:
      return list[edge % list.size()];
  }
  return 1.0;
}

std::size_t SignRule::edge_period() const {
  if (kind == Kind::list) return list.size();
  return kind == Kind::edge || kind == Kind::level_edge ? 2 : 1;
}

std::size_t SignRule::level_period() const {
  return kind == Kind::level || kind == Kind::level_edge ? 2 : 1;
}

}  // namespace burin::curves::two_point

namespace burin::params {

using curves::two_point::SignRule;

bool ValueType<SignRule>::read(const Value& value, SignRule& rule, ReadContext& context) {
  rule = {};
  if (value.text() != nullptr) return ValueType<SignRule::Kind>::read(value, rule.kind, context);
  if (value.array() == nullptr) return report_kind(value, name(), context);
  rule.kind = SignRule::Kind::list;
  if (!ValueType<std::vector<int>>::read(value, rule.list, context)) return false;
  bool signs = !rule.list.empty();
  for (const int sign : rule.list) signs = signs && (sign == 1 || sign == -1);
  if (!signs) context.report(value.where, "a list of signs holds at least one number, each 1 or -1");
  return signs;
}

std::string ValueType<SignRule>::text(const SignRule& rule) {
  return rule.kind == SignRule::Kind::list ? ValueType<std::vector<int>>::text(rule.list)
                                           : ValueType<SignRule::Kind>::text(rule.kind);
}

}  // namespace burin::params
