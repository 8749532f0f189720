#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <burin/preset/toml_traps.hpp>

namespace burin::preset {

namespace {

/// A syntax error with the line it is in.
struct Trap {
  std::string_view line;
  std::size_t at;  ///< offset in the line where the parser stopped
  Where where;
  std::string_view reason;

  bool says(std::string_view words) const { return reason.find(words) != std::string_view::npos; }

  Problem problem(std::size_t offset, std::string message) const {
    return {{where.file, where.line, static_cast<int>(offset) + 1}, std::move(message)};
  }
  Problem here(std::string message) const { return problem(at, std::move(message)); }
};

std::string_view line_at(std::string_view text, int number) {
  for (; number > 1; --number) {
    const std::size_t newline = text.find('\n');
    if (newline == std::string_view::npos) return {};
    text.remove_prefix(newline + 1);
  }
  std::string_view line = text.substr(0, text.find('\n'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// What stands between the first pair of straight quotes of the parser's words.
std::string_view quoted_name(std::string_view reason) {
  const std::size_t begin = reason.find('\'');
  const std::size_t end = reason.rfind('\'');
  if (begin == std::string_view::npos || end <= begin) return {};
  return reason.substr(begin + 1, end - begin - 1);
}

/// The value around `at` as somebody wrote it who forgot the quotes: up to a comma or bracket outside parentheses.
struct BareWord {
  std::size_t begin;
  std::string_view text;
};

BareWord bare_word(std::string_view line, std::size_t at) {
  std::size_t begin = std::min(at, line.size());
  while (begin > 0 && std::string_view(" \t=,[{").find(line[begin - 1]) == std::string_view::npos) --begin;
  std::size_t end = begin;
  int parentheses = 0;
  for (; end < line.size(); ++end) {
    const char c = line[end];
    if (c == '(') ++parentheses;
    if (c == ')') --parentheses;
    if (parentheses <= 0 && (c == ',' || c == ']' || c == '}')) break;
    if (c == '#' && end > begin) break;
  }
  return {begin, trimmed(line.substr(begin, end - begin))};
}

bool has_smart_quote(std::string_view word) {
  static constexpr std::array<std::string_view, 7> quotes{"\u201C", "\u201D", "\u201E", "\u2018",
                                                          "\u2019", "\u00AB", "\u00BB"};
  return std::any_of(quotes.begin(), quotes.end(),
                     [&](std::string_view quote) { return word.find(quote) != std::string_view::npos; });
}

constexpr std::string_view straight_quotes_wanted = "these are typographic quotes; use straight ones: \"...\"";

/// "did you mean .5 to be 0.5": how TOML writes a number or truth value that only lacks its form; empty for others.
std::string as_toml_value(std::string_view word) {
  std::string small(word);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (small == "true" || small == "false") return small;
  std::string_view rest = word;
  std::string sign;
  if (!rest.empty() && (rest.front() == '-' || rest.front() == '+')) {
    sign = rest.substr(0, 1);
    rest.remove_prefix(1);
  }
  if (rest.empty() || rest.find_first_not_of("0123456789.") != std::string_view::npos) return {};
  const std::size_t dot = rest.find('.');
  if (rest.size() < 2 || (dot != std::string_view::npos && rest.find('.', dot + 1) != std::string_view::npos))
    return {};
  std::string whole(rest.substr(0, dot));
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size()));
  if (whole.empty()) whole = "0";
  std::string fraction(dot == std::string_view::npos ? std::string_view{} : rest.substr(dot + 1));
  if (dot != std::string_view::npos && fraction.empty()) fraction = "0";
  std::string number = sign + whole + (fraction.empty() ? "" : "." + fraction);
  return number == word ? std::string{} : number;
}

Problem explain_bare_value(const Trap& trap) {
  const BareWord word = bare_word(trap.line, trap.at);
  if (has_smart_quote(word.text)) return trap.problem(word.begin, std::string(straight_quotes_wanted));
  if (word.text.empty()) return trap.here("a value is missing here");
  if (const std::string value = as_toml_value(word.text); !value.empty()) {
    return trap.problem(word.begin, fmt::format("'{}' is written {}", word.text, value));
  }
  if (trap.says("not representable") || trap.says("could not be interpreted")) {
    return trap.problem(word.begin, fmt::format("the number {} is too large", word.text));
  }
  return trap.problem(word.begin, fmt::format("text needs quotes: \"{}\"", word.text));
}

Problem explain_inline_table(const Trap& trap) {
  if (trap.says("dangling comma")) {
    return trap.here("a comma before the closing '}'; remove it");
  }
  if (trap.says("saw '\\n'") || trap.says("saw '\\r'") || trap.says("saw '#'")) {
    return trap.here("a line break inside { }; keep the braces on one line, or write a [table] of its own");
  }
  if (trap.says("end-of-file")) return trap.here("a '{' is not closed; add '}'");
  if (trap.says("expected comma")) return trap.here("a ',' is missing between two keys in { }");
  return trap.here("expected a key or '}' here");
}

Problem explain_repeated(const Trap& trap) {
  const std::string_view name = quoted_name(trap.reason);
  const bool header = trap.says("table header");
  if (header && (name == "layer" || name.substr(0, name.find('\'')) == "layer")) {
    return trap.here("each layer begins with [[layer]], in two pairs of brackets");
  }
  if (header) {
    const std::string_view table = name.substr(0, name.find('\''));
    return trap.here(fmt::format("[{}] is written twice; put all its keys in one place", table));
  }
  const std::string_view last_part = name.substr(name.rfind('.') + 1);
  const std::size_t key = last_part.empty() ? std::string_view::npos : trap.line.rfind(last_part, trap.at);
  const std::size_t place = key == std::string_view::npos ? trap.at : key;
  if (name.empty()) return trap.problem(place, "this key is a value already, so it cannot have keys of its own");
  return trap.problem(place, fmt::format("'{}' is given twice; keep one of them", name));
}

Problem explain_table_header(const Trap& trap) {
  if (trap.says("blank bare keys")) return trap.here("a table needs a name: [page]");
  if (trap.says("end-of-file") || trap.says("expected ']'")) {
    const bool two = trimmed(trap.line).substr(0, 2) == "[[";
    return trap.here(fmt::format("the table's name is not closed; add '{}'", two ? "]]" : "]"));
  }
  return trap.here("expected the name of a table: letters, digits, _ and -");
}

Problem explain_key_value(const Trap& trap) {
  const bool has_sign = trap.line.substr(0, trap.at).find('=') != std::string_view::npos;
  if (trap.says("expected '='") || !has_sign) {
    const std::string_view key = trimmed(trap.line.substr(0, trap.at));
    const std::string_view seen = trap.line.substr(std::min(trap.at, trap.line.size()));
    if (!seen.empty() && seen.front() == ':') return trap.here("write '=' between key and value, not ':'");
    if (seen.empty())
      return trap.problem(trap.at - std::min(trap.at, key.size()),
                          fmt::format("'{}' has no value; write '{} = ...'", key, key));
    return trap.here("'=' is missing between key and value");
  }
  if (trap.says("expected value") || trap.says("end-of-file")) {
    const std::string_view seen = trimmed(trap.line.substr(std::min(trap.at, trap.line.size())));
    if (!seen.empty() && seen.front() == '#') {
      return trap.here(
          fmt::format("# begins a comment; put a colour in quotes: \"{}\"", seen.substr(0, seen.find(' '))));
    }
    return trap.here("a value is missing after '='");
  }
  // Something follows a complete value.
  const bool touches = trap.at > 0 && trap.at <= trap.line.size() && trap.line[trap.at - 1] != ' ' &&
                       trap.line[trap.at - 1] != '"' && trap.line[trap.at - 1] != '\'';
  const char seen = trap.at < trap.line.size() ? trap.line[trap.at] : '\n';
  if (seen == ',') return trap.here("no comma is needed between keys; each begins a line of its own");
  if (seen == ']' || seen == '}') return trap.here(fmt::format("a '{}' too many", seen));
  if (touches) return explain_bare_value(trap);
  return trap.here("something follows the value; text with blanks needs quotes, and the next key a line of its own");
}

Problem explain_string(const Trap& trap) {
  if (trap.says("unknown escape")) {
    return trap.here("unknown escape; write \\\\ for a backslash, or use single quotes: '...'");
  }
  if (trap.says("end-of-file") || trap.at >= trap.line.size())
    return trap.here("the quotes are not closed on this line");
  return trap.here("this cannot stand in a text");
}

}  // namespace

Problem explain_syntax_error(std::string_view text, const Where& where, std::string_view reason) {
  const std::string_view line = line_at(text, where.line);
  const Trap trap{line, static_cast<std::size_t>(std::max(where.column, 1) - 1), where, reason};
  const auto parsing = [&](std::string_view what) { return trap.says("parsing " + std::string(what)); };
  if (trap.says("cannot redefine")) return explain_repeated(trap);
  if (parsing("inline table")) return explain_inline_table(trap);
  if (parsing("table header")) return explain_table_header(trap);
  if (parsing("key-value pair")) return explain_key_value(trap);
  if (parsing("string") || parsing("literal string")) return explain_string(trap);
  if (parsing("array")) {
    if (trap.says("end-of-file")) return trap.here("a '[' is not closed; add ']'");
    if (trap.says("saw comma")) return trap.here("a value is missing before this comma");
    return trap.here("a ',' or ']' is missing before this");
  }
  if (parsing("root table") || parsing("key:")) {
    if (has_smart_quote(line)) return trap.here(std::string(straight_quotes_wanted));
    return trap.here("expected a key here: letters, digits, _ and -; others need quotes");
  }
  if (parsing("comment")) return trap.here("this character cannot stand in a comment");
  if (parsing("date") || parsing("time")) return explain_bare_value(trap);
  return explain_bare_value(trap);
}

}  // namespace burin::preset
