#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include <cli/recover/utf8_text.hpp>
#include <cli/recover/xml_scanner.hpp>

namespace burin::cli {

namespace {

constexpr std::size_t longest_name = 512;
constexpr std::size_t most_bindings = 10'000;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

bool ends_name(char c) {
  return is_blank(c) || c == '/' || c == '>' || c == '=' || c == '<' || c == '\0';
}

std::pair<std::string_view, std::string_view> prefix_and_name(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return {{}, name};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

/// The character that "#x26" or "amp" stands for, appended; false when it stands for none.
bool append_entity(std::string& text, std::string_view entity) {
  constexpr std::array<std::pair<std::string_view, char>, 5> named{
      {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
  for (const auto& [name, character] : named) {
    if (entity == name) {
      text += character;
      return true;
    }
  }
  if (!entity.starts_with('#')) return false;
  const bool hexadecimal = entity.substr(1, 1) == "x";
  entity.remove_prefix(hexadecimal ? 2 : 1);
  std::uint32_t code = 0;
  const char* end = entity.data() + entity.size();
  const auto [stopped, error] = std::from_chars(entity.data(), end, code, hexadecimal ? 16 : 10);
  if (error != std::errc() || stopped != end || code == 0 || code > 0x10FFFF) return false;
  append_utf8(text, code);
  return true;
}

/// Character data with its entities resolved and its line ends made line feeds, as XML 1.0 (section 2.11) asks; nothing
/// for an entity that is not built in.
std::optional<std::string> resolved(std::string_view data) {
  std::string text;
  for (std::size_t at = 0; at < data.size(); ++at) {
    if (data[at] == '\r') {
      if (data.substr(at + 1, 1) != "\n") text += '\n';
    } else if (data[at] != '&') {
      text += data[at];
    } else {
      const std::size_t end = data.find(';', at);
      if (end == std::string_view::npos || !append_entity(text, data.substr(at + 1, end - at - 1))) return std::nullopt;
      at = end;
    }
  }
  return text;
}

}  // namespace

XmlScanner::Tag XmlScanner::next_tag() {
  while (in_.take_past("<")) {
    const char c = in_.peek();
    if (c == '/') return end_tag();
    if (c != '!' && c != '?') return begin_tag();
    if (!skip_aside(nullptr, 0)) return {Kind::broken, {}, {}, false};
  }
  return {depth_ == 0 ? Kind::finished : Kind::broken, {}, {}, false};
}

XmlScanner::Tag XmlScanner::begin_tag() {
  Tag tag{Kind::begin, {}, take_name(), false};
  const Tag broken{Kind::broken, {}, {}, false};
  if (tag.name.empty()) return broken;
  ++depth_;
  for (;;) {
    skip_blanks();
    const char c = in_.peek();
    if (c == '>' || c == '/') break;
    const std::string attribute = take_name();
    skip_blanks();
    if (attribute.empty() || in_.take() != '=') return broken;
    skip_blanks();
    const char quote = in_.take();
    if (quote != '"' && quote != '\'') return broken;
    const bool binds = attribute == "xmlns" || attribute.starts_with("xmlns:");
    std::string value;
    if (!in_.take_past({&quote, 1}, binds ? &value : nullptr, longest_name)) return broken;
    if (!binds) continue;
    if (bindings_.size() == most_bindings) return broken;
    bindings_.push_back(
        {depth_, attribute.size() > 6 ? attribute.substr(6) : std::string(), resolved(value).value_or("")});
  }
  tag.empty = in_.take() == '/';
  if (tag.empty && in_.take() != '>') return broken;
  const auto [prefix, name] = prefix_and_name(tag.name);
  tag.space = space_of(prefix);
  tag.name = std::string(name);
  if (tag.empty) {
    std::erase_if(bindings_, [this](const Binding& binding) { return binding.depth == depth_; });
    --depth_;
  }
  return tag;
}

XmlScanner::Tag XmlScanner::end_tag() {
  if (depth_ == 0 || !in_.take_past(">")) return {Kind::broken, {}, {}, false};
  while (!bindings_.empty() && bindings_.back().depth == depth_) bindings_.pop_back();
  --depth_;
  return {Kind::end, {}, {}, false};
}

bool XmlScanner::skip_aside(std::string* character_data, std::size_t limit) {
  if (in_.take() == '?') return in_.take_past("?>");
  if (in_.peek() == '-') return in_.take_past("--") && in_.take_past("-->");
  if (in_.peek() == '[') return in_.take_past("[CDATA[") && in_.take_past("]]>", character_data, limit);
  return skip_doctype();
}

/// <!DOCTYPE name "ids" [ declarations ]>
bool XmlScanner::skip_doctype() {
  int brackets = 0;
  while (!in_.at_end()) {
    const char c = in_.take();
    if ((c == '"' || c == '\'') && !in_.take_past({&c, 1})) return false;
    if (c == '[') ++brackets;
    if (c == ']') --brackets;
    if (c == '>' && brackets <= 0) return true;
  }
  return false;
}

std::string XmlScanner::take_name() {
  std::string name;
  while (!ends_name(in_.peek())) {
    const char c = in_.take();
    if (name.size() < longest_name) name += c;
  }
  return name;
}

void XmlScanner::skip_blanks() {
  while (is_blank(in_.peek())) in_.take();
}

std::string XmlScanner::space_of(std::string_view prefix) const {
  const auto found =
      std::find_if(bindings_.rbegin(), bindings_.rend(), [&](const Binding& b) { return b.prefix == prefix; });
  return found == bindings_.rend() ? std::string() : found->space;
}

std::optional<std::string> XmlScanner::text_content(std::size_t limit) {
  std::string text;
  std::string data;
  while (in_.take_past("<", &data, limit + 1)) {
    const std::optional<std::string> some = resolved(data);
    if (!some) return std::nullopt;
    text += *some;
    if (text.size() > limit) return std::nullopt;
    data.clear();
    if (in_.peek() == '/') return end_tag().kind == Kind::end ? std::optional(text) : std::nullopt;
    if (in_.peek() != '!' && in_.peek() != '?') return std::nullopt;
    std::string unparsed;
    if (!skip_aside(&unparsed, limit + 1)) return std::nullopt;
    text += unparsed;
  }
  return std::nullopt;
}

}  // namespace burin::cli
