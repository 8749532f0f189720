#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/preset/layer_names.hpp>
#include <burin/preset/overrides.hpp>
#include <burin/preset/toml.hpp>

namespace burin::preset {

namespace {

using params::Array;
using params::Entry;
using params::Table;
using params::Value;

/// The parts of "layer.\"my name\".opacity"; nothing when a part is empty or its quotes are not closed.
std::optional<std::vector<std::string>> split_path(std::string_view path) {
  std::vector<std::string> parts;
  for (;;) {
    std::size_t end = 0;
    if (path.substr(0, 1) == "\"") {
      const std::size_t closing = path.find('"', 1);
      if (closing == std::string_view::npos) return std::nullopt;
      parts.emplace_back(path.substr(1, closing - 1));
      end = closing + 1;
      if (end < path.size() && path[end] != '.') return std::nullopt;
    } else {
      end = std::min(path.find('.'), path.size());
      parts.emplace_back(path.substr(0, end));
    }
    if (parts.back().empty()) return std::nullopt;
    if (end == path.size()) return parts;
    path.remove_prefix(end + 1);
  }
}

/// Sets one key of the tree; reports where its path leads nowhere.
class KeySetter {
 public:
  KeySetter(Table& root, const std::string& path, Value value, Findings& findings)
      : root_(root), path_(path), value_(std::move(value)), findings_(findings) {}

  void run() {
    const std::optional<std::vector<std::string>> parts = split_path(path_);
    if (!parts) return refuse("expected a path such as page.margin or layer.NAME.opacity");
    const std::string& top = parts->front();
    if (std::find(top_level_keys.begin(), top_level_keys.end(), top) == top_level_keys.end()) {
      return refuse(fmt::format("no key '{}' in a preset{}", top, suggestion(top, top_level_keys)));
    }
    if (top == "layer") return set_in_layer(*parts);
    const bool named = top == "knobs" || top == "pens" || top == "define" || top == "slots";
    if (!named) return set_below(root_, *parts, 0);
    if (top == "pens" && root_.find(top) == nullptr && parts->size() > 1 && (*parts)[1] == "ink") {
      root_.set("pens", {value_.where, Table{{Entry{"ink", value_.where, {value_.where, Table{}}}}}});
    }
    set_in_named(*parts);
  }

 private:
  void refuse(std::string message) { findings_.report(value_.where, std::move(message)); }

  void set_in_named(const std::vector<std::string>& parts) {
    if (parts.size() < 2) return refuse(fmt::format("expected '{}.NAME ...'", parts.front()));
    std::vector<std::string_view> known;
    Value* section = root_.find(parts.front());
    auto* table = section == nullptr ? nullptr : std::get_if<Table>(&section->data);
    if (table != nullptr) {
      for (const Entry& entry : table->entries) known.push_back(entry.key);
    }
    if (std::find(known.begin(), known.end(), parts[1]) == known.end()) {
      return refuse(fmt::format("no '{}' in [{}]{}", parts[1], parts.front(), suggestion(parts[1], known)));
    }
    set_below(*table, parts, 1);
  }

  void set_in_layer(const std::vector<std::string>& parts) {
    if (parts.size() < 3) return refuse("expected 'layer.NAME.key', NAME being a layer's name or number");
    Value* section = root_.find("layer");
    auto* layers = section == nullptr ? nullptr : std::get_if<Array>(&section->data);
    if (layers == nullptr) return refuse("the preset has no layers");
    const std::vector<std::string> names = layer_names(*layers);
    std::size_t index = static_cast<std::size_t>(std::find(names.begin(), names.end(), parts[1]) - names.begin());
    if (index == names.size()) {
      std::size_t number = 0;
      const char* end = parts[1].data() + parts[1].size();
      const auto [stop, error] = std::from_chars(parts[1].data(), end, number);
      if (error == std::errc{} && stop == end && number >= 1 && number <= names.size()) index = number - 1;
    }
    auto* table = index == names.size() ? nullptr : std::get_if<Table>(&(*layers)[index].data);
    if (table == nullptr) {
      return refuse(fmt::format("no layer '{}'{}", parts[1],
                                suggestion(parts[1], std::vector<std::string_view>(names.begin(), names.end()))));
    }
    set_below(*table, parts, 2);
  }

  /// Sets parts[first].parts[first + 1]... in `table`; tables on the way are made as needed.
  void set_below(Table& table, const std::vector<std::string>& parts, std::size_t first) {
    Table* at = &table;
    for (std::size_t i = first; i + 1 < parts.size(); ++i) {
      if (at->find(parts[i]) == nullptr) at->set(parts[i], {value_.where, Table{}});
      Value* next = at->find(parts[i]);
      at = std::get_if<Table>(&next->data);
      if (at == nullptr) {
        return refuse(fmt::format("'{}' is {}{}, which has no keys", parts[i], next->kind_name(),
                                  next->text() != nullptr ? " ('" + *next->text() + "')" : std::string{}));
      }
    }
    at->set(parts.back(), std::move(value_));
  }

  Table& root_;
  const std::string& path_;
  Value value_;
  Findings& findings_;
};

}  // namespace

void apply_overrides(Table& root, const Overrides& overrides, Findings& findings) {
  const auto set = [&](const std::string& path, Value value) {
    KeySetter(root, path, std::move(value), findings).run();
  };
  const Value* pens = root.find("pens");
  const bool only_black_ink = pens == nullptr && root.find("palette") == nullptr;
  const Table* written_pens = pens == nullptr ? nullptr : pens->table();
  for (const auto& [path, text] : overrides.pens) {
    const std::optional<std::vector<std::string>> parts = split_path(path);
    const Where where{fmt::format("--pens {}={}", path, text)};
    if (!parts || parts->size() != 2) {
      findings.report(where, "expected a set of pens, or a key of a pen such as red.width=0.4mm");
      continue;
    }
    const std::string& pen = parts->front();
    const bool has_pen = only_black_ink ? pen == "ink" : written_pens != nullptr && written_pens->find(pen) != nullptr;
    if (!has_pen) continue;
    std::optional<Value> value = parse_toml_value(text, where, findings);
    set("pens." + path, value ? *std::move(value) : Value{where, text});
  }
  for (const auto& [path, text] : overrides.keys) {
    const Where where{fmt::format("--set {}={}", path, text)};
    std::optional<Value> value = parse_toml_value(text, where, findings);
    set(path, value ? *std::move(value) : Value{where, text});
  }
  if (overrides.page_size) set("page.size", {{"--page " + *overrides.page_size}, *overrides.page_size});
  if (overrides.landscape) set("page.landscape", {{"--landscape"}, true});
  if (overrides.margin) set("page.margin", {{"--margin " + *overrides.margin}, *overrides.margin});
}

}  // namespace burin::preset
