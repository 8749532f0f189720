#include <cstdio>
#include <fstream>
#include <plotter.h>
#include <sstream>

#include <burin/burin.hpp>

/// plotter_program PRESET OUT.svg: draws all points of a preset with GNU plotutils' library.
namespace {

class PlotterSink final : public burin::PathSink {
 public:
  explicit PlotterSink(Plotter& to) : to_(to) {}
  burin::Flow begin(const burin::PathHead&) override { return contour(); }
  burin::Flow contour() override {
    is_first_ = true;
    return burin::Flow::go;
  }
  burin::Flow points(std::span<const burin::Vec2> points) override {
    for (const burin::Vec2 p : points) {
      is_first_ ? to_.fmove(p.x, p.y) : to_.fcont(p.x, p.y);
      is_first_ = false;
    }
    return burin::Flow::go;
  }
  burin::Flow end() override {
    to_.endpath();
    return burin::Flow::go;
  }

 private:
  Plotter& to_;
  bool is_first_ = true;
};

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  std::ostringstream text;
  text << std::ifstream(words[1]).rdbuf();
  const burin::Result<burin::preset::Plan> plan = burin::load({words[1], text.str()});
  std::FILE* const file = std::fopen(words[2], "wb");
  if (!plan || file == nullptr) return 1;
  PlotterParams parameters;
  {
    SVGPlotter plotter(nullptr, file, stderr, parameters);
    if (plotter.openpl() < 0) return 1;
    plotter.fspace(0.0, 0.0, plan->sheet().page.width_mm, plan->sheet().page.height_mm);
    plotter.flinewidth(plan->sheet().pens[0].width_mm);
    PlotterSink sink(plotter);
    static_cast<void>(plan->run(sink, {}));
    plotter.closepl();
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
