#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include <burin/burin.hpp>
#include <burin/measure/picture_difference.hpp>
#include <cli/draw_request.hpp>
#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/formats.hpp>
#include <cli/golden_case.hpp>
#include <cli/picture_panels.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

/// A dump has little more than a megabyte, a picture is as large as its pixels allow.
constexpr std::size_t largest_golden_bytes = std::size_t{512} << 20U;
constexpr std::size_t longest_shown = 160;

/// The bytes of a golden; unset: there is none.
Result<std::optional<std::string>> golden_bytes(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error) && !error) return std::optional<std::string>();
  Result<std::string> bytes = read_file(path, path, largest_golden_bytes);
  if (!bytes) return bytes.problems();
  return std::optional<std::string>(*std::move(bytes));
}

Result<std::string> drawn(const ReadyPiece& piece, std::string_view format, const DrawRequest& request) {
  const Result<const BackEnd*> back_end = choose_back_end(format, "native");
  if (!back_end) return back_end.problems();
  preset::Plan plan = piece.plan;
  plan.set_origin({});
  StringSink bytes;
  const Result<Done> done = write(plan, **back_end, bytes, output_options(request, plan.sheet().page));
  if (!done) return with_source(done.problems(), piece.preset);
  return bytes.take();
}

/// Where two texts part: the first line that is not the same, of both. Pre: they are not the same.
std::string first_difference(const std::string& golden, const std::string& drawn) {
  std::istringstream golden_lines(golden);
  std::istringstream drawn_lines(drawn);
  const auto shown = [](const std::string& line, bool is_there) {
    if (!is_there) return std::string("(ends)");
    return line.size() <= longest_shown ? line : line.substr(0, longest_shown) + "...";
  };
  std::string golden_line;
  std::string drawn_line;
  for (int number = 1;; ++number) {
    const bool more_golden = static_cast<bool>(std::getline(golden_lines, golden_line));
    const bool more_drawn = static_cast<bool>(std::getline(drawn_lines, drawn_line));
    if (golden_line == drawn_line && more_golden && more_drawn) continue;
    if (!more_golden && !more_drawn) return "is not the same from its last line feed on";
    return fmt::format("line {} is not the same\n  golden: {}\n  drawn:  {}", number, shown(golden_line, more_golden),
                       shown(drawn_line, more_drawn));
  }
}

std::string words_of(const measure::PictureDifference& d, std::size_t pixels) {
  return fmt::format(
      "{} of {} pixels are not the same: max {} of 255 at {},{}, mean {:.3g}, worst block {:.3g} at {},{}", d.pixels,
      pixels, d.max, d.max_at.x, d.max_at.y, d.mean, d.block, d.block_at.x, d.block_at.y);
}

/// One run of check_golden.
class Check {
 public:
  Check(const GoldenFolder& folder, std::string name, const GoldenRequest& request)
      : folder_(folder), request_(request) {
    result_.name = std::move(name);
  }

  GoldenResult run() && {
    const Result<PresetText> preset = read_preset(folder_.file(result_.name, ".toml"));
    if (!preset) return failed(preset.problems());
    const Result<ReadyPiece> piece = make_ready(*preset, {}, data_reader(preset->folder));
    if (!piece) return failed(piece.problems());
    for (const params::DataDigest& data : piece->read.data) {
      result_.data.push_back((fs::path(preset->folder) / data.name).lexically_normal().generic_string());
    }
    if (const Result<Done> checked = check_dump(*piece); !checked) return failed(checked.problems());
    if (const Result<Done> checked = check_picture(*piece); !checked) return failed(checked.problems());
    return std::move(result_);
  }

 private:
  GoldenResult failed(const Problems& problems) {
    result_.problems = problems;
    result_.differences.clear();
    return std::move(result_);
  }

  Result<Done> check_dump(const ReadyPiece& piece) {
    const std::string path = folder_.file(result_.name, dump_suffix);
    const Result<std::optional<std::string>> golden = golden_bytes(path);
    if (!golden) return golden.problems();
    Result<std::string> dump = drawn(piece, "dump", {});
    if (!dump) return dump.problems();
    if (!*golden) {
      add_missing(path, *std::move(dump));
    } else if (**golden != *dump) {
      std::string message = first_difference(**golden, *dump);
      result_.differences.push_back({path, std::move(message), *std::move(dump)});
    }
    return Done{};
  }

  Result<Done> check_picture(const ReadyPiece& piece) {
    const std::string path = folder_.file(result_.name, picture_suffix);
    const Result<std::optional<std::string>> bytes = golden_bytes(path);
    if (!bytes) return bytes.problems();
    std::optional<data::Image> golden;
    std::string unreadable;
    if (*bytes) {
      Result<data::Image> read = data::read_png(**bytes, path);
      if (read) golden = *std::move(read);
      if (!read) unreadable = read.problems().front().message;
    }
    DrawRequest as_png;
    as_png.longer_side_px = golden ? std::max(golden->width, golden->height) : request_.new_px;
    Result<std::string> png = drawn(piece, "png", as_png);
    if (!png) return png.problems();
    const Result<data::Image> picture = data::read_png(*png, "what was drawn for " + path);
    if (!picture) return picture.problems();

    if (!*bytes) {
      add_missing(path, *std::move(png));
    } else if (std::string message = unreadable.empty() ? picture_message(*golden, *picture) : unreadable;
               !message.empty()) {
      result_.differences.push_back({path, std::move(message), *std::move(png)});
    }
    if (request_.wants_panels && !result_.differences.empty()) add_panels(golden, *picture);
    return Done{};
  }

  void add_missing(const std::string& path, std::string bytes) {
    result_.differences.push_back({path, "is missing", std::move(bytes), true});
  }

  /// Empty: no pixel differs.
  static std::string picture_message(const data::Image& golden, const data::Image& picture) {
    if (golden.width != picture.width || golden.height != picture.height) {
      return fmt::format("has {} x {} pixels, drawn are {} x {}", golden.width, golden.height, picture.width,
                         picture.height);
    }
    if (golden == picture) return {};
    return words_of(measure::picture_difference(golden, picture), golden.rgba.size() / 4);
  }

  void add_panels(const std::optional<data::Image>& golden, const data::Image& picture) {
    std::optional<data::Image> difference;
    if (golden && golden->width == picture.width && golden->height == picture.height) {
      difference = difference_picture(*golden, picture);
    }
    result_.panels = png_of(side_by_side({golden, picture, difference})).value_or("");
  }

  const GoldenFolder& folder_;
  const GoldenRequest& request_;
  GoldenResult result_;
};

}  // namespace

GoldenResult check_golden(const GoldenFolder& folder, const std::string& name, const GoldenRequest& request) {
  return Check(folder, name, request).run();
}

}  // namespace burin::cli
