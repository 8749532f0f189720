#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <burin/curves/base_shape.hpp>
#include <burin/curves/two_point/motif.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/curves/two_point/vertices.hpp>
#include <burin/params/fields.hpp>

namespace burin::curves::two_point {

namespace {

template <class Predicate>
bool any_amount(const Motif& motif, Predicate predicate) {
  for (const Stage& stage : motif.by_level) {
    for (const std::vector<Mark>& marks : stage.by_edge) {
      for (const Mark& mark : marks) {
        if (predicate(mark.alpha) || predicate(mark.beta)) return true;
      }
    }
  }
  return false;
}

}  // namespace

bool Motif::is_constant() const {
  return !any_amount(*this, [](const Amount& amount) { return !amount.is_constant(); });
}

bool Motif::is_random() const {
  return any_amount(*this, [](const Amount& amount) { return amount.is_random(); });
}

namespace {

enum class BetaUnit : std::uint8_t { relative, absolute };
constexpr auto words(BetaUnit) {
  return std::array<params::Word<BetaUnit>, 2>{{{"relative", BetaUnit::relative}, {"absolute", BetaUnit::absolute}}};
}

/// Flags of the sub-edges: a list of 0 and 1, or the letters of a turtle word that set the flag.
struct Flags {
  std::vector<int> list;
  std::string letters;
};

constexpr double right_angle = 90.0;

/// The keys of a motif written as a table.
struct MotifSpec {
  std::string name;
  std::vector<Mark> marks;
  std::vector<Vec2> points;
  std::string turtle;
  std::optional<double> angle;
  std::vector<std::vector<Mark>> by_edge;
  std::vector<Motif> by_level;
  std::optional<SignRule> sign;
  Flags flip;
  Flags reverse;
  BetaUnit beta = BetaUnit::relative;
  double decay = 1.0;
  std::optional<Vec2> join;

  static constexpr auto fields() {
    using params::field;
    return std::tuple{
        field("name", &MotifSpec::name, "a named motif, to be changed by the keys beside it"),
        field("marks", &MotifSpec::marks, "[[alpha, beta], ...]: along the edge, to the right of it"),
        field("points", &MotifSpec::points, "[[x, y], ...]: its vertices from first to last, y up"),
        field("turtle", &MotifSpec::turtle, "letters draw, + turns left, - right by `angle`, | turns back"),
        field("angle", &MotifSpec::angle, {-360.0, 360.0},
              "turn of + and - in degrees; unset: 90, or the named motif's own"),
        field("by_edge", &MotifSpec::by_edge, "lists of marks for the edges in turn"),
        field("by_level", &MotifSpec::by_level, "motifs for the levels in turn"),
        field("sign", &MotifSpec::sign, "sign of beta over the whole sequence"),
        field("flip", &MotifSpec::flip, "sub-edges to mirror: [0, 1, ...] or letters of `turtle`"),
        field("reverse", &MotifSpec::reverse, "sub-edges to build from their far end: [0, 1, ...] or letters"),
        field("beta", &MotifSpec::beta, "relative: in edge lengths; absolute: in model units"),
        field("decay", &MotifSpec::decay, {0.0, 10.0, true, false}, "factor on beta from each level to the next"),
        field("join", &MotifSpec::join,
              "[alpha, beta]: draws a line through this point of every edge instead of the vertices")};
  }
};

}  // namespace

}  // namespace burin::curves::two_point

namespace burin::params {

namespace two_point = curves::two_point;

template <>
struct ValueType<two_point::Mark> {
  static std::string name() { return "mark"; }
  static bool read(const Value& value, two_point::Mark& mark, ReadContext& context) {
    const Array* array = value.array();
    if (array == nullptr || array->size() != 2) return report_kind(value, "a mark [alpha, beta]", context);
    const bool alpha = ValueType<two_point::Amount>::read((*array)[0], mark.alpha, context);
    return ValueType<two_point::Amount>::read((*array)[1], mark.beta, context) && alpha;
  }
  static std::string text(const two_point::Mark&) { return {}; }
};

template <>
struct ValueType<two_point::Flags> {
  static std::string name() { return "list of 0 and 1, or letters"; }
  static bool read(const Value& value, two_point::Flags& flags, ReadContext& context) {
    flags = {};
    if (const std::string* letters = value.text()) {
      flags.letters = *letters;
      return true;
    }
    if (!ValueType<std::vector<int>>::read(value, flags.list, context)) return false;
    const bool bits = std::all_of(flags.list.begin(), flags.list.end(), [](int f) { return f == 0 || f == 1; });
    if (!bits) context.report(value.where, "flags are 0 or 1, one for each sub-edge");
    return bits;
  }
  static std::string text(const two_point::Flags&) { return "[]"; }
};

}  // namespace burin::params

namespace burin::curves::two_point {

static_assert(params::ParamStruct<MotifSpec>);

std::vector<params::FieldInfo> motif_fields() {
  return params::field_infos<MotifSpec>();
}

namespace {

bool report_unknown_motif(const std::string& name, const Where& where, params::ReadContext& context) {
  std::vector<std::string_view> known;
  for (const NamedMotif& row : named_motifs()) known.push_back(row.name);
  context.report(where, fmt::format("no motif '{}'{}; 'burin list motifs' names them", name, suggestion(name, known)));
  return false;
}

std::optional<TurtlePath> read_turtle(const std::string& word, double angle_degrees, const Where& where,
                                      params::ReadContext& context) {
  constexpr std::size_t longest_word = 4096;
  if (word.size() > longest_word) {
    context.report(where, fmt::format("a turtle word has at most {} characters", longest_word));
    return std::nullopt;
  }
  const auto strange = std::find_if_not(word.begin(), word.end(), &is_turtle_step);
  if (strange != word.end()) {
    context.report(where, fmt::format("a turtle word is made of letters, +, - and |; found '{}'", *strange));
    return std::nullopt;
  }
  return walk_turtle(word, angle_degrees);
}

/// The motif that the table names, with its angle, and what the table says in place of the row's flags and sign.
bool read_named(const MotifSpec& spec, const Where& where, Motif& motif, std::string& letters,
                params::ReadContext& context) {
  const NamedMotif* row = find_motif(spec.name);
  if (row == nullptr) return report_unknown_motif(spec.name, where, context);
  if (spec.angle && row->turtle.empty()) {
    context.report(where, fmt::format("the motif '{}' is made of points and has no 'angle'", row->name));
    return false;
  }
  const double angle = spec.angle.value_or(row->angle_degrees);
  if (!row->turtle.empty()) {
    const TurtlePath path = walk_turtle(row->turtle, angle);
    if (path.vertices.front() == path.vertices.back()) {
      context.report(where, fmt::format("with this angle '{}' ends where it begins", row->name));
      return false;
    }
    letters = path.letters;
  }
  motif = motif_from(*row, angle);
  if (spec.sign) {
    motif.flip.clear();
    motif.reverse.clear();
  }
  return true;
}

/// Reads the one source of marks that the table has into `motif.by_level`; the letters of a turtle word into `letters`.
bool read_marks(const MotifSpec& spec, const Where& where, Motif& motif, std::string& letters,
                params::ReadContext& context) {
  const int sources = int{!spec.name.empty()} + int{!spec.marks.empty()} + int{!spec.points.empty()} +
                      int{!spec.turtle.empty()} + int{!spec.by_edge.empty()} + int{!spec.by_level.empty()};
  if (sources != 1) {
    context.report(where, "a motif needs exactly one of 'name', 'marks', 'points', 'turtle', 'by_edge' and 'by_level'");
    return false;
  }
  if (spec.angle && spec.name.empty() && spec.turtle.empty()) {
    context.report(where, "'angle' belongs to a 'turtle' word or a 'name'");
    return false;
  }
  if (!spec.name.empty()) return read_named(spec, where, motif, letters, context);
  if (!spec.by_level.empty()) {
    for (const Motif& level : spec.by_level) {
      if (level.by_level.size() != 1 || level.has_flags() || level.sign || level.absolute || level.decay != 1.0 ||
          level.join) {
        context.report(where,
                       "the motifs of 'by_level' are marks alone; put sign, beta, decay and join beside 'by_level' "
                       "(flags cannot change by level: use a sign rule)");
        return false;
      }
      motif.by_level.push_back(level.by_level.front());
    }
    return true;
  }
  std::vector<Vec2> vertices = spec.points;
  if (!spec.turtle.empty()) {
    std::optional<TurtlePath> path = read_turtle(spec.turtle, spec.angle.value_or(right_angle), where, context);
    if (!path) return false;
    vertices = std::move(path->vertices);
    letters = std::move(path->letters);
  }
  if (!vertices.empty()) {
    const std::optional<std::vector<Mark>> marks = marks_from_vertices(vertices);
    if (!marks) {
      context.report(where, "a motif must end somewhere else than it begins");
      return false;
    }
    motif.by_level = {Stage{{*marks}}};
  } else {
    motif.by_level = {Stage{spec.marks.empty() ? spec.by_edge : std::vector<std::vector<Mark>>{spec.marks}}};
  }
  for (const std::vector<Mark>& marks : motif.by_level.front().by_edge) {
    if (marks.size() != motif.by_level.front().mark_count() || marks.empty()) {
      context.report(where, marks.empty() ? "a motif needs at least one mark between its ends"
                                          : "the lists of 'by_edge' must be equally long");
      return false;
    }
  }
  return true;
}

bool read_flags(std::string_view name, const Flags& flags, const std::string& letters, const Motif& motif,
                const Where& where, std::vector<std::uint8_t>& target, params::ReadContext& context) {
  if (flags.list.empty() && flags.letters.empty()) return true;
  if (!flags.letters.empty() && letters.empty()) {
    context.report(where, fmt::format("'{}' by letters needs a 'turtle' word; use a list of 0 and 1", name));
    return false;
  }
  if (!flags.letters.empty()) {
    target = flags_of(letters, flags.letters);
    return true;
  }
  const std::size_t children = motif.by_level.front().child_count();
  if (motif.by_level.size() != 1 || flags.list.size() != children) {
    context.report(where, fmt::format("'{}' needs one flag for each of the {} sub-edges, found {}", name, children,
                                      flags.list.size()));
    return false;
  }
  target.clear();
  for (const int flag : flags.list) target.push_back(static_cast<std::uint8_t>(flag));
  return true;
}

bool read_table(const params::Table& table, const Where& where, Motif& motif, params::ReadContext& context) {
  MotifSpec spec;
  if (!params::read_fields(table, spec, "motif", context)) return false;
  Motif read;
  std::string letters;
  if (!read_marks(spec, where, read, letters, context)) return false;
  if (!read_flags("flip", spec.flip, letters, read, where, read.flip, context)) return false;
  if (!read_flags("reverse", spec.reverse, letters, read, where, read.reverse, context)) return false;
  if (spec.sign) read.sign = spec.sign;
  read.absolute = spec.beta == BetaUnit::absolute;
  read.decay = spec.decay;
  if (spec.join) read.join = spec.join;
  if (read.has_flags() && (read.sign || read.absolute || read.decay != 1.0 || !read.is_constant() ||
                           read.by_level.front().by_edge.size() > 1)) {
    context.report(where,
                   "'flip' and 'reverse' need plain marks that are the same on every edge and level; "
                   "use 'sign' with random, absolute or decaying ones");
    return false;
  }
  motif = std::move(read);
  return true;
}

}  // namespace

}  // namespace burin::curves::two_point

namespace burin::params {

bool ValueType<two_point::Motif>::read(const Value& value, two_point::Motif& motif, ReadContext& context) {
  if (const Table* table = value.table()) return two_point::read_table(*table, value.where, motif, context);
  const std::string* word = value.text();
  if (word == nullptr) return report_kind(value, "the name of a motif or a table", context);
  if (const Value* defined = context.defined(*word); defined != nullptr && defined->table() != nullptr) {
    return two_point::read_table(*defined->table(), defined->where, motif, context);
  }
  const two_point::NamedMotif* row = two_point::find_motif(*word);
  if (row == nullptr) return two_point::report_unknown_motif(*word, value.where, context);
  motif = two_point::motif_from(*row);
  return true;
}

}  // namespace burin::params
