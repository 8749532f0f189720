#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <burin/base/math.hpp>
#include <burin/output/back_ends.hpp>
#include <burin/output_cairo/back_ends.hpp>

#include "support/random_paths.hpp"

/// draw_lines --backend NAME -o FILE.pdf: 100,000 strokes of 20 points that wander over a page of 700 x 700 mm. The
/// library alone, so that the cost is that of the back end.
namespace {

class FileSink final : public burin::ByteSink {
 public:
  explicit FileSink(const char* path) : file_(std::fopen(path, "wb")) {}
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;
  ~FileSink() override {
    if (file_ != nullptr) std::fclose(file_);
  }
  bool write(std::string_view bytes) override {
    return file_ != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file_) == bytes.size();
  }
  std::string failure() const override { return "cannot write"; }

 private:
  std::FILE* file_;
};

burin::Flow draw_lines(burin::PathSink& to) {
  constexpr double side_mm = 700.0;
  constexpr int strokes = 100'000;
  burin::test::Dice dice(7);
  std::vector<burin::Vec2> points(20);
  for (int stroke = 0; stroke < strokes; ++stroke) {
    burin::Vec2 at{dice.between(0.0, side_mm), dice.between(0.0, side_mm)};
    double direction = dice.between(0.0, 6.2831853);
    for (burin::Vec2& p : points) {
      p = at;
      direction += dice.between(-0.6, 0.6);
      at = at + dice.between(0.7, 2.8) * burin::Vec2{burin::math::cos(direction), burin::math::sin(direction)};
    }
    if (to.begin({}) == burin::Flow::stop || to.points(points) == burin::Flow::stop || to.end() == burin::Flow::stop) {
      return burin::Flow::stop;
    }
  }
  return burin::Flow::go;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) return 2;
  const std::string name = words[2];
  burin::Sheet sheet;
  sheet.page = {.width_mm = 720.0, .height_mm = 720.0};
  sheet.pens = {{"ink", {}, 0.1}};
  sheet.layers = {{.name = "lines"}};
  for (const auto& rows : {burin::output::back_ends(), burin::output_cairo::back_ends()}) {
    for (const burin::BackEnd& row : rows) {
      if (row.format != "pdf" || row.name != name) continue;
      FileSink file(words[4]);
      const auto sink = row.open(file, sheet, {});
      return draw_lines(*sink) == burin::Flow::go && sink->finish() ? 0 : 1;
    }
  }
  return 2;
}
