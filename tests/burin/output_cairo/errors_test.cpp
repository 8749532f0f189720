#include <cstdio>
#include <cstdlib>
#include <random>
#include <sys/resource.h>

#include <gtest/gtest.h>

#include "drawing.hpp"

namespace burin::test {
namespace {

/// Takes `writes` writes and fails from then on.
class FailingSink final : public ByteSink {
 public:
  explicit FailingSink(int writes) : writes_left_(writes) {}
  bool write(std::string_view) override {
    EXPECT_FALSE(failed_) << "written to after a failure";
    failed_ = writes_left_-- == 0;
    return !failed_;
  }
  std::string failure() const override { return failed_ ? "No space left on device" : ""; }

 private:
  int writes_left_;
  bool failed_ = false;
};

Flow draw_noise(PathSink& to) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0.0, 20.0);
  std::uniform_real_distribution<double> y(0.0, 10.0);
  std::vector<Vec2> points;
  for (int i = 0; i < 12000; ++i) points.push_back({x(random), y(random)});
  return draw_line(to, points);
}

class Format : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Cairo, Format, testing::Values("svg", "pdf", "png"));

TEST_P(Format, ReportsAWriteThatFailsWhicheverItIs) {
  Sheet sheet = small_sheet();
  sheet.pens[0] = {.name = "blue", .colour = {20, 60, 200}, .width_mm = 0.01};
  OutputOptions options;
  options.dots_per_mm = 20.0;
  int failures = 0;
  for (;; ++failures) {
    FailingSink bytes(failures);
    const auto sink = cairo_back_end(GetParam()).open(bytes, sheet, options);
    static_cast<void>(draw_noise(*sink));
    const Result<Done> result = sink->finish();
    if (bytes.failure().empty()) {
      EXPECT_TRUE(result.ok());
      break;
    }
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.problems()[0].trouble, Trouble::output);
    EXPECT_NE(result.problems()[0].message.find("No space left on device"), std::string::npos);
    EXPECT_EQ(draw_noise(*sink), Flow::stop);
  }
  EXPECT_GE(failures, 2) << "too small to fail in the middle";
}

TEST_P(Format, WritesNothingWhenTheDrawingIsGivenUp) {
  const Sheet sheet = small_sheet();
  StringSink bytes;
  {
    const auto sink = cairo_back_end(GetParam()).open(bytes, sheet, {});
    static_cast<void>(draw_noise(*sink));
  }
  EXPECT_EQ(bytes.text(), "");
}

TEST_P(Format, AnEmptyDrawingIsAWholeFile) {
  EXPECT_GT(drawn(GetParam(), small_sheet(), [](PathSink&) { return Flow::go; }).size(), 100U);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Address sanitizers need more room than this leaves.
TEST(Memory, APictureThatDoesNotFitIsAnError) {
  const auto draw_in_little_memory = [] {
    const rlimit little{rlim_t{2} << 30U, rlim_t{2} << 30U};
    setrlimit(RLIMIT_AS, &little);
    Sheet sheet = small_sheet();
    sheet.page = {.width_mm = 3000.0, .height_mm = 3000.0};
    StringSink bytes;
    const auto sink = cairo_back_end("png").open(bytes, sheet, ten_dots());
    const Flow flow = draw_line(*sink, {{1.0, 1.0}, {9.0, 9.0}});
    const Result<Done> result = sink->finish();
    const bool right =
        flow == Flow::stop && !result.ok() && result.problems()[0].trouble == Trouble::limit && bytes.text().empty();
    std::fputs(result.ok() ? "no problem" : result.problems()[0].message.c_str(), stderr);
    std::exit(right ? 0 : 1);
  };
  EXPECT_EXIT(draw_in_little_memory(), testing::ExitedWithCode(0), "not enough memory to draw the PNG");
}
#endif

}  // namespace
}  // namespace burin::test
