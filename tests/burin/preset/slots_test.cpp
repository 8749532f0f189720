#include "preset_text.hpp"

namespace burin::preset {
namespace {

SlotSpec slot_of(std::string_view keys) {
  const Piece piece = piece_of("slots.s = { " + std::string(keys) + " }");
  return piece.slots.empty() ? SlotSpec{} : piece.slots[0].slot;
}

/// The complaint about a slot's one key, without its place.
std::string slot_complaint(std::string_view keys) {
  const std::string all = complaints_in("slots.s = { " + std::string(keys) + " }");
  return all.substr(std::min(all.find("error: "), all.size()));
}

TEST(SlotRect, MixesLengthsAndShares) {
  const SlotRect rect = slot_of("at = '0 70% (2 + 3)cm (100/4)%'").at;
  EXPECT_FALSE(rect.x.percent);
  EXPECT_EQ(rect.x.value, 0.0);
  EXPECT_TRUE(rect.y.percent);
  EXPECT_EQ(rect.y.value, 70.0);
  EXPECT_FALSE(rect.width.percent);
  EXPECT_EQ(rect.width.value, 50.0);
  EXPECT_TRUE(rect.height.percent);
  EXPECT_EQ(rect.height.value, 25.0);
  EXPECT_EQ(slot_of("at = '-5mm -1% 200% 1'").at.x.value, -5.0);
}

TEST(SlotRect, HasAnArea) {
  EXPECT_EQ(slot_complaint("at = '0 0 100%'"), "error: 'at': expected four parts \"x y w h\", found 3\n");
  EXPECT_EQ(slot_complaint("at = '0 0 0% 10mm'"), "error: 'at': width and height must be above 0\n");
  EXPECT_EQ(slot_complaint("at = '0 0 10 -1%'"), "error: 'at': width and height must be above 0\n");
  EXPECT_EQ(slot_complaint("at = [0, 0, 1, 1]"), "error: 'at': expected a text \"x y w h\", found a list\n");
}

TEST(Align, TakesOneOrTwoWords) {
  EXPECT_EQ(slot_of("align = 'left'").align.x, -1);
  EXPECT_EQ(slot_of("align = 'left'").align.y, 0);
  EXPECT_EQ(slot_of("align = 'bottom right'").align.x, 1);
  EXPECT_EQ(slot_of("align = 'bottom right'").align.y, 1);
  EXPECT_EQ(slot_of("align = 'center top'").align.y, -1);
  EXPECT_EQ(slot_of("align = 'center middle'").align.x, 0);
  EXPECT_EQ(slot_complaint("align = 'left right'"), "error: 'align': 'left' and 'right' are in the same direction\n");
  EXPECT_EQ(slot_complaint("align = 'botom'"), "error: 'align': 'botom' is no side; did you mean 'bottom'?\n");
  EXPECT_EQ(slot_complaint("align = ''"),
            "error: 'align': expected one or two words such as \"left top\", found a text\n");
}

TEST(Grid, CountsFromOneToAThousand) {
  EXPECT_EQ(slot_of("grid = [1, 1000]").grid.rows, 1000);
  EXPECT_EQ(slot_of("grid = ['2*2', 1]").grid.columns, 4);
  EXPECT_EQ(slot_complaint("grid = [0, 1]"), "error: 'grid': 0 columns is outside [1, 1000]\n");
  EXPECT_EQ(slot_complaint("grid = [1, 1001]"), "error: 'grid': 1001 rows is outside [1, 1000]\n");
  EXPECT_EQ(slot_complaint("grid = [1, 9223372036854775807]"), "error: 'grid': 9223372036854775807 is too large\n");
  EXPECT_EQ(slot_complaint("grid = [1.5, 1]"), "error: 'grid': expected a whole number, found a number\n");
  EXPECT_EQ(slot_complaint("grid = [1]"), "error: 'grid': expected a list [columns, rows], found a list\n");
}

TEST(SymmetryName, KnowsTheGroups) {
  for (const char* name : {"c1",   "c2", "c360", "d1", "d6", "d360", "p111", "p1a1", "p1m1", "pm11", "p112", "pma2",
                           "pmm2", "p1", "p2",   "pm", "pg", "pmm",  "p4",   "p4m",  "p3",   "p6",   "p6m"}) {
    EXPECT_EQ(slot_of("symmetry = '" + std::string(name) + "'").symmetry.name, name);
  }
  for (const char* name : {"c0", "c", "d", "c06", "c361", "d99999999999", "c-1", "c6x", "C6", "p5", "", "p4g "}) {
    EXPECT_NE(slot_complaint("symmetry = '" + std::string(name) + "'"), "") << name;
  }
  EXPECT_EQ(slot_complaint("symmetry = 'd361'"), "error: 'symmetry': 'd361' turns more than 360 times\n");
}

TEST(Frame, AscendsInBothDirections) {
  EXPECT_EQ((*slot_of("frame = [0, '-1/2', 1, 2.5]").frame)[1], -0.5);
  EXPECT_EQ(slot_complaint("frame = [0, 0, 0, 1]"), "error: a frame is [x0, y0, x1, y1] with x0 < x1 and y0 < y1\n");
  EXPECT_EQ(slot_complaint("frame = [0, 0, 1]"), "error: 'frame': expected a list of 4 numbers, found a list of 3\n");
  EXPECT_EQ(slot_complaint("frame = [0, 0, 1, true]"), "error: 'frame': expected a number, found a boolean\n");
  EXPECT_EQ(slot_complaint("frame = [0, 0, 1, 1], scale = '1mm'"), "error: a slot has 'frame' or 'scale', not both\n");
}

TEST(Slot, ReadsTheRest) {
  const SlotSpec slot = slot_of("rotate = 30, scale = '10mm', mirror = 'xy', gap = '8mm', cell = '4cm'");
  EXPECT_EQ(slot.rotate, 30.0);
  EXPECT_EQ(slot.scale->mm, 10.0);
  EXPECT_EQ(slot.mirror, Mirror::xy);
  EXPECT_EQ(slot.gap.mm, 8.0);
  EXPECT_EQ(slot.cell->mm, 40.0);
  EXPECT_FALSE(slot_of("").scale.has_value());
  EXPECT_EQ(slot_complaint("scale = 0"), "error: 'scale' = 0 mm is outside (0, inf) mm\n");
  EXPECT_EQ(slot_complaint("mirror = 'z'"), "error: 'mirror': 'z' is none of the choices; known: none, x, y, xy\n");
}

TEST(FormatTables, ShowEveryKeyWithItsDefault) {
  std::string text;
  for (const FormatTable& table : format_tables()) {
    for (const params::FieldInfo& field : table.fields) {
      EXPECT_FALSE(field.doc.empty()) << field.name;
      text += std::string(table.name) + '.' + std::string(field.name) + " = " + field.default_text + '\n';
    }
  }
  for (const char* line :
       {"page.size = \"a4\"\n", "page.margin = \"25mm 25mm 32mm 25mm\"\n", "page.paper = \"#ffffff\"\n",
        "pen.width = \"0.3mm\"\n", "slot.at = \"0 0 100% 100%\"\n", "slot.align = \"center middle\"\n",
        "slot.grid = [1, 1]\n", "slot.mirror = \"none\"\n", "slot.symmetry = \n", "layer.caps = \"round\"\n",
        "layer.miter = 4\n", "layer.pen = \n", "knob.default = \n", "about.title = \"\"\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
}

}  // namespace
}  // namespace burin::preset
