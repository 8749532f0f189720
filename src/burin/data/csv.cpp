#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include <burin/base/number_text.hpp>
#include <burin/data/csv.hpp>

namespace burin::data {
namespace {

constexpr std::size_t max_points = 10'000'000;
constexpr std::size_t max_problems = 10;
constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// What separates the fields of this file, judged by its first line: ';' before tab before ',', since a decimal comma
/// may stand in the fields of the other two; else blanks.
char separator_of(std::string_view line) {
  for (const char candidate : {';', '\t', ','}) {
    if (line.find(candidate) != std::string_view::npos) return candidate;
  }
  return ' ';
}

/// The fields of a line without blanks and quotes around them. All are views into `line`.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  std::size_t at = 0;
  while (at <= line.size()) {
    if (separator == ' ') {
      at = std::min(line.find_first_not_of(blanks, at), line.size());
      if (at == line.size()) return;
    }
    const std::size_t end =
        std::min(separator == ' ' ? line.find_first_of(blanks, at) : line.find(separator, at), line.size());
    std::string_view field = trimmed(line.substr(at, end - at));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    at = end + 1;
  }
}

bool is_header(const std::vector<std::string_view>& fields) {
  return std::none_of(fields.begin(), fields.end(), [](std::string_view f) { return parse_number(f).has_value(); });
}

/// What columns of coordinates are called.
constexpr std::array<std::string_view, 4> x_names{"x", "lon", "long", "longitude"};
constexpr std::array<std::string_view, 3> y_names{"y", "lat", "latitude"};

bool is_named(std::string_view field, std::span<const std::string_view> names) {
  const auto same_letter = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return std::equal(field.begin(), field.end(), name.begin(), name.end(), same_letter);
  });
}

struct Columns {
  std::size_t x = 0;
  std::size_t y = 1;
  std::vector<std::size_t> of_path{};  ///< those called layer and path: a new path where one of them changes
};

/// The columns with names of x and of y; the first two when one of the names is missing.
Columns columns_of(const std::vector<std::string_view>& header) {
  const auto find = [&](std::span<const std::string_view> names) {
    return std::find_if(header.begin(), header.end(), [&](std::string_view f) { return is_named(f, names); });
  };
  const auto x = find(x_names);
  const auto y = find(y_names);
  Columns columns;
  if (x != header.end() && y != header.end()) {
    columns.x = static_cast<std::size_t>(x - header.begin());
    columns.y = static_cast<std::size_t>(y - header.begin());
  }
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i] == "layer" || header[i] == "path") columns.of_path.push_back(i);
  }
  return columns;
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  /// False: no use in reading on.
  bool take_line(std::string_view line, int number) {
    if (const std::string_view text = trimmed(line); text.empty() || text.front() == '#') return true;
    const bool first = !separator_.has_value();
    if (first) separator_ = separator_of(trimmed(line));
    split(line, *separator_, fields_);
    if (first && is_header(fields_)) {
      columns_ = columns_of(fields_);
      return true;
    }
    take_point(line, number);
    return problems_.size() < max_problems && !full_;
  }

  Result<CsvPoints> result() && {
    if (!problems_.empty()) return std::move(problems_);
    if (found_.points.empty()) return Problem{{file_}, "has no points; expected one 'x,y' a line"};
    return std::move(found_);
  }

  /// Where the paths begin.
  const std::vector<std::size_t>& starts() const { return starts_; }

 private:
  void take_point(std::string_view line, int number) {
    const std::size_t wanted = std::max(columns_.x, columns_.y) + 1;
    if (fields_.size() < wanted) {
      problems_.push_back({{file_, number, 1},
                           "expected at least " + std::to_string(wanted) + " columns, found " +
                               std::to_string(fields_.size()) + "; write one point a line: x,y"});
      return;
    }
    const std::optional<double> x = coordinate(line, number, columns_.x);
    const std::optional<double> y = coordinate(line, number, columns_.y);
    if (!x || !y) return;
    if (found_.points.size() == max_points) {
      problems_.push_back({{file_, number, 1}, "more than 10000000 points; thin the file out", Trouble::limit});
      full_ = true;
      return;
    }
    if (is_new_path()) starts_.push_back(found_.points.size());
    found_.points.push_back({*x, *y});
    found_.lines.push_back(number);
  }

  bool is_new_path() {
    std::string path;
    for (const std::size_t column : columns_.of_path) {
      if (column < fields_.size()) path += std::string(fields_[column]) + '\n';
    }
    if (!found_.points.empty() && path == path_) return false;
    path_ = std::move(path);
    return true;
  }

  std::optional<double> coordinate(std::string_view line, int number, std::size_t column) {
    const std::string_view field = fields_[column];
    const std::optional<double> value = parse_number(field);
    if (!value) {
      const int place = field.data() == nullptr ? 1 : static_cast<int>(field.data() - line.data()) + 1;
      problems_.push_back(
          {{file_, number, place}, "expected a number, not '" + std::string(field.substr(0, 40)) + "'"});
    }
    return value;
  }

  const std::string& file_;
  std::optional<char> separator_;
  Columns columns_;
  std::vector<std::string_view> fields_;
  CsvPoints found_;
  std::vector<std::size_t> starts_;
  std::string path_;  ///< what the columns of the path say
  Problems problems_;
  bool full_ = false;
};

/// Hands every line to the reader.
void read_lines(std::string_view text, Reader& reader) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (!reader.take_line(text.substr(0, end), ++number)) break;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

Result<CsvPoints> read_csv_lines(std::string_view text, const std::string& file) {
  Reader reader(file);
  read_lines(text, reader);
  return std::move(reader).result();
}

Result<std::vector<Vec2>> read_csv_points(std::string_view text, const std::string& file) {
  Result<CsvPoints> read = read_csv_lines(text, file);
  if (!read) return read.problems();
  return std::move(read->points);
}

Result<std::vector<std::vector<Vec2>>> read_csv_paths(std::string_view text, const std::string& file) {
  Reader reader(file);
  read_lines(text, reader);
  const std::vector<std::size_t> starts = reader.starts();
  const Result<CsvPoints> read = std::move(reader).result();
  if (!read) return read.problems();
  const std::vector<Vec2>& points = read->points;
  std::vector<std::vector<Vec2>> paths;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : points.size();
    paths.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(starts[i]),
                       points.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return paths;
}

}  // namespace burin::data
