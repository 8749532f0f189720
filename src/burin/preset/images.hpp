#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <burin/base/plane_function.hpp>
#include <burin/params/fields.hpp>
#include <burin/params/read_context.hpp>
#include <burin/preset/slot_layout.hpp>

/// [images]: pictures whose brightness expressions over the place may ask for.
namespace burin::preset {

enum class ImageFit : std::uint8_t { cover, contain, stretch };
constexpr auto words(ImageFit) {
  return std::array<params::Word<ImageFit>, 3>{
      {{"cover", ImageFit::cover}, {"contain", ImageFit::contain}, {"stretch", ImageFit::stretch}}};
}

struct ImageSpec {
  std::string file;
  ImageFit fit = ImageFit::cover;
  double gamma = 1.0;
  double blur = 0.0;

  static constexpr auto fields() {
    return std::tuple{
        params::field("file", &ImageSpec::file, "a PNG, beside the preset"),
        params::field(
            "fit", &ImageSpec::fit,
            "how it lies in a slot of another shape: cut off to cover it, whole with white beside, distorted"),
        params::field("gamma", &ImageSpec::gamma, {0.0, 100.0, true, false},
                      "exponent of its brightness: above 1 darker, below 1 brighter"),
        params::field("blur", &ImageSpec::blur, {0.0, 100.0}, "softened over so many percent of its longer side")};
  }
};

/// Brightness from 0 (black) to 1 (white), row by row from the top.
struct GreyImage {
  int width = 1;
  int height = 1;
  std::vector<float> values{1.0F};

  /// Between the middles of pixels, bilinear; beyond the border as on it. x and y in pixels from the top left corner.
  double at(double x, double y) const;
};

struct NamedImage {
  std::string name;
  ImageFit fit = ImageFit::cover;
  std::shared_ptr<const GreyImage> grey;
};

/// In file order; reads the files.
std::vector<NamedImage> read_images(const params::Table& root, params::ReadContext& context);

/// Each image as NAME(u, v) over a slot: u from its left to its right side, v from its foot to its head, 0 to 1; and
/// NAME_flow(u, v), in degrees from u's axis towards v's: the way along which the brightness does not change, darker to
/// the left; 0 where it changes nowhere.
std::vector<PlaneFunction> image_functions(const std::vector<NamedImage>& images, const SlotFrame& slot);

}  // namespace burin::preset
