#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <burin/base/math.hpp>
#include <burin/data/image.hpp>
#include <burin/data/jpeg.hpp>
#include <burin/preset/images.hpp>
#include <burin/primitives/position.hpp>

namespace burin::preset {

namespace {

using params::Entry;
using params::ReadContext;
using params::Table;
using params::Value;

/// Luma (Rec. ITU-R BT.709) of what the picture shows on white paper.
float brightness(const std::uint8_t* rgba, double gamma) {
  const double luma = (0.2126 * rgba[0] + 0.7152 * rgba[1] + 0.0722 * rgba[2]) / 255.0;
  const double alpha = rgba[3] / 255.0;
  const double shown = std::clamp(alpha * luma + (1.0 - alpha), 0.0, 1.0);
  return static_cast<float>(gamma == 1.0 ? shown : math::pow(shown, gamma));
}

/// The means over windows of 2 radius + 1 values, `stride` apart; the ends go on as they are.
void box_blur(float* values, int count, std::size_t stride, int radius, std::vector<float>& line) {
  line.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = values[static_cast<std::size_t>(i) * stride];
  const auto value = [&](int i) -> double { return line[static_cast<std::size_t>(std::clamp(i, 0, count - 1))]; };
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) sum += value(i);
  for (int i = 0; i < count; ++i) {
    values[static_cast<std::size_t>(i) * stride] = static_cast<float>(sum / (2 * radius + 1));
    sum += value(i + radius + 1) - value(i - radius);
  }
}

/// Three boxes are almost a Gaussian of standard deviation `radius`.
void blur(GreyImage& image, int radius) {
  constexpr int passes = 3;
  std::vector<float> line;
  for (int pass = 0; pass < passes; ++pass) {
    const auto width = static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y) {
      box_blur(&image.values[static_cast<std::size_t>(y) * width], image.width, 1, radius, line);
    }
    for (int x = 0; x < image.width; ++x) {
      box_blur(&image.values[static_cast<std::size_t>(x)], image.height, width, radius, line);
    }
  }
}

GreyImage grey_image(const data::Image& image, const ImageSpec& spec) {
  GreyImage grey{image.width, image.height, {}};
  grey.values.reserve(image.rgba.size() / 4);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) grey.values.push_back(brightness(image.pixel(x, y), spec.gamma));
  }
  const auto radius = static_cast<int>(std::lround(spec.blur / 100.0 * std::max(image.width, image.height)));
  if (radius > 0) blur(grey, radius);
  return grey;
}

bool is_function_name(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return is_letter(name.front()) &&
         std::ranges::all_of(name, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); }) &&
         std::ranges::find(primitives::position_variables, name) == primitives::position_variables.end();
}

std::shared_ptr<const GreyImage> read_image(const Value& value, const ImageSpec& spec, ReadContext& context) {
  if (spec.file.empty()) {
    context.report(value.where, "an image needs a 'file': { file = \"face.png\" }");
    return nullptr;
  }
  const auto report = [&](const Problems& problems) {
    for (const Problem& problem : problems)
      context.problems.push_back({value.where, problem.message, problem.trouble, {}});
  };
  const Result<std::string> bytes = context.read_file(spec.file);
  if (!bytes) {
    report(bytes.problems());
    return nullptr;
  }
  const bool is_jpeg = bytes->starts_with("\xFF\xD8");
  const Result<data::Image> image = is_jpeg ? data::read_jpeg(*bytes, spec.file) : data::read_png(*bytes, spec.file);
  if (!image) {
    report(image.problems());
    return nullptr;
  }
  return std::make_shared<const GreyImage>(grey_image(*image, spec));
}

/// Pixels of the image for u, v of a slot that is `slot_aspect` times as wide as high. Without stretching the middles
/// meet, and one side of the image is as long as the slot's.
struct PixelsFromSlot {
  double x_scale;
  double y_scale;
  bool white_beside;

  PixelsFromSlot(const GreyImage& image, ImageFit fit, double slot_aspect)
      : x_scale(image.width), y_scale(image.height), white_beside(fit == ImageFit::contain) {
    if (fit == ImageFit::stretch) return;
    const double image_aspect = static_cast<double>(image.width) / image.height;
    const bool by_width = (fit == ImageFit::cover) == (slot_aspect > image_aspect);
    if (by_width) {
      y_scale = image.width / slot_aspect;
    } else {
      x_scale = image.height * slot_aspect;
    }
  }
};

}  // namespace

double GreyImage::at(double x, double y) const {
  const auto clamped = [](double place, int size) { return std::clamp(place - 0.5, 0.0, size - 1.0); };
  if (std::isnan(x) || std::isnan(y)) return std::nan("");
  const double cx = clamped(x, width);
  const double cy = clamped(y, height);
  const auto left = static_cast<int>(cx);
  const auto top = static_cast<int>(cy);
  const auto value = [&](int column, int row) -> double {
    return values[static_cast<std::size_t>(std::min(row, height - 1)) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(std::min(column, width - 1))];
  };
  const double above = std::lerp(value(left, top), value(left + 1, top), cx - left);
  const double below = std::lerp(value(left, top + 1), value(left + 1, top + 1), cx - left);
  return std::lerp(above, below, cy - top);
}

std::vector<NamedImage> read_images(const Table& root, ReadContext& context) {
  std::vector<NamedImage> images;
  const Value* section = root.find("images");
  if (section == nullptr) return images;
  if (section->table() == nullptr) {
    context.report(section->where, fmt::format("'images' is a table: [images], not {}", section->kind_name()));
    return images;
  }
  for (const Entry& entry : section->table()->entries) {
    ImageSpec spec;
    if (!is_function_name(entry.key)) {
      context.report(entry.where, fmt::format("'{}' is no name for an image: letters, digits and _ make one, and no "
                                              "variable of expressions may have it",
                                              entry.key));
    } else if (entry.value.table() == nullptr) {
      context.report(entry.value.where,
                     fmt::format("image '{}' is a table in braces, not {}", entry.key, entry.value.kind_name()));
    } else if (params::read_fields(*entry.value.table(), spec, fmt::format("image '{}'", entry.key), context)) {
      std::shared_ptr<const GreyImage> grey = read_image(entry.value, spec, context);
      if (grey == nullptr) grey = std::make_shared<const GreyImage>();
      images.push_back({entry.key, spec.fit, std::move(grey)});
    }
  }
  return images;
}

std::vector<PlaneFunction> image_functions(const std::vector<NamedImage>& images, const SlotFrame& slot) {
  std::vector<PlaneFunction> functions;
  for (const NamedImage& image : images) {
    const PixelsFromSlot pixels(*image.grey, image.fit, slot.width_mm / slot.height_mm);
    const auto value = [grey = image.grey, pixels](double u, double v) {
      const double x = 0.5 * grey->width + (u - 0.5) * pixels.x_scale;
      const double y = 0.5 * grey->height - (v - 0.5) * pixels.y_scale;
      const bool beside = x < 0.0 || y < 0.0 || x > grey->width || y > grey->height;
      return beside && pixels.white_beside ? 1.0 : grey->at(x, y);
    };
    const auto flow = [value, pixels](double u, double v) {
      // A step is about a hundredth of the picture, and as long to the side as up.
      const double du = 0.01;
      const double dv = du * pixels.x_scale / pixels.y_scale;
      const double to_right = value(u + du, v) - value(u - du, v);
      const double upwards = value(u, v + dv) - value(u, v - dv);
      return math::atan2(to_right, -upwards) * (180.0 / math::pi);
    };
    const auto add = [&](const std::string& name, auto function) {
      functions.push_back({name, std::make_shared<const std::function<double(double, double)>>(std::move(function))});
    };
    add(image.name, value);
    add(image.name + "_flow", flow);
  }
  return functions;
}

}  // namespace burin::preset
