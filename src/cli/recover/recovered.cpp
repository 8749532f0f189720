#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <burin/preset/toml.hpp>
#include <cli/recover/found_record.hpp>
#include <cli/recover/recovered.hpp>

namespace burin::cli {

namespace {

using params::Table;
using params::Value;

enum class RowKind : std::uint8_t { text, flag, list };

/// A key of the record that stands for an option of `burin draw`.
struct RecordRow {
  std::string_view key;
  std::string_view option;
  RowKind kind;
};

constexpr std::array rows{
    RecordRow{"seed", "seed", RowKind::text},
    RecordRow{"knobs", "knob", RowKind::list},
    RecordRow{"set", "set", RowKind::list},
    RecordRow{"pens", "pens", RowKind::list},
    RecordRow{"page", "page", RowKind::text},
    RecordRow{"landscape", "landscape", RowKind::flag},
    RecordRow{"margin", "margin", RowKind::text},
    RecordRow{"enlarge", "enlarge", RowKind::text},
    RecordRow{"format", "format", RowKind::text},
    RecordRow{"backend", "backend", RowKind::text},
    RecordRow{"size", "size", RowKind::text},
    RecordRow{"dpi", "dpi", RowKind::text},
    RecordRow{"decimals", "decimals", RowKind::text},
    RecordRow{"view", "view", RowKind::text},
    RecordRow{"paper", "paper", RowKind::flag},
    RecordRow{"defs", "defs", RowKind::flag},
    RecordRow{"all-points", "all-points", RowKind::flag},
    RecordRow{"only", "only", RowKind::list},
    RecordRow{"skip", "skip", RowKind::list},
};

/// Takes the record's table apart and collects what is wrong with it.
class RecordReader {
 public:
  RecordReader(const Table& table, std::string where) : table_(table), where_(std::move(where)) {}

  Result<Recovered> read() {
    if (table_.find("sheet") != nullptr) {
      report("is a contact sheet, and redraw draws single pieces; make it again with burin sheet");
      return std::move(problems_);
    }
    Recovered recovered;
    recovered.version = text("burin");
    recovered.preset.file = text("preset");
    recovered.preset.source.text = text("text");
    recovered.preset.source.name = fmt::format("{} ({})", recovered.preset.file, where_);
    recovered.preset.stem = recovered.preset.file == "-" ? std::string(stdin_stem)
                                                         : std::filesystem::path(recovered.preset.file).stem().string();
    for (const params::Entry& entry : table_.entries) read_entry(entry.key, entry.value, recovered);
    if (!problems_.empty()) return std::move(problems_);
    return recovered;
  }

 private:
  void report(std::string message) { problems_.push_back({{where_}, std::move(message)}); }

  std::string text(std::string_view key) {
    const Value* value = table_.find(key);
    if (value != nullptr && value->text() != nullptr) return *value->text();
    report(fmt::format("its origin has no text '{}': it is damaged, or no record of burin", key));
    return {};
  }

  void read_entry(const std::string& key, const Value& value, Recovered& recovered) {
    if (key == "burin" || key == "preset" || key == "text") return;
    if (key == "data") return read_data(value, recovered);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const RecordRow& r) { return r.key == key; });
    if (row == rows.end()) return report_unknown(key, recovered.version);
    const std::string option(row->option);
    if (row->kind == RowKind::flag) {
      const bool* flag = std::get_if<bool>(&value.data);
      if (flag == nullptr) return report_kind(key, "true or false", value);
      if (*flag) recovered.options.emplace_back(option, "");
    } else if (row->kind == RowKind::text) {
      if (value.text() == nullptr) return report_kind(key, "a text", value);
      recovered.options.emplace_back(option, *value.text());
    } else {
      if (value.array() == nullptr) return report_kind(key, "a list of texts", value);
      for (const Value& item : *value.array()) {
        if (item.text() == nullptr) return report_kind(key, "a list of texts", item);
        recovered.options.emplace_back(option, *item.text());
      }
    }
  }

  void read_data(const Value& value, Recovered& recovered) {
    if (value.array() == nullptr) return report_kind("data", "a list of tables", value);
    for (const Value& item : *value.array()) {
      const Value* name = item.table() == nullptr ? nullptr : item.table()->find("name");
      const Value* digest = item.table() == nullptr ? nullptr : item.table()->find("sha256");
      if (name == nullptr || name->text() == nullptr || digest == nullptr || digest->text() == nullptr) {
        return report("its origin names a data file without its name or its sha256");
      }
      recovered.data.push_back({*name->text(), *digest->text()});
    }
  }

  void report_kind(std::string_view key, std::string_view expected, const Value& found) {
    report(fmt::format("'{}' in its origin must be {}, not {}", key, expected, found.kind_name()));
  }

  void report_unknown(const std::string& key, const std::string& version) {
    if (version == BURIN_VERSION) {
      report(fmt::format("its origin has the key '{}', which burin does not write; was it changed by hand?", key));
    } else {
      report(fmt::format("its origin has the key '{}', which burin " BURIN_VERSION " does not know: burin {} drew it; "
                         "redraw it with that version or a later one",
                         key, version));
    }
  }

  const Table& table_;
  std::string where_;
  Problems problems_;
};

}  // namespace

Result<Recovered> read_record(const std::string& record, const std::string& shown) {
  preset::Findings findings;
  const std::string where = fmt::format("origin in {}", shown);
  const std::optional<Table> table = preset::parse_toml(record, where, findings, longest_record_bytes);
  if (!table || !findings.empty()) {
    const Problems found = findings.sorted(where);
    return Problem{{shown}, fmt::format("its origin is damaged: {}", problem_text(found.front()))};
  }
  return RecordReader(*table, shown).read();
}

Result<Recovered> recover(const std::string& path) {
  const Result<BytesAt> bytes = bytes_of_file(path);
  if (!bytes) return bytes.problems();
  const Result<std::string> record = find_record(*bytes, path);
  if (!record) return record.problems();
  return read_record(*record, path);
}

}  // namespace burin::cli
