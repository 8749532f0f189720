#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/data/svg/drawing.hpp>

namespace burin::data {
namespace {

std::string svg(const std::string& body, const std::string& attributes = "viewBox='0 0 100 100'") {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='x' " + attributes + ">" + body + "</svg>";
}

SvgDrawing read(const std::string& text) {
  Result<SvgDrawing> drawing = read_svg(text, "a.svg", 1e-4);
  EXPECT_TRUE(drawing.ok()) << problems_text(drawing.problems());
  return drawing ? *drawing : SvgDrawing{};
}

/// The drawing, of which everything can be drawn.
SvgDrawing whole(const std::string& text) {
  SvgDrawing drawing = read(text);
  EXPECT_EQ(problems_text(drawing.not_drawn), "");
  return drawing;
}

void expect_box(const SvgDrawing& drawing, Vec2 low, Vec2 high) {
  const Box2 box = drawing.box();
  EXPECT_NEAR(box.low.x, low.x, 1e-9);
  EXPECT_NEAR(box.low.y, low.y, 1e-9);
  EXPECT_NEAR(box.high.x, high.x, 1e-9);
  EXPECT_NEAR(box.high.y, high.y, 1e-9);
}

/// What is not drawn, or why nothing is.
std::string complaint(const std::string& text) {
  const Result<SvgDrawing> drawing = read_svg(text, "a.svg", 1e-4);
  return problems_text(drawing ? drawing->not_drawn : drawing.problems());
}

void expect_complaint(const std::string& text, const std::string& words) {
  EXPECT_NE(complaint(text).find(words), std::string::npos) << complaint(text);
}

TEST(Svg, BasicShapes) {
  expect_box(whole(svg("<rect x='10' y='20' width='30' height='40'/>")), {10, 20}, {40, 60});
  expect_box(whole(svg("<circle cx='50' cy='40' r='10'/>")), {40, 30}, {60, 50});
  expect_box(whole(svg("<ellipse cx='50' cy='40' rx='10' ry='5'/>")), {40, 35}, {60, 45});
  expect_box(whole(svg("<line x1='1' y1='2' x2='3' y2='5' stroke='red'/>")), {1, 2}, {3, 5});
  expect_box(whole(svg("<polyline points='1,2 3,4,5 6' stroke='red'/>")), {1, 2}, {5, 6});
  expect_box(whole(svg("<polygon points='1,2 3,4 5 1'/>")), {1, 1}, {5, 4});
  expect_box(whole(svg("<path d='M1 2h3v4z'/>")), {1, 2}, {4, 6});
  expect_box(whole(svg("<rect width='50%' height='25%'/>")), {0, 0}, {50, 25});
  EXPECT_TRUE(whole(svg("<rect width='0' height='5'/><circle r='0'/><line stroke='none' x2='5'/>")).shapes.empty());
}

TEST(Svg, RoundedRectangles) {
  const SvgDrawing drawing = whole(svg("<rect x='10' y='10' width='40' height='20' rx='5'/>"));
  expect_box(drawing, {10, 10}, {50, 30});
  double area = 0.0;
  const std::vector<Vec2>& p = drawing.shapes.at(0).subpaths.at(0).points;
  for (std::size_t i = 0; i < p.size(); ++i) area += 0.5 * cross(p[i], p[(i + 1) % p.size()]);
  EXPECT_NEAR(area, 800.0 - (4.0 - 3.141592653589793) * 25.0, 0.1);
  // Radii are cut to half the sides, and one stands for both.
  expect_box(whole(svg("<rect width='40' height='20' ry='50'/>")), {0, 0}, {40, 20});
}

TEST(Svg, TransformsChain) {
  expect_box(
      whole(svg("<g transform='translate(10,20) scale(2)'><rect width='5' height='5' transform='rotate(90)'/></g>")),
      {0, 20}, {10, 30});
  expect_box(whole(svg("<rect width='2' height='2' transform='matrix(1 0 0 -1 5 10)'/>")), {5, 8}, {7, 10});
  expect_box(whole(svg("<rect width='2' height='2' transform='rotate(180 10 10)'/>")), {18, 18}, {20, 20});
  expect_box(whole(svg("<rect width='2' height='2' transform='skewX(45)'/>")), {0, 0}, {4, 2});
  expect_box(whole(svg("<rect width='2' height='2' style='transform: translate(3px, 4px)'/>")), {3, 4}, {5, 6});
  expect_complaint(svg("<rect width='2' height='2' transform='wobble(3)'/>"), "transform 'wobble(3)' is none of SVG's");
}

TEST(Svg, UnitsAndViewBox) {
  const SvgDrawing mm =
      whole(svg("<rect width='210' height='297'/>", "width='210mm' height='297mm' viewBox='0 0 210 297'"));
  expect_box(mm, {0, 0}, {210 * 96 / 25.4, 297 * 96 / 25.4});
  EXPECT_NEAR(mm.size_px.x, 210 * 96 / 25.4, 1e-9);
  expect_box(whole(svg("<rect width='1in' height='72pt'/>", "width='200' height='200'")), {0, 0}, {96, 96});
  // A viewBox of another shape is centred; 'none' stretches, 'slice' covers.
  const std::string wide = "width='200' height='100' viewBox='0 0 10 10' preserveAspectRatio=";
  expect_box(whole(svg("<rect width='10' height='10'/>", wide + "'xMidYMid'")), {50, 0}, {150, 100});
  expect_box(whole(svg("<rect width='10' height='10'/>", wide + "'xMaxYMid meet'")), {100, 0}, {200, 100});
  expect_box(whole(svg("<rect width='10' height='10'/>", wide + "'none'")), {0, 0}, {200, 100});
  expect_box(whole(svg("<rect width='10' height='10'/>", wide + "'xMidYMin slice'")), {0, 0}, {200, 200});
  expect_box(whole(svg("<rect width='1' height='1'/>", "viewBox='-5 -5 10 10' width='100'")), {50, 50}, {60, 60});
}

TEST(Svg, UseSymbolAndNestedSvg) {
  expect_box(whole(svg("<defs><rect id='r' width='2' height='3'/></defs><use href='#r' x='10' y='5'/>")), {10, 5},
             {12, 8});
  expect_box(
      whole(svg("<use xlink:href='#r' transform='scale(2)'/><defs><g id='r'><rect width='2' height='3'/></g></defs>")),
      {0, 0}, {4, 6});
  expect_box(whole(svg("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>"
                       "<use href='#s' x='20' width='40' height='40'/>")),
             {20, 0}, {60, 40});
  expect_box(whole(svg("<svg x='5' y='6' width='20' height='20' viewBox='0 0 2 2'><rect width='1' height='1'/></svg>")),
             {5, 6}, {15, 16});
  expect_complaint(svg("<use href='other.svg#x'/>"), "another file");
  expect_complaint(svg("<use href='#gone'/>"), "no element has the id 'gone'");
}

TEST(Svg, StyleCascades) {
  const SvgDrawing drawing =
      whole(svg("<style>.a{fill:none;stroke:blue} #i{stroke:green !important} rect{fill:red}</style>"
                "<g stroke='red' stroke-width='2' style='stroke-linecap:round'>"
                "<path class='b a' d='M0 0h1'/><path id='i' class='a' d='M0 0h1'/>"
                "<rect width='1' height='1' fill='blue' stroke='none'/>"
                "<path d='M0 0h1' style='stroke: currentColor; color: teal; fill: none'/></g>"));
  ASSERT_EQ(drawing.shapes.size(), 4U);
  EXPECT_FALSE(drawing.shapes[0].fill);
  EXPECT_EQ(drawing.shapes[0].stroke->color, "blue") << "a rule beats what is inherited";
  EXPECT_EQ(drawing.shapes[0].stroke->width, 2.0);
  EXPECT_EQ(drawing.shapes[0].stroke->cap, "round");
  EXPECT_EQ(drawing.shapes[1].stroke->color, "green") << "an id beats a class";
  EXPECT_EQ(drawing.shapes[2].fill->color, "red") << "a rule beats an attribute";
  EXPECT_FALSE(drawing.shapes[2].stroke);
  EXPECT_EQ(drawing.shapes[3].stroke->color, "teal");
}

TEST(Svg, WhatCannotBeSeenIsLeftOut) {
  for (const char* body :
       {"<rect width='9' height='9' fill='none'/>", "<rect width='9' height='9' display='none'/>",
        "<g style='display:none'><rect width='9' height='9'/><text>x</text></g>",
        "<rect width='9' height='9' visibility='hidden'/>", "<rect width='9' height='9' opacity='0'/>",
        "<rect width='9' height='9' fill-opacity='0'/>", "<path d='M0 0h9' fill='none' stroke='red' stroke-width='0'/>",
        "<defs><rect width='9' height='9'/></defs>", "<clipPath><rect width='9' height='9'/></clipPath>",
        "<switch><rect requiredExtensions='x' width='9' height='9'/></switch>", "<!-- <rect/> --><title>t</title>",
        "<inkscape:thing><rect width='9' height='9'/></inkscape:thing>"}) {
    EXPECT_TRUE(whole(svg(body)).shapes.empty()) << body;
  }
}

TEST(Svg, StrokesScaleWithTheirMaps) {
  const SvgDrawing drawing = whole(svg(
      "<path transform='scale(3)' d='M0 0h9' stroke='red' stroke-width='2' stroke-dasharray='4, 1 2' fill='none'/>"));
  ASSERT_TRUE(drawing.shapes.at(0).stroke);
  EXPECT_NEAR(drawing.shapes[0].stroke->width, 6.0, 1e-12);
  EXPECT_EQ(drawing.shapes[0].stroke->dashes, (std::vector{12.0, 3.0, 6.0, 12.0, 3.0, 6.0}));
}

TEST(Svg, WhatIsNotDrawnIsNamedWithItsLine) {
  const std::string text =
      svg("\n <rect width='9' height='9' fill='url(#g)'/>\n <linearGradient id='g'/>\n"
          " <image id='photo' href='a.png'/>\n <text>t</text>\n <rect width='9' height='9' filter='url(#f)'/>\n"
          " <g mask='url(#m)'><rect width='9' height='9'/></g>\n <video/>\n"
          " <path d='M0 0L' stroke='red'/>\n <path d='M0 0h1' stroke='red' marker-end='url(#m)'/>");
  const SvgDrawing drawing = read(text);
  std::vector<int> lines;
  for (const Problem& problem : drawing.not_drawn) lines.push_back(problem.where.line);
  EXPECT_EQ(lines, (std::vector{2, 4, 5, 6, 7, 8, 9, 10})) << problems_text(drawing.not_drawn);
  EXPECT_NE(problems_text(drawing.not_drawn).find("<image id=\"photo\">"), std::string::npos);
}

TEST(Svg, ClipPathsAroundEverythingAreNoLoss) {
  const std::string frame = "<clipPath id='c'><rect width='50' height='50'/></clipPath>";
  EXPECT_EQ(complaint(svg(frame + "<g clip-path='url(#c)'><circle cx='25' cy='25' r='20'/></g>")), "");
  expect_complaint(svg(frame + "<g clip-path='url(#c)'><circle cx='45' cy='25' r='20'/></g>"), "clip path");
  expect_complaint(svg("<clipPath id='c'><circle r='50'/></clipPath><g clip-path='url(#c)'><circle r='5'/></g>"),
                   "clip path");
}

TEST(Svg, Metadata) {
  const SvgDrawing drawing = read(svg(
      "<title> A  leaf </title><metadata><rdf:RDF><cc:Work><dc:creator><cc:Agent><dc:title>Ann</dc:title></cc:Agent>"
      "</dc:creator><dc:subject><rdf:Bag><rdf:li>leaves</rdf:li></rdf:Bag></dc:subject>"
      "<cc:license rdf:resource='http://c/0'/></cc:Work></rdf:RDF></metadata>"));
  EXPECT_EQ(drawing.about.title, "A  leaf");
  EXPECT_EQ(drawing.about.creator, "Ann");
  EXPECT_EQ(drawing.about.subject, "leaves");
  EXPECT_EQ(drawing.about.licence, "http://c/0");
}

TEST(Svg, PrefixedNames) {
  expect_box(whole("<svg:svg xmlns:svg='http://www.w3.org/2000/svg'><svg:rect width='5' height='6'/></svg:svg>"),
             {0, 0}, {5, 6});
}

// Files made to do harm.

std::string repeated(const std::string& text, std::size_t n) {
  std::string all;
  all.reserve(text.size() * n);
  for (std::size_t i = 0; i < n; ++i) all += text;
  return all;
}

TEST(HostileSvg, NoSvg) {
  expect_complaint("", "no well-formed XML");
  expect_complaint("hello", "no well-formed XML");
  expect_complaint("<html/>", "its first element is <html>");
  expect_complaint(std::string("<svg>\0</svg>", 12), "zero bytes");
  expect_complaint("\xFF\xFE<\0s\0", "no well-formed XML");
  expect_complaint(svg("<g>"), "no well-formed XML");
  expect_complaint(svg("", "width='-5'"), "no length above 0");
  expect_complaint(svg("<rect/>", "viewBox='0 0 0 0'"), "viewBox");
}

TEST(HostileSvg, EveryTruncationEnds) {
  const std::string text =
      svg("<style>.a{fill:red}</style><g transform='scale(2)'><path class='a' d='M0 0C1 2 3 4 5 6z'/>"
          "<use href='#x' x='1'/></g><rect id='x' rx='2' width='9' height='9'/>");
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_FALSE(read_svg(text.substr(0, size), "a.svg", 1e-4).ok()) << size;
  }
}

TEST(HostileSvg, UseThatDrawsItself) {
  expect_complaint(svg("<g id='a'><use href='#a'/></g>"), "draws itself");
  expect_complaint(svg("<g id='a'><use href='#b'/></g><defs><g id='b'><use href='#a'/></g></defs>"), "draws itself");
  expect_complaint(svg("<symbol id='s'><use href='#s'/></symbol><use href='#s'/>"), "draws itself");
}

TEST(HostileSvg, UseBomb) {
  std::string body = "<path id='u0' d='M0 0h1' stroke='red'/>";
  for (int i = 1; i < 40; ++i) {
    const std::string use = "<use href='#u" + std::to_string(i - 1) + "'/>";
    body += "<g id='u" + std::to_string(i) + "'>" + repeated(use, 10) + "</g>";
  }
  expect_complaint(svg("<defs>" + body + "</defs><use href='#u39'/>"), "more than 100000 elements");
}

TEST(HostileSvg, AMillionGroupsOneInAnother) {
  expect_complaint(svg(repeated("<g>", 1'000'000) + repeated("</g>", 1'000'000)), "more than 200 groups");
}

TEST(HostileSvg, ManyElements) {
  expect_complaint(svg(repeated("<g/>", 200'000)), "more than 100000 elements");
  expect_complaint(svg(repeated("<text/>", 50'000)), "text is not drawn");
}

TEST(HostileSvg, LargeFiles) {
  expect_complaint(svg(repeated(" ", 9 << 20)), "larger than the 8 MiB");
}

TEST(HostileSvg, Entities) {
  std::string lol = "<!DOCTYPE svg [<!ENTITY a 'M0 0h1'>";
  for (int i = 0; i < 40; ++i) {
    lol += "<!ENTITY b" + std::to_string(i) + " '" + repeated("&b" + std::to_string(i - 1) + ";", 10) + "'>";
  }
  expect_complaint(lol + "]>" + svg("<path d='&b39;' stroke='red'/>"), "entity");
  expect_complaint("<!DOCTYPE svg [<!ENTITY s 'fill:none'>]>" + svg("<rect width='1' height='1' style='&s;'/>"),
                   "'style'");
}

TEST(HostileSvg, HugeNumbers) {
  expect_complaint(svg("<path d='M0 0L1e300 1' stroke='red'/>"), "no number between");
  expect_complaint(svg("<rect width='1e13' height='1'/>"), "no length");
  expect_complaint(svg("<g transform='scale(1e9)'><g transform='scale(1e9)'><rect width='1' height='1'/></g></g>"),
                   "outside");
  expect_complaint(svg("<rect width='1' height='1' transform='scale(1e400)'/>"), "none of SVG's");
  expect_complaint(svg("<polygon points='1 2 nan 4'/>"), "no list of x,y pairs");
}

TEST(HostileSvg, ManyCurves) {
  const std::string path =
      "<path d='M0 0" + repeated("c1e9 0 0 1e9 1e9 1e9c-1e9 0 0-1e9-1e9-1e9", 800) + "' stroke='red'/>";
  expect_complaint(svg(path, "width='1' height='1'"), "1048576 points");
}

}  // namespace
}  // namespace burin::data
