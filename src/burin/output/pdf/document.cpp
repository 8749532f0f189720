#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/output/pdf/colour_operators.hpp>
#include <burin/output/pdf/document.hpp>
#include <burin/output/pdf/metadata.hpp>
#include <burin/output/pdf/page.hpp>
#include <burin/output/pdf/text.hpp>

namespace burin::output::pdf {

namespace {

std::string references(const std::vector<ObjectId>& ids) {
  std::string text = "[";
  for (const ObjectId id : ids) text += (text.size() > 1 ? " " : "") + reference(id);
  return text + ']';
}

/// All layers are shown; programs list them in the order of drawing.
std::string catalog(ObjectId pages, ObjectId metadata, const std::vector<ObjectId>& layers) {
  const std::string list = references(layers);
  return fmt::format("<</Type/Catalog/Pages {}/Metadata {}\n/OCProperties<</OCGs{}/D<</Name(Layers)/Order{}/ON{}>>>>>>",
                     reference(pages), reference(metadata), list, list, list);
}

/// Where transparent colours are mixed.
std::string blending_space(const Sheet& sheet) {
  const bool inks = std::any_of(sheet.pens.begin(), sheet.pens.end(), [](const Pen& pen) { return pen.cmyk; });
  return inks ? "/DeviceCMYK" : "/DeviceRGB";
}

std::string form_entries(std::string_view box) {
  return fmt::format("/Type/XObject/Subtype/Form/BBox[{}]", box);
}

/// Ten times as far as a figure reaches: no stroke of it is cut off.
constexpr std::string_view figure_box = "-10000000 -10000000 10000000 10000000";

}  // namespace

std::string layer_begin(std::size_t layer) {
  return fmt::format("/OC/L{} BDC\nq\n", layer);
}

std::string layer_end() {
  return "Q\nEMC\n";
}

void Document::add_chunk(std::string_view operators) {
  if (operators.empty()) return;
  const ObjectId id = file_.reserve();
  (group_box_.empty() ? page_chunks_ : group_chunks_).push_back(id);
  if (group_box_.empty()) {
    file_.stream(id, {}, operators);
  } else {
    file_.stream(id, form_entries(group_box_) + fmt::format("/Resources<</XObject<<{}>>>>", figure_names()), operators);
  }
}

void Document::add_figure(std::string_view operators) {
  figures_.push_back(file_.reserve());
  file_.stream(figures_.back(), form_entries(figure_box) + "/Resources<<>>", operators);
}

std::string Document::figure_names() const {
  std::string names;
  for (std::size_t i = 0; i < figures_.size(); ++i) names += fmt::format("/F{} {}\n", i, reference(figures_[i]));
  return names;
}

void Document::begin_group(double unit_mm) {
  BURIN_EXPECT(group_box_.empty());
  group_box_ = ink_box(sheet_.page, unit_mm);
}

std::string Document::end_group(double opacity) {
  std::string chunks;
  std::string operators;
  for (std::size_t i = 0; i < group_chunks_.size(); ++i) {
    chunks += fmt::format("/C{} {}\n", i, reference(group_chunks_[i]));
    operators += fmt::format("/C{} Do\n", i);
  }
  const ObjectId id = file_.reserve();
  file_.stream(id,
               form_entries(group_box_) + fmt::format("/Group<</S/Transparency/CS{}>>/Resources<</XObject<<{}>>>>",
                                                      blending_space(sheet_), chunks),
               operators);
  group_chunks_.clear();
  group_box_.clear();
  groups_.push_back({id, opacity});
  return fmt::format("/A{0} gs /G{0} Do\n", groups_.size() - 1);
}

std::string Document::resources() const {
  std::string spaces = sheet_.page.bleed_mm > 0.0 ? "/Marks" + crop_mark_space() + '\n' : std::string();
  for (std::size_t i = 0; i < sheet_.pens.size(); ++i) {
    if (!sheet_.pens[i].spot.empty()) spaces += fmt::format("/S{}{}\n", i, spot_space(sheet_.pens[i]));
  }
  std::string states;
  std::string forms = figure_names();
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    states += fmt::format("/A{0}<</ca {1}/CA {1}>>", i, number_text(groups_[i].opacity));
    forms += fmt::format("/G{} {}\n", i, reference(groups_[i].form));
  }
  return fmt::format("/ColorSpace<<{}>>/ExtGState<<{}>>/XObject<<{}>>", spaces, states, forms);
}

Result<Done> Document::finish() {
  std::vector<ObjectId> layers;
  std::string properties;
  for (std::size_t i = 0; i < sheet_.layers.size(); ++i) {
    layers.push_back(file_.reserve());
    file_.object(layers.back(), fmt::format("<</Type/OCG/Name{}>>", text_string(layer_label(sheet_, i))));
    properties += fmt::format("/L{} {}\n", i, reference(layers.back()));
  }
  const ObjectId pages = file_.reserve();
  const ObjectId page = file_.reserve();
  file_.object(pages, fmt::format("<</Type/Pages/Count 1/Kids[{}]>>", reference(page)));
  std::string entries =
      fmt::format("<</Type/Page/Parent {}{}\n/Contents{}\n/Resources<<{}/Properties<<{}>>>>", reference(pages),
                  page_boxes(sheet_.page), references(page_chunks_), resources(), properties);
  if (!groups_.empty()) entries += fmt::format("/Group<</S/Transparency/CS{}>>", blending_space(sheet_));
  file_.object(page, entries + ">>");
  const ObjectId metadata = file_.reserve();
  file_.plain_stream(metadata, "/Type/Metadata/Subtype/XML", xmp_packet(sheet_.made_by));
  const ObjectId info = file_.reserve();
  file_.object(info, info_dictionary(sheet_.made_by));
  const ObjectId root = file_.reserve();
  file_.object(root, catalog(pages, metadata, layers));
  return file_.finish(root, info, file_identifier(sheet_.made_by));
}

}  // namespace burin::output::pdf
