#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/curves/two_point/named_motifs.hpp>

/// docs/papers.md: every figure and table of the five papers has one row, and what the rows name exists.
namespace burin {
namespace {

namespace fs = std::filesystem;

struct Row {
  std::vector<std::string> cells;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The rows of all tables of a page whose head begins with `first_column`.
std::vector<Row> table_rows(const std::string& page, const std::string& first_column) {
  std::vector<Row> rows;
  bool inside = false;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| " + first_column + " |", 0) == 0) inside = true;
    if (line.empty() || line.front() != '|') inside = false;
    if (!inside || line.rfind("|---", 0) == 0 || line.rfind("| " + first_column + " |", 0) == 0) continue;
    Row row;
    std::istringstream cells(line.substr(1));
    for (std::string cell; std::getline(cells, cell, '|');) row.cells.push_back(trimmed(cell));
    rows.push_back(row);
  }
  return rows;
}

/// The names between backquotes.
std::vector<std::string> quoted_names(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = text.find('`'); at != std::string::npos; at = text.find('`', at + 1)) {
    const std::size_t end = text.find('`', at + 1);
    if (end == std::string::npos) break;
    names.push_back(text.substr(at + 1, end - at - 1));
    at = end;
  }
  return names;
}

bool exists(const std::string& name) {
  const fs::path root = BURIN_SOURCE_DIR;
  if (name.rfind("tests/", 0) == 0) return fs::is_regular_file(root / name);
  return fs::is_regular_file(root / "presets" / (name + ".toml")) || curves::two_point::find_motif(name) != nullptr;
}

/// What is wrong with the last cell of a row, which says what shows or holds it; empty: nothing.
std::string fault(const std::string& cell) {
  const std::vector<std::string> names = quoted_names(cell);
  if (cell.rfind("open", 0) == 0) {
    if (!names.empty()) return "an open row names '" + names.front() + "'";
    return cell.rfind("open: comes with ", 0) == 0 ? "" : "an open row says 'open: comes with ...'";
  }
  if (names.empty()) return "names nothing and is not open";
  for (const std::string& name : names) {
    if (!exists(name)) return "'" + name + "' is no preset, motif or test";
  }
  return {};
}

/// The figures and tables of the five papers, in their order.
std::vector<std::string> figures_and_tables() {
  const auto numbered = [](const std::string& what, int count) {
    std::vector<std::string> names;
    for (int i = 1; i <= count; ++i) names.push_back(what + ' ' + std::to_string(i));
    return names;
  };
  std::vector<std::string> all;
  for (const auto& names :
       {numbered("A Fig.", 8), numbered("B Fig.", 4), numbered("C Fig.", 7), numbered("C Tab.", 4),
        numbered("D Fig.", 8), numbered("D Tab.", 1), numbered("E Fig.", 3), numbered("E Tab.", 1)}) {
    all.insert(all.end(), names.begin(), names.end());
  }
  return all;
}

std::string ledger() {
  std::ostringstream text;
  text << std::ifstream(fs::path(BURIN_SOURCE_DIR) / "docs" / "papers.md").rdbuf();
  return text.str();
}

TEST(Papers, EveryFigureAndTableHasOneRow) {
  std::map<std::string, int> rows;
  for (const Row& row : table_rows(ledger(), "figure")) {
    ASSERT_EQ(row.cells.size(), 3U) << row.cells.front();
    EXPECT_FALSE(row.cells[1].empty()) << row.cells[0];
    ++rows[row.cells[0]];
  }
  const std::vector<std::string> expected = figures_and_tables();
  EXPECT_EQ(expected.size(), 36U);
  for (const std::string& name : expected) EXPECT_EQ(rows[name], 1) << name;
  EXPECT_EQ(rows.size(), expected.size()) << "a row is no figure or table of the papers";
}

TEST(Papers, WhatTheRowsNameExists) {
  int shown = 0;
  for (const Row& row : table_rows(ledger(), "figure")) {
    EXPECT_EQ(fault(row.cells.back()), "") << row.cells[0];
    shown += row.cells.back().rfind("open", 0) == 0 ? 0 : 1;
  }
  EXPECT_GE(shown, 4);
}

TEST(Papers, PrintedValuesStandBesideTheCorrectedOnes) {
  const std::vector<Row> rows = table_rows(ledger(), "where");
  EXPECT_GE(rows.size(), 39U);
  std::set<std::string> printed;
  for (const Row& row : rows) {
    ASSERT_EQ(row.cells.size(), 5U) << row.cells[0];
    for (const std::string& cell : row.cells) EXPECT_FALSE(cell.empty()) << row.cells[0];
    EXPECT_NE(row.cells[1], row.cells[2]) << row.cells[0];
    EXPECT_EQ(fault(row.cells.back()), "") << row.cells[0];
    printed.insert(row.cells[1]);
  }
  EXPECT_EQ(printed.size(), rows.size());
}

TEST(Papers, AWrongRowIsFound) {
  EXPECT_EQ(fault("open: comes with the trees"), "");
  EXPECT_EQ(fault("preset `koch`; `tests/papers_test.cpp`"), "");
  EXPECT_NE(fault("open: comes with `koch`"), "");
  EXPECT_NE(fault("open"), "");
  EXPECT_NE(fault("preset koch"), "");
  EXPECT_NE(fault("preset `no-such-preset`"), "");
  EXPECT_NE(fault("`tests/no_such_test.cpp`"), "");
  EXPECT_EQ(table_rows("| figure | shows |\n|---|---|\n| A Fig. 1 | x |\n\n| A Fig. 2 | y |\n", "figure").size(), 1U);
}

}  // namespace
}  // namespace burin
