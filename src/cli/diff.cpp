#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/measure/picture_difference.hpp>
#include <cli/atomic_file.hpp>
#include <cli/command.hpp>
#include <cli/interrupt.hpp>
#include <cli/json_text.hpp>
#include <cli/picture_file.hpp>
#include <cli/picture_panels.hpp>

namespace burin::cli {

namespace {

using measure::PictureDifference;

constexpr std::array option_rows{
    OptionRow{"out", 'o', "FILE", "write a picture of what differs, red where B is darker, blue where it is lighter"},
    OptionRow{"max", 0, "N", "allow pixels to differ by so much, of 255"},
    OptionRow{"mean", 0, "N", "allow the mean over all pixels"},
    OptionRow{"block", 0, "N", "allow the mean colours of a 4 x 4 block to differ by so much"},
    OptionRow{"json", 0, "", "tell the numbers as JSON"},
    OptionRow{"quiet", 'q', "", "tell the exit code only"},
};

constexpr std::array examples{
    Example{"burin draw koch -q -o a.png && burin diff a.png a.png", "exit code 0: equal"},
    Example{"burin draw koch -q -o a.png && burin diff a.png a.png --block 8 -o d.png",
            "allow what two renderers may differ by, and draw the difference"},
};

/// A limit of the command line, and what the pictures have.
struct Tolerance {
  std::string_view option;
  std::optional<double> allowed;
};

struct Request {
  std::string first;
  std::string second;
  std::array<Tolerance, 3> tolerances{{{"max", {}}, {"mean", {}}, {"block", {}}}};
  std::optional<std::string> out;
  bool json = false;
  bool quiet = false;
};

Result<Request> read_request(const Arguments& arguments) {
  Problems problems;
  const auto refuse = [&](std::string message) { problems.push_back({{"burin diff"}, std::move(message)}); };
  Request request;
  if (arguments.words().size() == 2) {
    request.first = arguments.words()[0];
    request.second = arguments.words()[1];
  } else {
    refuse(fmt::format("needs two pictures, not {}", arguments.words().size()));
  }
  for (Tolerance& tolerance : request.tolerances) {
    const std::optional<std::string> text = arguments.value(tolerance.option);
    if (!text) continue;
    tolerance.allowed = parse_number(*text);
    if (!tolerance.allowed || *tolerance.allowed < 0.0 || *tolerance.allowed > 255.0) {
      refuse(fmt::format("--{} must be a number from 0 to 255, not '{}'", tolerance.option, *text));
    }
  }
  request.out = arguments.value("out");
  request.json = arguments.has("json");
  request.quiet = arguments.has("quiet");
  if (!problems.empty()) return problems;
  return request;
}

/// The options whose limits are passed; without limits every difference counts, told as "".
std::vector<std::string> passed_limits(const Request& request, const PictureDifference& difference) {
  const std::array<double, 3> found{static_cast<double>(difference.max), difference.mean, difference.block};
  std::vector<std::string> passed;
  bool any = false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Tolerance& tolerance = request.tolerances[i];
    any = any || tolerance.allowed;
    if (tolerance.allowed && found[i] > *tolerance.allowed) {
      passed.push_back(fmt::format("--{} {}", tolerance.option, shortest_text(*tolerance.allowed)));
    }
  }
  if (!any && !difference.is_none()) passed.emplace_back();
  return passed;
}

std::string json_of(const PictureDifference& d, const data::Image& picture, bool equal) {
  JsonObject json;
  json.add("equal", equal);
  json.add("width", picture.width);
  json.add("height", picture.height);
  json.add("pixels", d.pixels);
  json.add("max", d.max);
  json.add_json("max_at", fmt::format("[{}, {}]", d.max_at.x, d.max_at.y));
  json.add("mean", d.mean);
  json.add("mean_on_ink", d.mean_on_ink);
  json.add("block", d.block);
  json.add_json("block_at", fmt::format("[{}, {}]", d.block_at.x, d.block_at.y));
  json.add_json("ink", fmt::format("[{}, {}]", shortest_text(d.ink_of_first), shortest_text(d.ink_of_second)));
  return json.text() + '\n';
}

std::string text_of(const Request& request, const PictureDifference& d, const data::Image& picture,
                    const std::vector<std::string>& passed) {
  const std::string ink =
      fmt::format("  ink    {:.2f} % and {:.2f} % of the page\n", 100.0 * d.ink_of_first, 100.0 * d.ink_of_second);
  if (d.is_none()) return fmt::format("{} and {} are equal\n{}", request.first, request.second, ink);
  std::string verdict = passed.empty() ? ", within the limits" : "";
  for (const std::string& limit : passed) {
    if (!limit.empty()) verdict += fmt::format("{} {}", verdict.empty() ? ", beyond" : " and", limit);
  }
  const std::string numbers =
      fmt::format("  max    {} of 255 at {},{}\n  mean   {:.3g}; where there is ink {:.3g}\n  block  {:.3g} at {},{}\n",
                  d.max, d.max_at.x, d.max_at.y, d.mean, d.mean_on_ink, d.block, d.block_at.x, d.block_at.y);
  return fmt::format("{} and {} differ in {} of {} pixels{}\n{}{}", request.first, request.second, d.pixels,
                     picture.rgba.size() / 4, verdict, numbers, ink);
}

Result<Done> write_picture(const std::string& path, const data::Image& first, const data::Image& second) {
  const std::optional<std::string> png = png_of(difference_picture(first, second));
  if (!png) return Problem{{path}, "no memory is left for the picture of the difference", Trouble::limit};
  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  return write_file(path, *png, temporaries, interrupt.stop());
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<Request> request = read_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin diff");
  const Result<data::Image> first = read_picture(request->first);
  if (!first) return console.fail(first.problems());
  const Result<data::Image> second = read_picture(request->second);
  if (!second) return console.fail(second.problems());
  if (first->width != second->width || first->height != second->height) {
    return console.fail(
        {Problem{{request->second},
                 fmt::format("has {} x {} pixels and {} has {} x {}; only pictures of one size can be "
                             "compared, draw both with the same --size",
                             second->width, second->height, request->first, first->width, first->height)}});
  }
  const PictureDifference difference = measure::picture_difference(*first, *second);
  const std::vector<std::string> passed = passed_limits(*request, difference);
  if (request->out) {
    const Result<Done> written = write_picture(*request->out, *first, *second);
    if (!written) return console.fail(written.problems());
  }
  if (!request->quiet) {
    const ExitCode printed = console.print(request->json ? json_of(difference, *first, passed.empty())
                                                         : text_of(*request, difference, *first, passed));
    if (printed != ExitCode::done) return printed;
  }
  return passed.empty() ? ExitCode::done : ExitCode::different;
}

}  // namespace

Command diff_command() {
  return {
      "diff",
      "compare two pictures pixel by pixel",
      "A.png B.png [-o FILE] [--max N] [--mean N] [--block N]",
      "Reads PNG of any kind. Pixels are compared as they are stored, in sRGB of 8 bits: the colours multiplied by "
      "their alpha, and the alpha. A pixel's difference is that of its worst channel, of 255.\n\n"
      "Told are the largest difference and where it is; the mean over all pixels, and over those that are ink in "
      "either picture; the largest difference between the mean colours of two 4 x 4 blocks, in which moved lines show "
      "and the noise of edges cancels out; and the share of ink, that is of pixels of another colour than the most "
      "frequent one.\n\n"
      "Without limits every difference counts. With some of --max, --mean and --block only those count.\n\n"
      "Exit codes: 0 equal or within the limits, 1 different, 2 wrong command line, 3 a picture cannot be read or the "
      "sizes differ, 4 too large, 5 FILE cannot be written.",
      option_rows,
      examples,
      &run};
}

}  // namespace burin::cli
