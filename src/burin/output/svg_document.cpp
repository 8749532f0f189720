#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/base/xml_text.hpp>
#include <burin/output/svg_document.hpp>

namespace burin::output {

namespace {

/// Lengths of the page and the style: a nanometre is enough for any pen.
std::string length_text(double mm) {
  return fixed_text(mm, 6);
}

/// What drawing programs show as the document's properties, and the origin to draw it again from.
std::string metadata_text(const Origin& origin) {
  std::string xml = "<metadata>\n<rdf:RDF>\n<cc:Work rdf:about=\"\">\n<dc:format>image/svg+xml</dc:format>\n";
  if (!origin.title.empty()) xml += fmt::format("<dc:title>{}</dc:title>\n", xml_text(origin.title));
  if (!origin.author.empty()) {
    xml +=
        fmt::format("<dc:creator><cc:Agent><dc:title>{}</dc:title></cc:Agent></dc:creator>\n", xml_text(origin.author));
  }
  if (!origin.summary.empty()) {
    xml += fmt::format("<dc:description>{}</dc:description>\n", xml_text(origin.summary));
  }
  xml += "</cc:Work>\n</rdf:RDF>\n";
  if (!origin.record.empty()) {
    xml += fmt::format("<burin:origin xml:space=\"preserve\">{}</burin:origin>\n", xml_exact_text(origin.record));
  }
  return xml + "</metadata>\n";
}

std::string paper_text(const Page& page) {
  return fmt::format("<g id=\"paper\"><rect x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{2}\" fill=\"{3}\"/></g>\n",
                     length_text(-page.bleed_mm), length_text(page.width_mm + 2.0 * page.bleed_mm),
                     length_text(page.height_mm + 2.0 * page.bleed_mm), colour_text(page.paper));
}

const char* rule_text(Paint paint) {
  return paint == Paint::fill_evenodd ? "evenodd" : "nonzero";
}

std::string paint_text(Paint paint, Colour colour) {
  if (paint == Paint::stroke) return fmt::format(" fill=\"none\" stroke=\"{}\"", colour_text(colour));
  return fmt::format(" fill=\"{}\" fill-rule=\"{}\" stroke=\"none\"", colour_text(colour), rule_text(paint));
}

std::string ends_and_corners_text(const SheetLayer& layer) {
  std::string text;
  if (layer.cap != Cap::butt) {
    text += fmt::format(" stroke-linecap=\"{}\"", layer.cap == Cap::round ? "round" : "square");
  }
  if (layer.join != Join::miter) {
    text += fmt::format(" stroke-linejoin=\"{}\"", layer.join == Join::round ? "round" : "bevel");
  } else {
    text += fmt::format(" stroke-miterlimit=\"{}\"", length_text(layer.miter_limit));
  }
  return text;
}

std::string dashes_text(const SheetLayer& layer) {
  if (layer.dashes_mm.empty()) return {};
  std::string text = " stroke-dasharray=\"";
  for (std::size_t i = 0; i < layer.dashes_mm.size(); ++i) {
    if (i > 0) text += ' ';
    text += length_text(layer.dashes_mm[i]);
  }
  text += '"';
  if (layer.dash_offset_mm != 0.0) {
    text += fmt::format(" stroke-dashoffset=\"{}\"", length_text(layer.dash_offset_mm));
  }
  return text;
}

}  // namespace

std::string svg_head(const Sheet& sheet, const OutputOptions& options) {
  const std::string width = length_text(sheet.page.width_mm);
  const std::string height = length_text(sheet.page.height_mm);
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""
      " xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" xmlns:cc=\"http://creativecommons.org/ns#\""
      " xmlns:dc=\"http://purl.org/dc/elements/1.1/\" xmlns:burin=\"urn:x-burin:origin\"{2}"
      " width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n",
      width, height, options.defs ? " xmlns:xlink=\"http://www.w3.org/1999/xlink\"" : "");
  const Origin& origin = sheet.made_by;
  if (!origin.title.empty()) xml += fmt::format("<title>{}</title>\n", xml_text(origin.title));
  if (!origin.summary.empty()) xml += fmt::format("<desc>{}</desc>\n", xml_text(origin.summary));
  xml += metadata_text(origin);
  if (options.paper) xml += paper_text(sheet.page);
  return xml;
}

std::string svg_layer_begin(const Sheet& sheet, std::size_t layer, bool empty) {
  const SheetLayer& style = sheet.layers[layer];
  const Pen& pen = sheet.pens[style.pen];
  std::string xml = fmt::format("<g inkscape:groupmode=\"layer\" inkscape:label=\"{}\" id=\"layer{}\"",
                                xml_text(layer_label(sheet, layer)), layer + 1);
  xml += paint_text(style.paint, pen.colour);
  xml += fmt::format(" stroke-width=\"{}\"", length_text(pen.width_mm));
  xml += ends_and_corners_text(style) + dashes_text(style);
  if (style.opacity != 1.0) xml += fmt::format(" opacity=\"{}\"", length_text(style.opacity));
  return xml + (empty ? "/>\n" : ">\n");
}

std::string svg_path_begin(const Sheet& sheet, const PathHead& head) {
  const SheetLayer& style = sheet.layers[head.layer];
  std::string xml = "<path";
  if (head.paint != style.paint) xml += paint_text(head.paint, sheet.pens[style.pen].colour);
  return xml + " d=\"";
}

}  // namespace burin::output
