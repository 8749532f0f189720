#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "support/architecture_rules.hpp"

/// The house on paper: which rooms there are and which may use which. The first half holds the tree against it; the
/// second feeds each rule a small fake source to show that it can fail.
namespace burin::architecture {
namespace {

const std::vector<Room> rooms{
    {"base", {}},
    {"geom", {"base"}},
    {"params", {"geom"}},
    {"expr", {"base"}},
    {"data", {"geom"}},
    {"path", {"geom"}},
    {"curves", {"path", "params", "expr", "data"}},
    {"primitives", {"path", "params", "expr", "data"}},
    {"passes", {"path", "params"}},
    {"measure", {"path", "data"}},
    {"scene", {"path", "params", "expr", "data"}},
    {"forms", {"scene"}},
    {"output", {"path"}},
    {"output_cairo", {"output"}},
    {"preset", {"curves", "primitives", "passes", "measure", "forms"}},
    {"burin", {"preset", "output"}},  // src/burin/burin.hpp, the front door
    {"cli", {"burin", "output_cairo"}},
};

const std::vector<Library> third_parties{
    {"toml++/", {"src/burin/preset/"}},
    {"muParser", {"src/burin/expr/"}},
    {"cairo", {"src/burin/output_cairo/"}, false},
    {"png.h", {"src/burin/data/", "src/burin/output/"}},  // reads, writes
    {"stb/", {"src/burin/output/"}},
    {"libdeflate.h", {"src/burin/output/"}},
    {"boost/", {"src/cli/"}},
    {"oneapi/", {"src/cli/"}},
    {"zlib.h", {"src/cli/recover/"}},
    {"pugixml", {"src/burin/data/"}},
    {"jpeglib.h", {"src/burin/data/"}},
};

constexpr int max_lines = 500;

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::filesystem::path root = BURIN_SOURCE_DIR;

/// Every source and CMakeLists.txt under src.
std::vector<File> tree() {
  std::vector<File> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "src")) {
    if (!entry.is_regular_file()) continue;
    files.push_back({entry.path().lexically_relative(root).generic_string(), contents(entry.path())});
  }
  return files;
}

std::vector<std::string> room_folders() {
  std::vector<std::string> folders{"cli", "burin"};
  for (const auto& entry : std::filesystem::directory_iterator(root / "src" / "burin")) {
    if (entry.is_directory()) folders.push_back(entry.path().filename().string());
  }
  return folders;
}

std::string listed(const Violations& violations) {
  std::string all;
  for (const std::string& violation : violations) all += violation + "\n";
  return all;
}

TEST(Architecture, TreeIsFound) {
  const auto files = tree();
  EXPECT_GT(files.size(), 50U);
  EXPECT_TRUE(
      std::any_of(files.begin(), files.end(), [](const File& f) { return f.path == "src/burin/geom/vec2.hpp"; }));
}
TEST(Architecture, RoomsUseOnlyWhatTheyMay) {
  EXPECT_EQ(listed(edges(tree(), rooms)), "");
}
TEST(Architecture, ReadmeIsTheMap) {
  EXPECT_EQ(listed(map_of_rooms(contents(root / "src/README.md"), room_folders(), rooms)), "");
}
TEST(Architecture, LibrariesStayInTheirPlace) {
  EXPECT_EQ(listed(libraries(tree(), third_parties)), "");
}
TEST(Architecture, PublicHeadersNeedTheStandardLibraryOnly) {
  EXPECT_EQ(listed(public_headers(tree())), "");
}
TEST(Architecture, NoTranscendentalsOfLibm) {
  EXPECT_EQ(listed(transcendentals(tree())), "");
}
TEST(Architecture, NothingOfTheEnvironmentInTheLibrary) {
  EXPECT_EQ(listed(environment(tree())), "");
}
TEST(Architecture, NoQuotedIncludes) {
  EXPECT_EQ(listed(quoted_includes(tree())), "");
}
TEST(Architecture, NoLongFiles) {
  EXPECT_EQ(listed(long_files(tree(), max_lines)), "");
}
TEST(Architecture, EverySourceIsListed) {
  EXPECT_EQ(listed(unlisted_sources(tree())), "");
}

// That each rule can fail.

std::vector<File> one(std::string path, std::string text) {
  return {{std::move(path), std::move(text)}};
}

TEST(ArchitectureRules, EdgesAreTransitiveAndOneWay) {
  const std::string geom = "#include <burin/geom/vec2.hpp>\n";
  EXPECT_TRUE(edges(one("src/burin/curves/a.hpp", geom), rooms).empty());
  EXPECT_TRUE(edges(one("src/burin/geom/a.cpp", geom), rooms).empty());
  EXPECT_TRUE(edges(one("src/cli/a.cpp", "#include <burin/output_cairo/a.hpp>\n" + geom), rooms).empty());
  EXPECT_EQ(listed(edges(one("src/burin/base/a.hpp", "\n" + geom), rooms)),
            "src/burin/base/a.hpp:2: room base may not use geom (burin/geom/vec2.hpp)\n");
  EXPECT_EQ(edges(one("src/burin/expr/a.hpp", geom), rooms).size(), 1U);
  EXPECT_EQ(edges(one("src/burin/preset/a.cpp", "  #  include \"burin/output/a.hpp\"\n"), rooms).size(), 1U);
  EXPECT_EQ(edges(one("src/burin/preset/a.cpp", "#include <burin/burin.hpp>\n"), rooms).size(), 1U);
  EXPECT_EQ(edges(one("src/burin/burin.cpp", "#include <burin/output_cairo/a.hpp>\n"), rooms).size(), 1U);
  EXPECT_EQ(edges(one("src/burin/preset/a.cpp", "#include <cli/console.hpp>\n"), rooms).size(), 1U);
  EXPECT_EQ(edges(one("src/burin/attic/a.cpp", geom), rooms).size(), 1U) << "a room that is in no table";
  EXPECT_EQ(edges(one("src/burin/geom/a.cpp", "#include <burin/attic/a.hpp>\n"), rooms).size(), 1U);
}

TEST(ArchitectureRules, ReadmeAndFoldersMustAgree) {
  const std::string readme = "# Map\n| room | what |\n| `base` | x |\n| `geom` | x |\n| `forms` (coming) | x |\n";
  EXPECT_TRUE(map_of_rooms(readme, {"base", "geom"}, rooms).empty());
  EXPECT_EQ(map_of_rooms(readme, {"base", "geom", "path"}, rooms).size(), 1U) << "not named";
  EXPECT_EQ(map_of_rooms(readme, {"base"}, rooms).size(), 1U) << "no folder";
  EXPECT_EQ(map_of_rooms(readme, {"base", "geom", "forms"}, rooms).size(), 1U) << "no longer coming";
  EXPECT_EQ(map_of_rooms(readme + "| `attic` (coming) | x |\n", {"base", "geom"}, rooms).size(), 1U) << "no table";
  EXPECT_EQ(map_of_rooms(readme + "| `attic` | x |\n", {"base", "geom", "attic"}, rooms).size(), 2U);
}

TEST(ArchitectureRules, LibrariesHaveOneHome) {
  EXPECT_TRUE(libraries(one("src/burin/preset/a.cpp", "#include <toml++/toml.h>\n"), third_parties).empty());
  EXPECT_EQ(libraries(one("src/cli/a.cpp", "#include <toml++/toml.h>\n"), third_parties).size(), 1U);
  EXPECT_EQ(libraries(one("src/cli/a.cpp", "#include <cairo.h>\n"), third_parties).size(), 1U);
  EXPECT_EQ(libraries(one("src/burin/output/a.cpp", "#include <cairo-pdf.h>\n"), third_parties).size(), 1U);
  EXPECT_EQ(libraries(one("src/burin/curves/a.cpp", "#include <muParser.h>\n"), third_parties).size(), 1U);
  EXPECT_EQ(libraries(one("src/burin/curves/a.cpp", "#include <png.h>\n"), third_parties).size(), 1U);
  const std::string png = "#include <png.h>\n";
  EXPECT_TRUE(libraries({{"src/burin/data/a.cpp", png}, {"src/burin/output/a.cpp", png}}, third_parties).empty());
  EXPECT_EQ(libraries({{"src/burin/data/a.cpp", png}, {"src/burin/data/b.cpp", png}}, third_parties).size(), 1U);
  EXPECT_EQ(libraries(one("src/burin/data/a.cpp", "#include <boost/program_options.hpp>\n"), third_parties).size(), 1U);
  const std::string toml = "#include <toml++/toml.h>\n";
  EXPECT_EQ(libraries({{"src/burin/preset/a.cpp", toml}, {"src/burin/preset/b.cpp", toml}}, third_parties).size(), 1U);
  const std::string cairo = "#include <cairo.h>\n";
  EXPECT_TRUE(
      libraries({{"src/burin/output_cairo/a.cpp", cairo}, {"src/burin/output_cairo/b.cpp", cairo}}, third_parties)
          .empty());
}

TEST(ArchitectureRules, PublicHeadersAreClean) {
  const auto count = [](std::string path, std::string text) {
    const File list{"src/burin/geom/CMakeLists.txt",
                    "target_sources(x PRIVATE a.cpp own.hpp PUBLIC FILE_SET HEADERS FILES a.hpp)"};
    return public_headers({list, {std::move(path), std::move(text)}}).size();
  };
  EXPECT_EQ(count("src/burin/geom/a.hpp", "#include <vector>\n#include <burin/geom/vec2.hpp>\n"), 0U);
  EXPECT_EQ(count("src/burin/geom/a.cpp", "#include <fmt/format.h>\n"), 0U);
  EXPECT_EQ(count("src/burin/geom/own.hpp", "#include <fmt/format.h>\n"), 0U) << "not installed";
  EXPECT_EQ(count("src/burin/geom/a.hpp", "#include <fmt/format.h>\n"), 1U);
  EXPECT_EQ(count("src/burin/geom/a.hpp", "#include <cairo.h>\n"), 1U);
}

TEST(ArchitectureRules, TranscendentalsAreSeen) {
  const auto count = [](std::string text, std::string path = "src/burin/curves/a.cpp") {
    return transcendentals(one(std::move(path), std::move(text))).size();
  };
  EXPECT_EQ(count("double y = std::sin(x);"), 1U);
  EXPECT_EQ(count("double y = ::cos(x);"), 1U);
  EXPECT_EQ(count("double y = pow(x, 2);"), 1U);
  EXPECT_EQ(count("auto f = std::exp;"), 1U);
  EXPECT_EQ(count("using std::log;"), 1U);
  EXPECT_EQ(count("double y = std::sin(x);", "src/burin/base/math_trig.cpp"), 1U) << "in base too";
  EXPECT_EQ(count("double sin(double x) { return cos(x); }", "src/burin/base/math_trig.cpp"), 0U);
  EXPECT_EQ(count("math::sin(x) + burin::math::pow(x, y) + std::sqrt(x) + std::floor(x) + std::abs(x)"), 0U);
  EXPECT_EQ(count("// std::sin(x)\n/* pow(x) */ f(\"std::cos(x)\"); c('\\''); sin_degrees(1'000'000);"), 0U);
  EXPECT_EQ(count("f(R\"(std::cos \" )\"); std::cos(1);"), 1U);
  EXPECT_EQ(count("std::sin(x)", "src/cli/a.cpp"), 0U) << "the tool is no part of the library";
}

TEST(ArchitectureRules, EnvironmentIsSeen) {
  EXPECT_EQ(environment(one("src/burin/path/a.cpp", "#include <chrono>\n#include <fstream>\n")).size(), 2U);
  EXPECT_EQ(environment(one("src/burin/path/a.cpp", "#include <vector>\n")).size(), 0U);
  EXPECT_EQ(environment(one("src/cli/a.cpp", "#include <fstream>\n")).size(), 0U);
}

TEST(ArchitectureRules, QuotedIncludesAreSeen) {
  EXPECT_EQ(quoted_includes(one("src/cli/a.cpp", "#include \"console.hpp\"\n")).size(), 1U);
  EXPECT_EQ(quoted_includes(one("src/burin/geom/a.cpp", "#include \"vec2.hpp\"\n#include <vector>\n")).size(), 1U);
}

TEST(ArchitectureRules, LongFilesAreSeen) {
  EXPECT_TRUE(long_files(one("src/cli/a.cpp", std::string(max_lines, '\n')), max_lines).empty());
  EXPECT_EQ(long_files(one("src/cli/a.cpp", std::string(max_lines + 1, '\n')), max_lines).size(), 1U);
}

TEST(ArchitectureRules, UnlistedSourcesAreSeen) {
  const File list{"src/burin/geom/CMakeLists.txt", "target_sources(x PRIVATE a.cpp two/c.cpp\n  PUBLIC b.hpp)"};
  EXPECT_TRUE(unlisted_sources(
                  {list, {"src/burin/geom/a.cpp", ""}, {"src/burin/geom/b.hpp", ""}, {"src/burin/geom/two/c.cpp", ""}})
                  .empty());
  EXPECT_EQ(unlisted_sources({list, {"src/burin/geom/aa.cpp", ""}}).size(), 1U);
  EXPECT_EQ(unlisted_sources({list, {"src/burin/geom/c.cpp", ""}}).size(), 1U) << "another folder's";
  EXPECT_EQ(unlisted_sources({list, {"src/burin/path/a.cpp", ""}}).size(), 1U);
}

}  // namespace
}  // namespace burin::architecture
