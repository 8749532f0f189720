#include <string_view>

#include <fmt/format.h>

#include <burin/base/problem.hpp>

namespace burin {

namespace {

std::string_view line_of(std::string_view text, int line) {
  std::size_t begin = 0;
  for (int at = 1; at < line; ++at) {
    const std::size_t newline = text.find('\n', begin);
    if (newline == std::string_view::npos) return {};
    begin = newline + 1;
  }
  const std::size_t end = text.find('\n', begin);
  std::string_view found = text.substr(begin, end == std::string_view::npos ? end : end - begin);
  if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
  return found;
}

/// The caret line: tabs stay tabs so that the caret stands under its character, and a character of several bytes counts
/// once.
std::string caret_under(std::string_view line, int column) {
  std::string caret;
  for (std::size_t at = 0; at + 1 < static_cast<std::size_t>(column) && at < line.size(); ++at) {
    const auto byte = static_cast<unsigned char>(line[at]);
    if ((byte & 0xC0U) == 0x80U) continue;
    caret += byte == '\t' ? '\t' : ' ';
  }
  return caret + '^';
}

/// A longer line would fill the terminal; the position then has to do.
constexpr std::size_t longest_shown_line = 200;

}  // namespace

std::string problem_text(const Problem& problem) {
  const Where& where = problem.where;
  std::string text;
  if (!where.file.empty()) {
    text = where.line > 0 ? fmt::format("{}:{}:{}: ", where.file, where.line, where.column)
                          : fmt::format("{}: ", where.file);
  }
  text += "error: " + problem.message;
  if (!problem.source_line.empty() && problem.source_line.size() <= longest_shown_line) {
    text += fmt::format("\n  {}\n  {}", problem.source_line, caret_under(problem.source_line, where.column));
  }
  return text;
}

std::string problems_text(const Problems& problems) {
  std::string text;
  for (const Problem& problem : problems) text += problem_text(problem) + '\n';
  return text;
}

void attach_source(Problems& problems, const std::string& file, std::string_view text) {
  for (Problem& problem : problems) {
    if (problem.where.file == file && problem.where.line > 0 && problem.source_line.empty()) {
      problem.source_line = line_of(text, problem.where.line);
    }
  }
}

}  // namespace burin
