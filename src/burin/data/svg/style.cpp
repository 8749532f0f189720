#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <burin/data/svg/style.hpp>
#include <burin/data/svg/words.hpp>

namespace burin::data::svg {

namespace {

constexpr std::size_t max_rules = 500;

struct Property {
  std::string_view name;
  std::string_view Style::*member;
};

constexpr std::array<Property, 23> properties{{{"color", &Style::color},
                                               {"fill", &Style::fill},
                                               {"fill-rule", &Style::fill_rule},
                                               {"fill-opacity", &Style::fill_opacity},
                                               {"stroke", &Style::stroke},
                                               {"stroke-width", &Style::stroke_width},
                                               {"stroke-opacity", &Style::stroke_opacity},
                                               {"stroke-linecap", &Style::linecap},
                                               {"stroke-linejoin", &Style::linejoin},
                                               {"stroke-miterlimit", &Style::miterlimit},
                                               {"stroke-dasharray", &Style::dasharray},
                                               {"stroke-dashoffset", &Style::dashoffset},
                                               {"marker", &Style::marker},
                                               {"marker-start", &Style::marker},
                                               {"marker-end", &Style::marker},
                                               {"visibility", &Style::visibility},
                                               {"display", &Style::display},
                                               {"opacity", &Style::opacity},
                                               {"transform", &Style::transform},
                                               {"clip-path", &Style::clip_path},
                                               {"mask", &Style::mask},
                                               {"filter", &Style::filter},
                                               {"vector-effect", &Style::vector_effect}}};

/// What a child begins with: all that is inherited.
Style inherited(const Style& parent) {
  Style style = parent;
  const Style initial;
  style.display = initial.display;
  style.opacity = initial.opacity;
  style.transform = initial.transform;
  style.clip_path = initial.clip_path;
  style.mask = initial.mask;
  style.filter = initial.filter;
  style.vector_effect = initial.vector_effect;
  return style;
}

/// Null when nothing is drawn by such a property.
const Property* find_property(std::string_view name) {
  const auto found = std::ranges::find(properties, name, &Property::name);
  return found == properties.end() ? nullptr : &*found;
}

void apply(std::string_view Style::*member, std::string_view value, const Style& parent, Style& style) {
  if (value == "inherit") value = parent.*member;
  if (!value.empty()) style.*member = value;
}

/// The text with its comments blanked out.
std::string without_comments(std::string text) {
  for (std::size_t at = text.find("/*"); at != std::string::npos; at = text.find("/*", at)) {
    const std::size_t end = text.find("*/", at + 2);
    const std::size_t past = end == std::string::npos ? text.size() : end + 2;
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin() + static_cast<std::ptrdiff_t>(past), ' ');
    at = past;
  }
  return text;
}

/// What stands between blanks.
std::vector<std::string_view> words_of(std::string_view list) {
  std::vector<std::string_view> words;
  for (list = trimmed(list); !list.empty(); list = trimmed(list)) {
    const std::size_t end = std::min(list.find_first_of(" \t\n\r\f"), list.size());
    words.push_back(list.substr(0, end));
    list.remove_prefix(end);
  }
  return words;
}

}  // namespace

int StyleSheet::Selector::weight() const {
  return (id.empty() ? 0 : 10'000) + 10 * static_cast<int>(classes.size()) + (tag.empty() ? 0 : 1);
}

bool StyleSheet::Labels::match(const Selector& selector) const {
  if (!selector.tag.empty() && selector.tag != tag) return false;
  if (!selector.id.empty() && selector.id != id) return false;
  return std::ranges::all_of(selector.classes,
                             [&](std::string_view name) { return std::ranges::find(classes, name) != classes.end(); });
}

/// "fill: none; stroke: red !important".
std::vector<StyleSheet::Declaration> StyleSheet::parse_declarations(std::string_view text) {
  std::vector<Declaration> declarations;
  while (!text.empty()) {
    std::string_view value = take_until(text, ';');
    const Property* property = find_property(take_until(value, ':'));
    value = trimmed(value.substr(0, value.find('!')));
    if (property == nullptr || value.empty()) continue;
    const auto same = std::ranges::find(declarations, property->member, &Declaration::member);
    if (same == declarations.end()) {
      declarations.push_back({property->member, value});
    } else {
      same->value = value;
    }
  }
  return declarations;
}

bool StyleSheet::parse_selector(std::string_view text, Selector& selector) {
  if (text.empty() || text.find_first_of(" \t\n\r\f>+~:[@\\") != std::string_view::npos) return false;
  while (!text.empty()) {
    const char kind = text.front();
    const bool marked = kind == '.' || kind == '#';
    const std::size_t end = std::min(text.find_first_of(".#", marked ? 1 : 0), text.size());
    const std::string_view word = text.substr(marked ? 1 : 0, end - (marked ? 1 : 0));
    if (word.empty()) return false;
    if (kind == '.') {
      selector.classes.push_back(word);
    } else if (kind == '#') {
      selector.id = word;
    } else if (word != "*") {
      selector.tag = word;
    }
    text.remove_prefix(end);
  }
  return true;
}

void StyleSheet::add_rule(std::string_view selectors, std::string_view declarations,
                          std::vector<std::string>& not_understood) {
  const std::vector<Declaration> parsed = parse_declarations(declarations);
  while (!selectors.empty()) {
    const std::string_view text = take_until(selectors, ',');
    Selector selector;
    if (!parse_selector(text, selector) || rules_.size() == max_rules) {
      not_understood.emplace_back(text);
      return;
    }
    const auto place = std::upper_bound(rules_.begin(), rules_.end(), selector.weight(),
                                        [](int weight, const Rule& rule) { return weight < rule.selector.weight(); });
    rules_.insert(place, {std::move(selector), parsed});
  }
}

void StyleSheet::add(std::string text, std::vector<std::string>& not_understood) {
  texts_.push_back(std::make_shared<const std::string>(without_comments(std::move(text))));
  std::string_view rest = trimmed(*texts_.back());
  while (!rest.empty()) {
    const std::size_t open = rest.find('{');
    const std::string_view selectors = take_until(rest, '{');
    if (open == std::string_view::npos) {
      not_understood.emplace_back(selectors);
      return;
    }
    const std::string_view declarations = take_until(rest, '}');
    if (selectors != "@font-face") add_rule(selectors, declarations, not_understood);  // of texts, which are not drawn
    rest = trimmed(rest);
    if (not_understood.size() > max_rules) return;
  }
}

Style StyleSheet::style_of(const XmlElement& element, const Style& parent) const {
  Style style = inherited(parent);
  for (const Property& property : properties) {
    if (const std::optional<std::string_view> value = element.attribute(property.name)) {
      apply(property.member, trimmed(*value), parent, style);
    }
  }
  const Labels labels{element.local_name(), element.attribute("id").value_or(""),
                      words_of(element.attribute("class").value_or(""))};
  for (const Rule& rule : rules_) {
    if (!labels.match(rule.selector)) continue;
    for (const Declaration& each : rule.declarations) apply(each.member, each.value, parent, style);
  }
  if (const std::optional<std::string_view> own = element.attribute("style")) {
    for (const Declaration& each : parse_declarations(*own)) apply(each.member, each.value, parent, style);
  }
  return style;
}

}  // namespace burin::data::svg
