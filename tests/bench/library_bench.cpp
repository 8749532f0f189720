#include <cstring>
#include <ctime>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include <burin/burin.hpp>
#include <burin/curves/family.hpp>
#include <burin/output/raster/png.hpp>
#include <burin/path/point_store.hpp>
#include <burin/path/recording.hpp>

#include "bench/costs.hpp"
#include "support/json_value.hpp"

/// What the library costs inside a program that has started already.
namespace burin::test {
namespace {

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Cost cost_of(const std::function<void()>& work) {
  const double start = cpu_s();
  work();
  const double spent = cpu_s() - start;
  return {spent, spent, 0.0};
}

TEST(LibraryBench, PointsInMemoryCostAFewTimesAsMuchAsClearingIt) {
  const curves::TwoPointParams params = testing::two_point(R"({"motif": "koch", "levels": 10})");
  std::vector<Vec2> points((std::size_t{1} << 20U) + 1);
  Cost clearing = unknown;
  Cost drawing = unknown;
  for (int turn = 0; turn < 31; ++turn) {
    clearing = cheapest(
        clearing, cost_of([&] { std::memset(static_cast<void*>(points.data()), 1, sizeof(Vec2) * points.size()); }));
    PointStore store(points);
    drawing = cheapest(drawing, cost_of([&] {
                         EXPECT_EQ(curves::find_family("two-point")->draw(params, DrawContext{}, store), Flow::go);
                       }));
    EXPECT_EQ(store.stored().size(), points.size());
  }
  const double ratio = drawing.cpu_s / clearing.cpu_s;
  print_ratio("a million points / memset of them", {ratio, ratio, ratio});
  EXPECT_LE(ratio, 3.0);
}

TEST(LibraryBench, AZoomOfAMillionCostsLittleMoreThanNone) {
  const auto plan_of = [](int levels) {
    return *load(
        {"koch.toml",
         "burin = 1\npage = { size = \"200x200mm\", margin = \"10mm\" }\npens = { ink = { width = \"0.2mm\" } }\n"
         "layer = [{ curve = { family = \"two-point\", motif = \"koch\", levels = " +
             std::to_string(levels) + " } }]\n"});
  };
  const preset::Plan plan = plan_of(40);
  Recorder recorder;
  static_cast<void>(plan_of(4).run(recorder, {}));
  const Vec2 on_curve_mm = recorder.recording().all_points()[77];
  const auto draw = [&](double zoom) {
    OutputOptions options;
    options.dots_per_mm = 5.0;
    StringSink bytes;
    const auto sink = output::open_png(bytes, plan.sheet(), options, {});
    preset::RunOptions run;
    run.tolerance_mm = output::png_back_end().tolerance_mm(plan.sheet(), options);
    run.window = preset::PageWindow{on_curve_mm, 200.0 / zoom};
    static_cast<void>(plan.run(*sink, run));
    EXPECT_TRUE(sink->finish().ok());
  };
  Cost near = unknown;
  Cost far = unknown;
  for (int turn = 0; turn < 15; ++turn) {
    near = cheapest(near, cost_of([&] { draw(1e6); }));
    far = cheapest(far, cost_of([&] { draw(1.0); }));
  }
  print_row("Koch, 1000 px, zoom 1, in the process", far);
  print_row("Koch, 1000 px, zoom 10^6, in the process", near);
  print_ratio("zoom 10^6 / zoom 1", {near.cpu_s / far.cpu_s, near.cpu_s / far.cpu_s, near.cpu_s / far.cpu_s});
  EXPECT_LE(near.cpu_s, 6.0 * far.cpu_s);
  EXPECT_LE(near.cpu_s, 0.012);  // a third of it for noise
}

}  // namespace
}  // namespace burin::test
