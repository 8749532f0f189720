#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <burin/base/units.hpp>
#include <burin/output/pdf/colour_operators.hpp>
#include <burin/output/pdf/page.hpp>
#include <burin/output/pdf/text.hpp>

namespace burin::output::pdf {

namespace {

constexpr double mark_length_mm = 5.0;
constexpr double mark_width_mm = 0.1;
/// Marks keep this far from the trimmed page, or as far as the bleed.
constexpr double least_mark_distance_mm = 2.0;
constexpr double air_mm = 1.0;

double mark_distance_mm(const Page& page) {
  return std::max(page.bleed_mm, least_mark_distance_mm);
}

/// "[left bottom right top]" in points, of the page grown by `beyond_mm`.
std::string box(const Page& page, double beyond_mm) {
  const double low_mm = page_surround_mm(page) - beyond_mm;
  const auto points = [](double mm) { return number_text(mm / mm_per_point); };
  const std::string low = points(low_mm);
  return fmt::format("[{} {} {} {}]", low, low, points(low_mm + page.width_mm + 2.0 * beyond_mm),
                     points(low_mm + page.height_mm + 2.0 * beyond_mm));
}

std::string line(double x0, double y0, double x1, double y1) {
  return fmt::format("{} {} m {} {} l\n", number_text(x0), number_text(y0), number_text(x1), number_text(y1));
}

/// Two lines at each corner that point at it.
std::string crop_marks(const Page& page) {
  const double near = mark_distance_mm(page);
  const double far = near + mark_length_mm;
  std::string text = fmt::format("q\n/Marks CS 1 SCN {} w\n", number_text(mark_width_mm));
  for (const double y : {0.0, page.height_mm}) text += line(-far, y, -near, y);
  for (const double y : {0.0, page.height_mm}) text += line(page.width_mm + near, y, page.width_mm + far, y);
  for (const double x : {0.0, page.width_mm}) text += line(x, -far, x, -near);
  for (const double x : {0.0, page.width_mm}) text += line(x, page.height_mm + near, x, page.height_mm + far);
  return text + "S\nQ\n";
}

}  // namespace

double page_surround_mm(const Page& page) {
  return page.bleed_mm > 0.0 ? mark_distance_mm(page) + mark_length_mm + air_mm : 0.0;
}

std::string page_boxes(const Page& page) {
  std::string text = "/MediaBox" + box(page, page_surround_mm(page));
  if (page.bleed_mm > 0.0) text += "/TrimBox" + box(page, 0.0) + "/BleedBox" + box(page, page.bleed_mm);
  return text;
}

std::string ink_box(const Page& page, double unit_mm) {
  const auto units = [&](double mm) { return number_text(mm / unit_mm); };
  return fmt::format("{0} {0} {1} {2}", units(-page.bleed_mm), units(page.width_mm + page.bleed_mm),
                     units(page.height_mm + page.bleed_mm));
}

std::string page_begin(const Page& page, bool paper) {
  const double surround_mm = page_surround_mm(page);
  const std::string scale = number_text(1.0 / mm_per_point, 9);
  std::string text = fmt::format("{0} 0 0 -{0} {1} {2} cm\n", scale, number_text(surround_mm / mm_per_point),
                                 number_text((surround_mm + page.height_mm) / mm_per_point));
  const std::string rectangle =
      fmt::format("{0} {0} {1} {2}", number_text(-page.bleed_mm), number_text(page.width_mm + 2.0 * page.bleed_mm),
                  number_text(page.height_mm + 2.0 * page.bleed_mm));
  if (page.bleed_mm > 0.0) text += crop_marks(page) + rectangle + " re W n\n";
  if (paper) text += fmt::format("{} {} re f\n", fill_operator(page.paper), rectangle);
  return text;
}

std::string crop_mark_space() {
  return "[/Separation/All/DeviceCMYK<</FunctionType 2/Domain[0 1]/C0[0 0 0 0]/C1[1 1 1 1]/N 1>>]";
}

}  // namespace burin::output::pdf
