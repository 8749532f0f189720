#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <burin/data/flatten.hpp>
#include <burin/data/svg_path.hpp>

namespace burin::data {
namespace {

constexpr std::size_t max_commands = 65'536;
constexpr std::size_t max_points = std::size_t{1} << 20U;
constexpr double max_number = 1e12;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_relative(char command) {
  return command >= 'a';
}
char upper(char command) {
  return is_relative(command) ? static_cast<char>(command - 'a' + 'A') : command;
}

/// What stopped the reading; unwinds by the return values of the readers below.
struct Fault {
  std::size_t offset = 0;
  std::string message;
  Trouble trouble = Trouble::input;
};

/// Words of path data one after another.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  std::size_t offset() const { return at_; }
  bool at_end() const { return at_ == text_.size(); }
  char next() const { return at_end() ? '\0' : text_[at_]; }
  void advance() { ++at_; }
  void skip_blanks() {
    while (!at_end() && is_blank(next())) ++at_;
  }
  /// Blanks with at most one comma among them; whether there was one.
  bool skip_comma() {
    skip_blanks();
    if (next() != ',') return false;
    ++at_;
    skip_blanks();
    return true;
  }
  bool number_follows() const { return is_digit(next()) || next() == '.' || next() == '+' || next() == '-'; }

  /// The number that stands here; nothing, and no step forward, when there is none or a too large one.
  std::optional<double> number() {
    std::size_t first = at_;
    if (next() == '+') ++first;
    const std::size_t digits = first + (first < text_.size() && text_[first] == '-' && first == at_ ? 1 : 0);
    if (digits >= text_.size() || !(is_digit(text_[digits]) || text_[digits] == '.')) return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + first, text_.data() + text_.size(), value);
    if (error != std::errc{} || !(std::abs(value) <= max_number)) return std::nullopt;
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  /// "'x'" or "the end": what stands here, for messages.
  std::string here() const {
    if (at_end()) return "the end";
    const char c = next();
    if (c > ' ' && c < '\x7F') return std::string("'") + c + "'";
    return "a character that is not allowed";
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// The pen that path commands move.
class Tracer {
 public:
  Tracer(double tolerance, std::vector<Subpath>& subpaths) : tolerance_(tolerance), subpaths_(subpaths) {}

  void close() {
    if (open_) {
      Subpath& closed = subpaths_.back();
      closed.closed = true;
      if (closed.points.size() > 1 && closed.points.back() == closed.points.front()) closed.points.pop_back();
    }
    open_ = false;
    here_ = start_;
    last_ = 'Z';
  }

  /// Runs a command with its arguments, as many as argument_count says.
  void run(char command, const double* a) {
    const Vec2 origin = is_relative(command) ? here_ : Vec2{};
    const auto point = [&](int i) { return origin + Vec2{a[i], a[i + 1]}; };
    const char kind = upper(command);
    switch (kind) {
      case 'M':
        move_to(point(0));
        break;
      case 'L':
        line_to(point(0));
        break;
      case 'H':
        line_to({origin.x + a[0], here_.y});
        break;
      case 'V':
        line_to({here_.x, origin.y + a[0]});
        break;
      case 'C':
        cubic_to(point(0), point(2), point(4));
        break;
      case 'S':
        cubic_to(last_ == 'C' || last_ == 'S' ? mirrored_control() : here_, point(0), point(2));
        break;
      case 'Q':
        quadratic_to(point(0), point(2));
        break;
      case 'T':
        quadratic_to(last_ == 'Q' || last_ == 'T' ? mirrored_control() : here_, point(0));
        break;
      default:
        arc_to({{a[0], a[1]}, a[2], a[3] != 0.0, a[4] != 0.0}, point(5));
        break;
    }
    last_ = kind;
  }

  std::size_t point_count() const { return earlier_points_ + (subpaths_.empty() ? 0 : subpaths_.back().points.size()); }
  bool in_range() const { return std::abs(here_.x) <= max_number && std::abs(here_.y) <= max_number; }

 private:
  Vec2 mirrored_control() const { return 2.0 * here_ - control_; }

  void move_to(Vec2 to) {
    open_ = false;
    here_ = start_ = to;
  }

  /// The points of the subpath that is being drawn; begun by the first line or curve after M or Z.
  std::vector<Vec2>& drawn() {
    if (!open_) {
      if (!subpaths_.empty()) earlier_points_ += subpaths_.back().points.size();
      subpaths_.push_back({{here_}, false});
      start_ = here_;
      open_ = true;
    }
    return subpaths_.back().points;
  }

  void line_to(Vec2 to) {
    drawn().push_back(to);
    here_ = to;
  }
  void quadratic_to(Vec2 control, Vec2 to) {
    flatten_quadratic(here_, control, to, tolerance_, drawn());
    control_ = control;
    here_ = to;
  }
  void cubic_to(Vec2 control_1, Vec2 control_2, Vec2 to) {
    flatten_cubic(here_, control_1, control_2, to, tolerance_, drawn());
    control_ = control_2;
    here_ = to;
  }
  void arc_to(const EllipticArc& arc, Vec2 to) {
    flatten_arc(here_, arc, to, tolerance_, drawn());
    here_ = to;
  }

  double tolerance_;
  std::vector<Subpath>& subpaths_;
  std::size_t earlier_points_ = 0;  ///< in all subpaths but the last
  Vec2 here_{};
  Vec2 start_{};
  Vec2 control_{};
  char last_ = '\0';
  bool open_ = false;
};

/// How many numbers a command takes; nothing for a letter that is no command.
std::optional<int> argument_count(char command) {
  switch (upper(command)) {
    case 'Z':
      return 0;
    case 'H':
    case 'V':
      return 1;
    case 'M':
    case 'L':
    case 'T':
      return 2;
    case 'S':
    case 'Q':
      return 4;
    case 'C':
      return 6;
    case 'A':
      return 7;
    default:
      return std::nullopt;
  }
}

class Parser {
 public:
  Parser(std::string_view d, double tolerance) : words_(d), tracer_(tolerance, subpaths_) {}

  /// Reads everything, or up to the first fault.
  std::optional<Fault> parse() {
    words_.skip_blanks();
    while (!words_.at_end() && !fault_) take_command();
    return std::move(fault_);
  }
  std::vector<Subpath> take() { return std::move(subpaths_); }

 private:
  void fail(std::string message, Trouble trouble = Trouble::input) {
    fault_ = Fault{words_.offset(), std::move(message), trouble};
  }

  void take_command() {
    const char command = words_.next();
    const std::optional<int> arguments = is_letter(command) ? argument_count(command) : std::nullopt;
    if (!arguments) return fail("expected a path command (M L H V C S Q T A Z), not " + words_.here());
    if (commands_ == 0 && upper(command) != 'M') return fail("path data must begin with M or m, not " + words_.here());
    words_.advance();
    words_.skip_blanks();
    if (*arguments > 0) return take_argument_sets(command, *arguments);
    if (count_command()) tracer_.close();
  }

  /// The argument sets of one command letter; those after the first repeat the command, M as L.
  void take_argument_sets(char command, int arguments) {
    bool more = true;
    while (more) {
      if (!count_command() || !take_arguments(command, arguments)) return;
      tracer_.run(command, arguments_);
      if (!tracer_.in_range()) return fail("this leads outside [-1e12, 1e12]; scale the path down");
      if (tracer_.point_count() > max_points) {
        return fail("the curves need more than 1048576 points; raise the tolerance or shorten the path",
                    Trouble::limit);
      }
      if (upper(command) == 'M') command = command == 'M' ? 'L' : 'l';
      const bool comma = words_.skip_comma();
      more = words_.number_follows();
      if (comma && !more) return fail("expected a number after the comma, not " + words_.here());
    }
  }

  bool take_arguments(char command, int arguments) {
    for (int i = 0; i < arguments; ++i) {
      if (i > 0) words_.skip_comma();
      const bool flag = upper(command) == 'A' && (i == 3 || i == 4);
      if (!(flag ? take_flag(i) : take_number(command, i))) return false;
    }
    return true;
  }

  bool take_flag(int i) {
    const char digit = words_.next();
    if (digit != '0' && digit != '1') {
      fail("expected an arc flag, 0 or 1, not " + words_.here());
      return false;
    }
    arguments_[i] = digit - '0';
    words_.advance();
    return true;
  }

  bool take_number(char command, int i) {
    if (!words_.number_follows()) {
      fail(std::string("'") + command + "' expects a number, not " + words_.here());
      return false;
    }
    const std::optional<double> number = words_.number();
    if (!number) fail("this is no number between -1e12 and 1e12");
    arguments_[i] = number.value_or(0.0);
    return number.has_value();
  }

  bool count_command() {
    if (++commands_ > max_commands) fail("more than 65536 path commands; shorten the path", Trouble::limit);
    return !fault_;
  }

  Words words_;
  std::vector<Subpath> subpaths_;
  Tracer tracer_;
  double arguments_[7] = {};
  std::size_t commands_ = 0;
  std::optional<Fault> fault_;
};

}  // namespace

Result<std::vector<Subpath>> parse_svg_path(std::string_view d, double tolerance, const Where& where) {
  Parser parser(d, tolerance);
  if (const std::optional<Fault> fault = parser.parse()) {
    Problem problem{where, "path data, character " + std::to_string(fault->offset + 1) + ": " + fault->message,
                    fault->trouble};
    if (where.line > 0) problem.where.column += static_cast<int>(fault->offset);
    return problem;
  }
  return parser.take();
}

}  // namespace burin::data
