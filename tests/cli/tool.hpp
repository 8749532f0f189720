#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/run_tool.hpp"
#include "support/temporary_folder.hpp"

/// The tool as the tests of tests/cli call it: in a fresh folder, with the shipped presets.
namespace burin::test {

/// A Koch curve with a knob that may ask for anything.
inline constexpr const char* koch_text =
    "burin = 1\n"
    "about = { title = \"Test curve\" }\n"
    "[knobs]\n"
    "levels = { default = 3, min = 0, max = 1000, doc = \"refinement levels\" }\n"
    "[pens]\n"
    "ink = { color = \"black\", width = \"0.3mm\" }\n"
    "[[layer]]\n"
    "name = \"curve\"\n"
    "curve = { family = \"two-point\", motif = \"koch\", levels = \"$levels\" }\n";

inline std::vector<std::string> tool_words(std::vector<std::string> words) {
  words.insert(words.begin(), BURIN_TOOL_PATH);
  return words;
}

inline Finished burin_in(const TemporaryFolder& folder, std::vector<std::string> words, ToolSetup setup = {}) {
  setup.folder = folder.path().string();
  return run_program(tool_words(std::move(words)), setup);
}

/// A line of a shell in which `burin` is the tool.
inline Finished shell_in(const TemporaryFolder& folder, const std::string& line) {
  ToolSetup setup;
  setup.folder = folder.path().string();
  setup.environment.emplace_back("PATH", std::string(BURIN_TOOL_FOLDER) + ":/usr/local/bin:/usr/bin:/bin");
  return run_program({"sh", "-e", "-c", line}, setup);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace burin::test
