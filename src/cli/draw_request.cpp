#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <burin/base/number_text.hpp>
#include <burin/base/units.hpp>
#include <cli/draw_request.hpp>
#include <cli/formats.hpp>
#include <cli/output_target.hpp>
#include <cli/pen_sets.hpp>

namespace burin::cli {

namespace {

constexpr std::array option_rows{
    OptionRow{"output", 'o', "FILE",
              "write here, in the format of the suffix; - is stdout; {seed} and the like are filled in", true},
    OptionRow{"knob", 'D', "NAME=VALUE", "turn a knob of the preset; 'burin show PRESET' lists them", true},
    OptionRow{"set", 0, "KEY=VALUE", "set any key: page.paper=oat, layer.NAME.opacity=0.5", true},
    OptionRow{"pens", 0, "NAME", "draw with the pens of this set in ~/.config/burin/pens.toml, by their names", true},
    OptionRow{"seed", 0, "SEEDS", "seed of everything random: 7, random; or several: 0..49, 7,19,33, random*5"},
    OptionRow{"sweep", 0, "KNOB=VALUES", "a result for each value: levels=1..5, turn=0.1..0.9:9, motif=koch,levy",
              true},
    OptionRow{"page", 0, "SIZE", "a4, a3, letter ... or 30x40cm"},
    OptionRow{"landscape", 0, "", "turn the page on its side"},
    OptionRow{"enlarge", 0, "SIZE", "scale the finished page to fit this one, up or down: pens and margins too"},
    OptionRow{"margin", 0, "LENGTHS", "one to four lengths, clockwise from the top: \"20mm 15mm\""},
    OptionRow{"view", 0, "X,Y,WIDTH", "blow up a part of the page: its centre and width in mm; pens keep their widths"},
    OptionRow{"format", 0, "FORMAT", "write this format, whatever the suffix says"},
    OptionRow{"backend", 0, "NAME", "native or cairo; 'burin list formats' shows who writes what"},
    OptionRow{"dpi", 0, "N", "PNG: dots per inch (300)"},
    OptionRow{"size", 0, "Npx", "PNG: dots along the longer side, instead of --dpi"},
    OptionRow{"decimals", 0, "N", "SVG and native PDF: places after the point of a mm, 0 to 6 (3)"},
    OptionRow{"paper", 0, "", "SVG, PDF: draw the paper's colour too, as PNG always does"},
    OptionRow{"defs", 0, "",
              "native SVG: write each figure once and <use> it, for drawing programs rather than plotters"},
    OptionRow{"only", 0, "LAYER", "draw this layer only", true},
    OptionRow{"skip", 0, "LAYER", "leave this layer out", true},
    OptionRow{"all-points", 0, "", "draw points that the output is too coarse to show, too"},
    OptionRow{"max-points", 0, "N", "refuse to draw more points than this (5e7)"},
    OptionRow{"max-memory", 0, "MB", "refuse to draw what needs more memory than this (2000)"},
    OptionRow{"max-results", 0, "N", "refuse to draw more results of --seed and --sweep than this (10000)"},
    OptionRow{"threads", 0, "N", "so many threads: for results, or one large PNG (all cores); the files are the same"},
    OptionRow{"quiet", 'q', "", "errors only"},
    OptionRow{"verbose", 'v', "", "tell more: layers, data files"},
};

/// Reads the options one after another and collects what is wrong with them.
class Reader {
 public:
  Reader(const Arguments& arguments, std::string command) : arguments_(arguments), command_(std::move(command)) {}

  template <class... Words>
  void report(fmt::format_string<Words...> format, Words&&... words) {
    problems_.push_back({{command_}, fmt::format(format, std::forward<Words>(words)...)});
  }

  void read_preset_word(DrawRequest& request) {
    const std::vector<std::string>& words = arguments_.words();
    if (words.empty()) {
      report("say what to draw: a preset's name or file, or - for stdin; 'burin list' shows the presets");
    } else if (words.size() > 1) {
      report("one preset at a time, not {}: '{}'", words.size(), fmt::join(words, "', '"));
    } else {
      request.preset = words.front();
    }
  }

  void number(std::string_view option, double low, double high, bool whole, double& target) {
    const std::optional<std::string> text = arguments_.value(option);
    if (!text) return;
    const std::optional<double> number = parse_number(*text);
    if (!number || *number < low || *number > high || (whole && *number != std::floor(*number))) {
      report("--{} must be a {}number from {} to {}, not '{}'", option, whole ? "whole " : "", shortest_text(low),
             shortest_text(high), *text);
      return;
    }
    target = *number;
  }

  void read_view(DrawRequest& request) {
    const std::optional<std::string> text = arguments_.value("view");
    if (!text) return;
    std::vector<double> numbers;
    for (std::string_view rest = *text; numbers.size() < 4;) {
      const std::size_t comma = rest.find(',');
      const std::optional<double> number = parse_number(rest.substr(0, comma));
      numbers.push_back(number ? *number : std::numeric_limits<double>::quiet_NaN());
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    constexpr double farthest_mm = 1e6;
    const bool good = numbers.size() == 3 && std::abs(numbers[0]) <= farthest_mm &&
                      std::abs(numbers[1]) <= farthest_mm && numbers[2] > 0.0 && numbers[2] <= farthest_mm;
    if (!good) {
      report("--view must be the centre and the width of a part of the page in mm such as 105,148.5,20, not '{}'",
             *text);
      return;
    }
    request.view = preset::PageWindow{{numbers[0], numbers[1]}, numbers[2]};
    request.view_text = *text;
  }

  void read_size(DrawRequest& request) {
    std::optional<std::string> text = arguments_.value("size");
    if (!text) return;
    if (arguments_.has("dpi")) report("--dpi and --size both set the resolution; give one of them");
    const std::string written = *text;
    if (text->size() > 2 && text->substr(text->size() - 2) == "px") text->resize(text->size() - 2);
    const std::optional<double> pixels = parse_number(*text);
    if (!pixels || *pixels < 1.0 || *pixels > 1e6 || *pixels != std::floor(*pixels)) {
      report("--size must be a whole number of dots from 1 to 1000000 such as 2000px, not '{}'", written);
      return;
    }
    request.longer_side_px = *pixels;
  }

  std::vector<std::pair<std::string, std::string>> pairs(std::string_view option, std::string_view shown) {
    std::vector<std::pair<std::string, std::string>> all;
    for (const std::string& text : arguments_.values(option)) {
      const std::size_t equals = text.find('=');
      if (equals == std::string::npos || equals == 0) {
        report("{} needs a name and a value: {} name=value, not '{}'", shown, shown, text);
      } else {
        all.emplace_back(text.substr(0, equals), text.substr(equals + 1));
      }
    }
    return all;
  }

  void read_pens(DrawRequest& request) {
    for (const std::string& word : arguments_.values("pens")) {
      const Result<PenKeys> keys = read_pens_option(word);
      if (keys) {
        request.overrides.pens.insert(request.overrides.pens.end(), keys->begin(), keys->end());
      } else {
        problems_.insert(problems_.end(), keys.problems().begin(), keys.problems().end());
      }
    }
  }

  void read_series(DrawRequest& request) {
    if (const std::optional<std::string> text = arguments_.value("seed")) {
      const Result<SeedList> seeds = SeedList::read(*text);
      if (!seeds) {
        report("{}", seeds.problems().front().message);
      } else if (seeds->count() == 1.0) {
        request.overrides.seed = seeds->all().front();
      } else {
        request.series.seeds.push_back(*seeds);
      }
    }
    for (const std::string& text : arguments_.values("sweep")) {
      const Result<Sweep> sweep = Sweep::read(text);
      if (sweep) {
        request.series.sweeps.push_back(*sweep);
      } else {
        report("{}", sweep.problems().front().message);
      }
    }
    number("max-results", 1.0, 1e6, true, request.series.max_results);
    double threads = request.threads;
    number("threads", 1.0, 1024.0, true, threads);
    request.threads = static_cast<int>(threads);
  }

  /// Whether two output paths, perhaps of files that are not there yet, name one file.
  static bool same_file(const std::string& a, const std::string& b) {
    std::error_code failed_a;
    std::error_code failed_b;
    return a == b || (std::filesystem::weakly_canonical(std::filesystem::absolute(a, failed_a), failed_a) ==
                          std::filesystem::weakly_canonical(std::filesystem::absolute(b, failed_b), failed_b) &&
                      !failed_a && !failed_b);
  }

  void read_outputs(DrawRequest& request, const PreferredBackEnd& preferred) {
    const std::optional<std::string> format = arguments_.value("format");
    const std::optional<std::string> typed_back_end = arguments_.value("backend");
    const auto back_end = [&](const std::string& name) {
      return typed_back_end || preferred.format != name ? typed_back_end : preferred.back_end;
    };
    std::vector<std::string> paths = arguments_.values("output");
    if (std::find(paths.begin(), paths.end(), "") != paths.end()) report("-o needs the name of a file, not ''");
    if (paths.empty()) paths.emplace_back();
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const std::string& path = paths[i];
      const auto earlier = paths.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::any_of(paths.begin(), earlier, [&](const std::string& other) { return same_file(other, path); })) {
        report("-o {} is given twice", path);
        continue;
      }
      const bool suffix_tells = !format && !path.empty() && !named_descriptor(path);
      const Result<std::string> name = suffix_tells ? format_of_suffix(path) : format.value_or("svg");
      const Result<const BackEnd*> writer =
          name ? choose_back_end(*name, back_end(*name)) : Result<const BackEnd*>(name.problems());
      if (writer) {
        request.outputs.push_back({path, *writer});
      } else {
        problems_.insert(problems_.end(), writer.problems().begin(), writer.problems().end());
      }
    }
    if (problems_.empty()) refuse_idle_options(request);
  }

  Result<DrawRequest> result(DrawRequest request) {
    if (!problems_.empty()) return std::move(problems_);
    return request;
  }

 private:
  /// An option that no output looks at is a misunderstanding.
  void refuse_idle_options(const DrawRequest& request) {
    for (const FormatOption& row : format_options()) {
      const bool used = std::any_of(request.outputs.begin(), request.outputs.end(), [&](const RequestedOutput& output) {
        return uses_option(*output.back_end, row.option);
      });
      if (arguments_.has(row.option) && !used) {
        report("--{} is for {}{}, and no such output is asked for; add -o NAME.{}", row.option,
               fmt::join(row.formats, " and "),
               row.back_end.empty() ? "" : fmt::format(" of --backend {}", row.back_end), row.formats.front());
      }
    }
  }

  const Arguments& arguments_;
  std::string command_;
  Problems problems_;
};

}  // namespace

bool DrawRequest::writes_stdout() const {
  return std::any_of(outputs.begin(), outputs.end(),
                     [](const RequestedOutput& output) { return output.path == "-" || output.path == "/dev/stdout"; });
}

std::span<const OptionRow> draw_options() {
  return option_rows;
}

Result<DrawRequest> read_draw_request(const Arguments& arguments, const std::string& command,
                                      const PreferredBackEnd& preferred) {
  Reader reader(arguments, command);
  DrawRequest request;
  request.command = command;
  reader.read_preset_word(request);
  request.overrides.knobs = reader.pairs("knob", "-D");
  request.overrides.keys = reader.pairs("set", "--set");
  reader.read_pens(request);
  reader.read_series(request);
  request.overrides.page_size = arguments.value("page");
  request.overrides.landscape = arguments.has("landscape");
  request.overrides.margin = arguments.value("margin");
  request.overrides.enlarge = arguments.value("enlarge");
  double decimals = request.decimals;
  reader.number("decimals", 0.0, 6.0, true, decimals);
  request.decimals = static_cast<int>(decimals);
  reader.number("dpi", 1.0, 10000.0, false, request.dots_per_inch);
  reader.number("max-points", 1.0, 1e18, false, request.max_points);
  reader.number("max-memory", 1.0, 1e12, false, request.max_memory_mb);
  reader.read_size(request);
  reader.read_view(request);
  request.paper = arguments.has("paper");
  request.defs = arguments.has("defs");
  request.all_points = arguments.has("all-points");
  request.only = arguments.values("only");
  request.skip = arguments.values("skip");
  request.quiet = arguments.has("quiet");
  request.verbose = arguments.has("verbose");
  reader.read_outputs(request, preferred);
  return reader.result(std::move(request));
}

OutputOptions output_options(const DrawRequest& request, const Page& page) {
  OutputOptions options;
  options.decimals = request.decimals;
  options.paper = request.paper;
  options.defs = request.defs;
  options.dots_per_mm = request.longer_side_px ? *request.longer_side_px / std::max(page.width_mm, page.height_mm)
                                               : request.dots_per_inch / mm_per_inch;
  return options;
}

}  // namespace burin::cli
