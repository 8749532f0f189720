#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/expr/functions.hpp>
#include <burin/expr/scan.hpp>

namespace burin::expr {

namespace {

constexpr std::size_t longest_text = 4096;
constexpr std::size_t deepest_nesting = 100;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool continues_name(char c) {
  return begins_name(c) || is_digit(c);
}

/// `text` for a message, cut when it is long.
std::string shown(std::string_view text) {
  constexpr std::size_t longest_shown = 60;
  return text.size() <= longest_shown ? std::string(text) : std::string(text.substr(0, longest_shown)) + "...";
}

bool takes(const Function& function, std::size_t arguments) {
  const std::size_t kind = function.call.index();  // unary, binary, ternary, variadic
  return kind == 3 || arguments == kind + 1;
}

std::string_view arguments_taken(const Function& function) {
  static constexpr std::array<std::string_view, 4> words{"1 argument", "2 arguments", "3 arguments", "any arguments"};
  return words[function.call.index()];
}

/// What is between an opening bracket (or the start) and here.
struct Level {
  std::size_t opened_at = 0;
  const Function* function = nullptr;  ///< whose arguments these are; null for plain parentheses
  std::size_t arguments = 1;
  std::vector<std::size_t> questions{};  ///< where a '?' still waits for its ':'
};

class Scanner {
 public:
  Scanner(std::string_view text, std::span<const std::string_view> variables, const Where& where,
          std::span<const PlaneFunction> functions)
      : text_(text), variables_(variables), where_(where) {
    result_.uses.resize(variables.size());
    for (const PlaneFunction& own : functions) own_functions_.push_back({own.name, Binary{}});
  }

  Result<Scan> run() {
    if (text_.size() > longest_text) {
      refuse(0, fmt::format("the expression has {} characters; at most {} are allowed", text_.size(), longest_text));
    }
    for (skip_blanks(); !problem_ && at_ < text_.size(); skip_blanks()) {
      if (value_expected_) {
        read_value();
      } else {
        read_operation();
      }
    }
    if (!problem_) check_end();
    if (problem_) return *std::move(problem_);
    return std::move(result_);
  }

 private:
  void refuse(std::size_t offset, std::string message) {
    Where place = where_;
    if (place.line > 0) {
      place.column += static_cast<int>(offset);
    } else if (offset > 0) {  // no line to point into
      message = fmt::format("at character {} of '{}': {}", offset + 1, shown(text_), message);
    }
    problem_ = Problem{std::move(place), std::move(message)};
  }

  bool next_is(char c) const { return at_ < text_.size() && text_[at_] == c; }
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  void take(std::size_t length) {
    result_.formula += text_.substr(at_, length);
    at_ += length;
  }
  std::string_view name_here() const {
    const auto end = std::find_if_not(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(), continues_name);
    return text_.substr(at_, static_cast<std::size_t>(end - text_.begin()) - at_);
  }
  /// The character here for a message, whole if it has several bytes.
  std::string shown_character() const {
    const auto byte = static_cast<unsigned char>(text_[at_]);
    if (byte < 0x20U || byte == 0x7FU) return fmt::format("\\x{:02x}", byte);
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    return std::string(text_.substr(at_, end - at_));
  }

  /// Signs, then a number, a name or an opening bracket.
  void read_value() {
    read_signs();
    if (problem_ || at_ == text_.size()) return;
    const char c = text_[at_];
    if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      read_number();
    } else if (begins_name(c)) {
      read_name();
    } else if (c == '(') {
      open(nullptr, at_);
    } else if (c == ')' && levels_.back().function != nullptr && result_.formula.back() == '(') {
      refuse(at_, fmt::format("'{}' needs an argument", levels_.back().function->name));
    } else {
      refuse(at_, fmt::format("a number, a name or '(' is expected here, not '{}'", shown_character()));
    }
  }

  /// muParser takes one sign before a value: a run of + and - becomes one - or nothing, a ! stands alone.
  void read_signs() {
    bool negative = false;
    for (; next_is('+') || next_is('-'); skip_blanks()) negative ^= text_[at_++] == '-';
    if (negative) result_.formula += '-';
    if (!next_is('!')) return;
    const std::size_t not_at = at_;
    take(1);
    skip_blanks();
    if (negative || next_is('+') || next_is('-') || next_is('!')) {
      refuse(not_at, "'!' cannot stand beside another sign; use parentheses, as in !(-x)");
    }
  }

  void read_number() {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    const auto length = static_cast<std::size_t>(end - (text_.data() + at_));
    if (error != std::errc{}) {
      return refuse(at_, fmt::format("'{}' is too large or too small for a number", shown(text_.substr(at_, length))));
    }
    take(length);
    value_expected_ = false;
  }

  void read_name() {
    const std::string_view name = name_here();
    const std::size_t name_at = at_;
    at_ += name.size();
    skip_blanks();
    if (next_is('(')) {
      const Function* function = function_called(name);
      if (function == nullptr) return refuse(name_at, unknown("function", name, function_names()));
      result_.formula += name;
      return open(function, name_at);
    }
    if (const auto found = std::find(variables_.begin(), variables_.end(), name); found != variables_.end()) {
      result_.uses[static_cast<std::size_t>(found - variables_.begin())] = true;
    } else if (!is_constant(name)) {
      if (function_called(name) != nullptr) {
        return refuse(name_at, fmt::format("'{0}' is a function: write {0}(...)", name));
      }
      return refuse(name_at, unknown("name", name, value_names()));
    }
    result_.formula += name;
    value_expected_ = false;
  }

  static bool is_constant(std::string_view name) {
    return std::ranges::any_of(constants(), [name](const Constant& constant) { return constant.name == name; });
  }
  const Function* function_called(std::string_view name) const {
    const auto own = std::ranges::find(own_functions_, name, &Function::name);
    return own != own_functions_.end() ? &*own : find_function(name);
  }
  std::vector<std::string_view> function_names() const {
    std::vector<std::string_view> names;
    for (const Function& function : own_functions_) names.push_back(function.name);
    for (const Function& function : functions()) names.push_back(function.name);
    return names;
  }
  std::vector<std::string_view> value_names() const {
    std::vector<std::string_view> names(variables_.begin(), variables_.end());
    for (const Constant& constant : constants()) names.push_back(constant.name);
    return names;
  }
  /// Suggests a variable, a constant or a function; `right_kind` are the names that would fit here.
  std::string unknown(std::string_view kind, std::string_view name,
                      const std::vector<std::string_view>& right_kind) const {
    std::vector<std::string_view> names = right_kind;
    for (const std::string_view other : value_names()) names.push_back(other);
    for (const std::string_view other : function_names()) names.push_back(other);
    const bool has_near_name = !closest_word(name, names).empty();
    return fmt::format("unknown {} '{}'{}", kind, shown(name), suggestion(name, has_near_name ? names : right_kind));
  }

  void open(const Function* function, std::size_t place) {
    if (levels_.size() > deepest_nesting) {
      return refuse(at_, fmt::format("more than {} parentheses inside each other", deepest_nesting));
    }
    levels_.push_back({place, function});
    take(1);
  }

  /// What may follow a value: an operator, ? and :, a comma, a closing bracket.
  void read_operation() {
    switch (text_[at_]) {
      case ')':
        return close();
      case ',':
        return read_comma();
      case '?':
        return read_question();
      case ':':
        return read_colon();
      default:
        return read_operator();
    }
  }

  void close() {
    if (levels_.size() == 1) return refuse(at_, "this ')' closes nothing");
    if (!check_level()) return;
    const Level level = levels_.back();
    if (level.function != nullptr && !takes(*level.function, level.arguments)) {
      return refuse(level.opened_at, fmt::format("'{}' takes {}, not {}", level.function->name,
                                                 arguments_taken(*level.function), level.arguments));
    }
    levels_.pop_back();
    take(1);
  }

  void read_comma() {
    if (levels_.back().function == nullptr) {
      return refuse(at_, "',' only separates the arguments of a function; decimals take a point, as in 0.5");
    }
    if (!check_level()) return;
    ++levels_.back().arguments;
    take(1);
    value_expected_ = true;
  }

  void read_question() {
    levels_.back().questions.push_back(at_);
    take(1);
    value_expected_ = true;
  }

  void read_colon() {
    if (levels_.back().questions.empty()) return refuse(at_, "':' without a '?' before it");
    levels_.back().questions.pop_back();
    take(1);
    value_expected_ = true;
  }

  void read_operator() {
    static constexpr std::array<std::string_view, 13> operators{"||", "&&", "==", "!=", "<=", ">=", "<",
                                                                ">",  "+",  "-",  "*",  "/",  "^"};
    const std::string_view rest = text_.substr(at_);
    for (const std::string_view known : operators) {
      if (!rest.starts_with(known)) continue;
      take(known.size());
      value_expected_ = true;
      return;
    }
    switch (rest.front()) {
      case '=':
        return refuse(at_, "'=' assigns nothing here; compare with '=='");
      case '&':
        return refuse(at_, "'&' is no operator; 'and' is written '&&'");
      case '|':
        return refuse(at_, "'|' is no operator; 'or' is written '||'");
      case '%':
        return refuse(at_, "'%' is no operator; the remainder is mod(a, b)");
      default:
        break;
    }
    if (begins_name(rest.front()) || is_digit(rest.front()) || rest.front() == '(' || rest.front() == '.') {
      return refuse(at_, fmt::format("an operator is missing before '{}'; a product is written with '*'",
                                     begins_name(rest.front()) ? shown(name_here()) : shown_character()));
    }
    refuse(at_, fmt::format("unexpected character '{}'", shown_character()));
  }

  /// Whether every '?' of the innermost level has its ':'.
  bool check_level() {
    const std::vector<std::size_t>& questions = levels_.back().questions;
    if (!questions.empty()) refuse(questions.back(), "'?' without its ':', as in a > b ? a : b");
    return questions.empty();
  }

  void check_end() {
    if (value_expected_) {
      return refuse(text_.size(), result_.formula.empty() ? "an expression is missing"
                                                          : "the expression ends where a value is expected");
    }
    if (levels_.size() > 1) return refuse(levels_.back().opened_at, "this parenthesis is never closed");
    check_level();
  }

  std::string_view text_;
  std::span<const std::string_view> variables_;
  Where where_;
  std::vector<Function> own_functions_;  ///< no more are added: addresses of these are kept
  std::size_t at_ = 0;
  bool value_expected_ = true;
  std::vector<Level> levels_{Level{}};  ///< the outermost first
  Scan result_;
  std::optional<Problem> problem_;
};

}  // namespace

Result<Scan> scan(std::string_view text, std::span<const std::string_view> variables, const Where& where,
                  std::span<const PlaneFunction> functions) {
  return Scanner(text, variables, where, functions).run();
}

}  // namespace burin::expr
