#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include <burin/base/xml_text.hpp>
#include <cli/golden_report.hpp>

namespace burin::cli {

namespace {

constexpr std::string_view orphan_words = "has no preset beside it; remove it, or bring its preset back";

constexpr std::string_view style =
    "body { font: 16px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 1300px; padding: 0 1em; "
    "color: #222; background: #fff }\n"
    "h2 { margin: 2em 0 .3em; border-top: 1px solid #ccc; padding-top: .6em }\n"
    "img { width: 100%; border: 1px solid #b8b8b8 }\n"
    "pre { background: #f4f2ee; padding: .6em; overflow-x: auto }\n"
    ".panels { display: grid; grid-template-columns: 1fr 1fr 1fr; font-size: 14px; color: #666 }\n"
    ".good { color: #276b27 } .bad { color: #b0001c }\n"
    "ul { columns: 4 14em }\n";

bool is_good(const GoldenResult& result) {
  return result.problems.empty() && result.differences.empty();
}

std::size_t count_good(const std::vector<GoldenResult>& results) {
  return static_cast<std::size_t>(std::count_if(results.begin(), results.end(), is_good));
}

/// What is wrong with a case, in lines.
std::string words_of(const GoldenResult& result) {
  std::string text = problems_text(result.problems);
  for (const GoldenDifference& difference : result.differences) {
    text += fmt::format("{}: {}\n", difference.file, difference.message);
  }
  return text;
}

std::string section(const GoldenResult& result) {
  std::string text =
      fmt::format("<h2 id=\"{0}\">{0}</h2>\n<pre>{1}</pre>\n", xml_text(result.name), xml_text(words_of(result)));
  if (result.panels.empty()) return text;
  return text + fmt::format(
                    "<div class=\"panels\"><span>golden</span><span>drawn</span><span>difference: red is darker "
                    "now, blue is lighter</span></div>\n<img src=\"{0}.png\" alt=\"golden, drawn and "
                    "difference of {0}\">\n",
                    xml_text(result.name));
}

/// "motifs" and "koch" of "motifs/koch"; JUnit groups by the first.
std::pair<std::string_view, std::string_view> group_and_name(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  if (slash == std::string_view::npos) return {"golden", name};
  return {name.substr(0, slash), name.substr(slash + 1)};
}

std::string junit_case(std::string_view name, std::string_view kind, std::string_view message,
                       const std::string& details) {
  const auto [group, own_name] = group_and_name(name);
  const std::string head =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml_text(group), xml_text(own_name));
  if (kind.empty()) return head + "/>\n";
  return head + fmt::format(">\n      <{0} message=\"{1}\">{2}</{0}>\n    </testcase>\n", kind, xml_text(message),
                            xml_text(details));
}

}  // namespace

std::string golden_page(const GoldenFolder& folder, const std::vector<GoldenResult>& results) {
  const std::size_t good = count_good(results);
  const bool all_good = good == results.size() && folder.orphans.empty();
  const std::string title = xml_text("Goldens of " + folder.path);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta "
      "charset=\"utf-8\">\n<title>{0}</title>\n<style>\n{1}</style>\n"
      "</head>\n<body>\n<h1>{0}</h1>\n<p class=\"{2}\">{3} of {4} cases are as they should be",
      title, style, all_good ? "good" : "bad", good, results.size());
  if (!folder.orphans.empty()) text += fmt::format("; {} files have no preset", folder.orphans.size());
  text += ".</p>\n";
  for (const GoldenResult& result : results) {
    if (!is_good(result)) text += section(result);
  }
  if (!folder.orphans.empty()) {
    text += "<h2>Without a preset</h2>\n<ul>\n";
    for (const std::string& orphan : folder.orphans) text += fmt::format("<li>{}</li>\n", xml_text(orphan));
    text += "</ul>\n";
  }
  if (good > 0) text += "<h2>As they should be</h2>\n<ul>\n";
  for (const GoldenResult& result : results) {
    if (is_good(result)) text += fmt::format("<li>{}</li>\n", xml_text(result.name));
  }
  if (good > 0) text += "</ul>\n";
  return text + "</body>\n</html>\n";
}

std::string golden_junit(const GoldenFolder& folder, const std::vector<GoldenResult>& results) {
  std::string cases;
  std::size_t failures = folder.orphans.size();
  std::size_t errors = 0;
  for (const GoldenResult& result : results) {
    if (!result.problems.empty()) {
      ++errors;
      cases += junit_case(result.name, "error", result.problems.front().message, words_of(result));
    } else if (!result.differences.empty()) {
      ++failures;
      cases += junit_case(result.name, "failure", result.differences.front().message, words_of(result));
    } else {
      cases += junit_case(result.name, "", "", "");
    }
  }
  for (const std::string& orphan : folder.orphans) {
    cases += junit_case(orphan, "failure", orphan_words, fmt::format("{}: {}\n", orphan, orphan_words));
  }
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\"",
                                         results.size() + folder.orphans.size(), failures, errors);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n  <testsuite name=\"{1}\" {0}>\n{2}  "
      "</testsuite>\n"
      "</testsuites>\n",
      counts, xml_text("burin golden " + folder.path), cases);
}

}  // namespace burin::cli
