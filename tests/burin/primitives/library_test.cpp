#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include <burin/primitives/library.hpp>

namespace burin::primitives {
namespace {

Result<std::string> no_file(std::string_view name) {
  return Problem{{std::string(name)}, "cannot be read: no such file"};
}

TEST(Library, ShippedFiguresAreInOrderAndWhole) {
  const std::span<const ShippedFigure> figures = shipped_figures();
  EXPECT_TRUE(std::is_sorted(figures.begin(), figures.end(),
                             [](const ShippedFigure& a, const ShippedFigure& b) { return a.name < b.name; }));
  for (const ShippedFigure& figure : figures) {
    const Result<Primitive> read = find_primitive(figure.name, no_file);
    ASSERT_TRUE(read.ok()) << problems_text(read.problems());
    EXPECT_EQ(read->name, figure.name);
    EXPECT_NE(read->title, figure.name) << "a title of its own";
    EXPECT_FALSE(read->family.empty()) << figure.name;
    EXPECT_EQ(read->licence, "CC0-1.0") << figure.name;
    const Box2 box = read->figure->drawing().bounds();
    EXPECT_NEAR(std::max(box.width(), box.height()), 1.0, 1e-12) << figure.name;
  }
}

TEST(Library, TheOnesThatThePapersName) {
  for (const char* name : {"circle", "rectangle", "segment"}) EXPECT_TRUE(find_primitive(name, no_file).ok()) << name;
}

TEST(Library, FilesAndTheUsersOwn) {
  std::string asked;
  const ReadFile files = [&](std::string_view name) -> Result<std::string> {
    asked = name;
    return std::string("<svg><path d='M0 0h1' stroke='red'/></svg>");
  };
  EXPECT_TRUE(find_primitive("sub/leaf.svg", files).ok());
  EXPECT_EQ(asked, "sub/leaf.svg");
  EXPECT_TRUE(find_primitive("my-leaf", files).ok());
  EXPECT_EQ(asked, "burin:primitives/my-leaf.svg");
  asked.clear();
  EXPECT_TRUE(find_primitive("circle", files).ok());
  EXPECT_EQ(asked, "") << "a shipped figure draws the same everywhere";
}

TEST(Library, UnknownNamesAreTold) {
  const Result<Primitive> read = find_primitive("circel", no_file);
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.problems()[0].message.find("did you mean 'circle'"), std::string::npos) << read.problems()[0].message;
}

}  // namespace
}  // namespace burin::primitives
