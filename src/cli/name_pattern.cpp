#include <algorithm>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <cli/name_pattern.hpp>

namespace burin::cli {

namespace {

Problem wrong_brace(std::string_view path, std::string_view what) {
  return {{}, fmt::format("-o {}: {}; a brace itself is written {{{{ or }}}}", path, what)};
}

}  // namespace

Result<NamePattern> NamePattern::read(std::string_view path) {
  NamePattern pattern;
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const char c = path[i];
    const bool doubled = i + 1 < path.size() && path[i + 1] == c;
    if ((c == '{' || c == '}') && doubled) {
      text += c;
      ++i;
    } else if (c == '}') {
      return wrong_brace(path, "'}' without '{'");
    } else if (c == '{') {
      const std::size_t end = path.find('}', i);
      if (end == std::string_view::npos) return wrong_brace(path, "'{' without '}'");
      pattern.parts_.push_back({text});
      pattern.parts_.push_back({std::string(path.substr(i + 1, end - i - 1)), true});
      text.clear();
      i = end;
    } else {
      text += c;
    }
  }
  pattern.parts_.push_back({text});
  return pattern;
}

NamePattern NamePattern::of_preset(std::string_view suffix) {
  NamePattern pattern;
  pattern.parts_ = {{"preset", true}, {fmt::format(".{}", suffix)}};
  return pattern;
}

bool NamePattern::has_placeholders() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.is_name; });
}

bool NamePattern::has(std::string_view name) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) { return part.is_name && part.text == name; });
}

Result<Done> NamePattern::check(const std::vector<std::string_view>& known) const {
  for (const Part& part : parts_) {
    if (!part.is_name || std::find(known.begin(), known.end(), part.text) != known.end()) continue;
    std::string names;
    for (const std::string_view name : known) names += fmt::format("{}{{{}}}", names.empty() ? "" : ", ", name);
    return Problem{{},
                   fmt::format("-o {}: nothing is called {{{}}} here; there are {}; a brace itself is written {{{{",
                               text(), part.text, names)};
  }
  return Done{};
}

void NamePattern::add(std::string_view name) {
  // The suffix begins at the last dot after the last slash; a name that begins with the dot has none.
  std::size_t part = parts_.size();
  std::size_t at = std::string::npos;
  for (std::size_t i = parts_.size(); i-- > 0 && at == std::string::npos;) {
    if (parts_[i].is_name) continue;
    at = parts_[i].text.find_last_of("./");
    part = i;
  }
  const bool dot = at != std::string::npos && parts_[part].text[at] == '.' &&
                   ((at > 0 && parts_[part].text[at - 1] != '/') || (at == 0 && part > 0));
  if (!dot) {
    parts_.push_back({"-"});
    parts_.push_back({std::string(name), true});
    return;
  }
  const std::string tail = parts_[part].text.substr(at);
  parts_[part].text.replace(at, std::string::npos, "-");
  const auto after = parts_.begin() + static_cast<std::ptrdiff_t>(part) + 1;
  parts_.insert(after, {{std::string(name), true}, {tail}});
}

std::string NamePattern::fill(const NameValues& values) const {
  std::string path;
  for (const Part& part : parts_) {
    if (!part.is_name) {
      path += part.text;
      continue;
    }
    const auto value = std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == part.text; });
    BURIN_EXPECT(value != values.end());
    path += name_safe(value->second);
  }
  return path;
}

std::string NamePattern::text() const {
  std::string all;
  for (const Part& part : parts_) {
    if (part.is_name) {
      all += '{' + part.text + '}';
      continue;
    }
    for (const char c : part.text) all.append(c == '{' || c == '}' ? 2 : 1, c);
  }
  return all;
}

std::string name_safe(std::string_view value) {
  constexpr std::size_t most_bytes = 100;
  constexpr std::string_view allowed = "+,-.=@_";
  std::string name;
  for (const char c : value.substr(0, most_bytes)) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       static_cast<unsigned char>(c) >= 0x80;
    name += plain || allowed.find(c) != std::string_view::npos ? c : '_';
  }
  const bool dots = name.find_first_not_of('.') == std::string::npos;
  return dots ? std::string(std::max<std::size_t>(name.size(), 1), '_') : name;
}

}  // namespace burin::cli
