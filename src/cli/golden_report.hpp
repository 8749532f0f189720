#pragma once

#include <string>
#include <vector>

#include <cli/golden_case.hpp>

/// What `burin golden --report` writes beside the pictures. No date, host or duration is in it: the same results give
/// the same bytes.
namespace burin::cli {

inline constexpr std::string_view report_page_file = "index.html";
inline constexpr std::string_view report_junit_file = "junit.xml";

/// A page that shows every case that failed, with NAME.png where there are panels, and lists the others.
std::string golden_page(const GoldenFolder& folder, const std::vector<GoldenResult>& results);

/// The results as JUnit XML, which CI services read: a test case for each preset and for each orphan. A preset that
/// cannot be drawn is an error, a difference a failure.
std::string golden_junit(const GoldenFolder& folder, const std::vector<GoldenResult>& results);

}  // namespace burin::cli
