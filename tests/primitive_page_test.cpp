#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/burin.hpp>
#include <burin/primitives/figure_spec.hpp>
#include <burin/primitives/library.hpp>
#include <burin/primitives/picture.hpp>

#include "support/blessed_page.hpp"

/// docs/primitives.md and its pictures are written from the figures of primitives/ and held to them here.
namespace burin {
namespace {

using primitives::Primitive;

constexpr Page page{30.0, 30.0, 0.0, {255, 255, 255}};
constexpr Box2 area{{4.0, 4.0}, {26.0, 26.0}};
constexpr double pen_mm = 0.35;

std::vector<Primitive> figures() {
  std::vector<Primitive> all;
  for (const primitives::ShippedFigure& row : primitives::shipped_figures()) {
    Result<Primitive> figure = primitives::find_primitive(row.name, no_files);
    EXPECT_TRUE(figure.ok()) << row.name;
    if (figure) all.push_back(*std::move(figure));
  }
  std::stable_sort(all.begin(), all.end(), [](const Primitive& a, const Primitive& b) { return a.family < b.family; });
  return all;
}

std::string picture(const Primitive& figure) {
  Sheet sheet = primitives::picture_sheet(page, pen_mm);
  sheet.made_by.title = figure.title;
  return test::page_svg(sheet, [&](PathSink& sink) {
    const std::array<primitives::FigurePicture, 1> shown{{{&figure, area}}};
    EXPECT_EQ(primitives::draw_pictures(shown, area.width(), sink), Flow::go);
  });
}

constexpr const char* prose =
    R"(# Primitives

<!-- Written from the code: BURIN_BLESS=1 with ctest -R PrimitivePage writes this page and its pictures anew. -->

A primitive is a small figure that is put at points of a curve. The cross is its anchor, which comes to lie on the point;
the arrow shows what is up in it. A figure of size 10 mm is 10 mm long on its longer side, and the pen stays as wide as it
is. A preset calls a figure by its name, `primitives = { use = "leaf", every = "6mm", scale = "5mm" }`;
`burin list primitives` lists them, `burin show leaf -o leaf.svg` draws one, `burin primitives --sheet sheet.pdf` all.

## Figures of your own

Draw one in Inkscape or anything else that writes SVG, and call it by its file, `use = "my-leaf.svg"`, relative to the
preset; or put it into `$XDG_DATA_HOME/burin/primitives` (`~/.local/share/burin/primitives`) and call it `my-leaf`.

- Label an object `anchor` (its label in Inkscape, or its id): its middle is the anchor, and it is not drawn. When it is a
  line, its start is the anchor and its direction is up. Without one the middle of the drawing is.
- Groups, transforms, all path commands, basic shapes, clones (`use`), style sheets, units and viewBox are followed. What is
  filled becomes an area, what is stroked a line, dashes cut; colours and widths are those of the pen.
- Text, pictures, gradients, clip paths that cut, masks and filters are refused with their line; `partial = true` leaves
  them out.

A figure can also be written into a preset:

```toml
[define]
bud = { d = "M0 0C4 -6 4 -12 0 -18C-4 -12 -4 -6 0 0Z", anchor = [0, 0] }
invader = { pixels = """
..#.....#..
...#...#...
..#######..
.##.###.##.
###########
#.#######.#
#.#.....#.#
...##.##...
""", anchor_pixel = [5, 4] }
stamp = { file = "stamp.png", anchor_pixel = [8, 15] }
```

Pixels become the exact outline of the set ones: dark pixels of a PNG, `#` in text. Path data alone needs no name:
`use = "M0 0C4 -6 4 -12 0 -18"`.

| key | meaning | takes | default |
|---|---|---|---|
)";

std::string whole_page() {
  std::string text = prose;
  for (const params::FieldInfo& field : primitives::figure_fields()) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", field.name, field.doc, field.type,
                        field.default_text.empty() ? "" : '`' + field.default_text + '`');
  }
  std::string family;
  for (const Primitive& figure : figures()) {
    if (figure.family != family) {
      family = figure.family;
      std::string title = family;
      title.front() = static_cast<char>(std::toupper(title.front()));
      text += fmt::format("\n## {}\n\n", title);
    }
    text += fmt::format("![{0}: {1}](images/primitives/{0}.svg \"{0}: {1}\")\n", figure.name, figure.title);
  }
  return text;
}

TEST(PrimitivePage, IsWrittenFromTheFigures) {
  test::hold_file(test::docs_folder() / "primitives.md", whole_page());
}

TEST(PrimitivePage, ItsPicturesAreTheFigures) {
  std::vector<test::PagePicture> pictures;
  for (const Primitive& figure : figures()) pictures.push_back({figure.name, picture(figure)});
  EXPECT_GE(pictures.size(), 48U);
  test::hold_pictures("primitives", pictures);
}

}  // namespace
}  // namespace burin
