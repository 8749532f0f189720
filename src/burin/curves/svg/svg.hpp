#pragma once

#include <array>
#include <memory>
#include <string>

#include <burin/curves/family.hpp>
#include <burin/data/svg/paths.hpp>
#include <burin/path/recording.hpp>

namespace burin::curves {

/// An SVG file of a preset, as read.
struct SvgFile {
  std::string name;
  std::shared_ptr<const data::SvgDrawing> drawing;  ///< null: none
};

/// A drawing from an SVG file. Model units: millimetres of the file's own page, y up, its lower left corner at the
/// origin.
struct SvgParams {
  SvgFile file;
  data::SvgParts parts = data::SvgParts::all;
  bool partial = false;

  static constexpr auto fields() {
    return std::tuple{
        params::field("file", &SvgParams::file, "the SVG, relative to the preset"),
        params::field(
            "parts", &SvgParams::parts,
            "all: areas where the SVG fills and lines where it strokes, with the layer's pen; its fills or its "
            "strokes only; outlines: every contour once as a line"),
        params::field(
            "partial", &SvgParams::partial,
            "leave out what cannot be drawn (text, pictures, gradients, clip paths ...) instead of refusing the "
            "file")};
  }
};

/// The family's row in the catalogue.
Family svg_family();

}  // namespace burin::curves

namespace burin::data {
constexpr auto words(SvgParts) {
  return std::array<params::Word<SvgParts>, 4>{{{"all", SvgParts::all},
                                                {"fills", SvgParts::fills},
                                                {"strokes", SvgParts::strokes},
                                                {"outlines", SvgParts::outlines}}};
}
}  // namespace burin::data

template <>
struct burin::params::ValueType<burin::curves::SvgFile> {
  static std::string name() { return "file name"; }
  static bool read(const Value& value, burin::curves::SvgFile& file, ReadContext& context);
  static std::string text(const burin::curves::SvgFile& file) { return file.name; }
};
