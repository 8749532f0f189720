#include <gtest/gtest.h>

#include "support/json_value.hpp"

namespace burin::curves {
namespace {

using testing::read_params;

/// What reading complains about; empty when it does not.
std::string complaint(const std::string& json) {
  const testing::ReadParams read = read_params("two-point", json);
  EXPECT_EQ(read.params.has_value(), read.problems.empty()) << json;
  return read.problems.empty() ? "" : read.problems.front().message;
}

std::string motif_complaint(const std::string& motif) {
  return complaint(R"({"motif": )" + motif + "}");
}

TEST(TwoPointMotif, EveryWayToWriteOneIsRead) {
  for (const char* motif :
       {R"("koch")", R"({"marks": [[0.5, 0.5]]})", R"({"points": [[0, 0], [1, 2], [3, 0]]})",
        R"({"turtle": "F+F--F+F", "angle": 60})", R"({"name": "cesaro", "angle": 60})",
        R"({"name": "gosper", "reverse": "A", "join": [0.5, "sqrt(3)/6"]})",
        R"({"name": "koch", "sign": "edge", "decay": 0.9})", R"({"by_edge": [[[0.5, 0.1]], [[0.5, 0.2]]]})",
        R"({"by_level": ["koch", {"marks": [[0.5, "sqrt(3)/6"]]}], "sign": "level"})",
        R"({"marks": [[0.5, 0.5]], "flip": [0, 1], "reverse": [1, 0]})",
        R"({"marks": [["1/3", {"random": [0, "1/2"]}]], "beta": "absolute", "decay": 0.5})"}) {
    EXPECT_EQ(motif_complaint(motif), "") << motif;
  }
}

TEST(TwoPointMotif, MistakesAreNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("kock")", "no motif 'kock'; did you mean 'koch'?"},
      {R"(7)", "expected the name of a motif or a table, found a whole number"},
      {R"({})", "exactly one of 'name', 'marks'"},
      {R"({"marks": []})", "exactly one of 'name', 'marks'"},
      {R"({"marks": [[0.5, 0.5]], "turtle": "F+F"})", "exactly one of 'name', 'marks'"},
      {R"({"marks": [[0.5]]})", "expected a mark [alpha, beta]"},
      {R"j({"marks": [[0.5, "0.3*("]]})j", ""},
      {R"({"marks": [[0.5, "levle"]]})", "did you mean 'level'?"},
      {R"({"marks": [[0.5, {"random": [1, 0]}]]})", "low end of a random range"},
      {R"({"marks": [[0.5, {"random": 3}]]})", "{ random = [low, high] }"},
      {R"({"marks": [[0.5, 0.5]], "sgin": "edge"})", "did you mean 'sign'?"},
      {R"({"marks": [[0.5, 0.5]], "sign": "egde"})", "did you mean 'edge'?"},
      {R"({"marks": [[0.5, 0.5]], "sign": [1, 2]})", "each 1 or -1"},
      {R"({"marks": [[0.5, 0.5]], "sign": []})", "each 1 or -1"},
      {R"({"marks": [[0.5, 0.5]], "flip": [0, 1, 0]})", "one flag for each of the 2 sub-edges, found 3"},
      {R"({"marks": [[0.5, 0.5]], "flip": [0, 2]})", "flags are 0 or 1"},
      {R"({"marks": [[0.5, 0.5]], "flip": "F"})", "needs a 'turtle' word"},
      {R"({"marks": [[0.5, 0.5]], "flip": [0, 1], "sign": "edge"})", "use 'sign' with"},
      {R"({"marks": [[0.5, "rand"]], "flip": [0, 1]})", "use 'sign' with"},
      {R"({"points": [[0, 0], [1, 1], [0, 0]]})", "must end somewhere else"},
      {R"({"points": [[0, 0], [1, 0]]})", "at least one mark"},
      {R"({"turtle": "F+F*F"})", "found '*'"},
      {R"({"turtle": "F"})", "at least one mark"},
      {R"({"name": "kock"})", "no motif 'kock'; did you mean 'koch'?"},
      {R"({"name": "koch", "marks": [[0.5, 0.5]]})", "exactly one of 'name'"},
      {R"({"name": "fret", "angle": 80})", "'fret' is made of points and has no 'angle'"},
      {R"({"name": "koch", "angle": 180})", "with this angle 'koch' ends where it begins"},
      {R"({"name": "koch", "angle": 400})", "outside [-360, 360]"},
      {R"({"name": "koch", "flip": [1, 0]})", "one flag for each of the 4 sub-edges, found 2"},
      {R"({"name": "dragon", "decay": 0.5})", "use 'sign' with"},
      {R"({"name": "koch", "join": [0.5, 0], "decay": 0.5})", "'join' needs plain marks"},
      {R"({"name": "koch", "join": [0.5, 0], "sign": "random"})", "'join' needs plain marks"},
      {R"({"marks": [[0.5, "rand"]], "join": [0.5, 0]})", "'join' needs plain marks"},
      {R"({"by_level": ["hilbert"]})", "join beside 'by_level'"},
      {R"({"name": "koch", "join": 0.5})", "point"},
      {R"({"marks": [[0.5, 0.5]], "angle": 60})", "'angle' belongs to a 'turtle' word or a 'name'"},
      {R"({"by_edge": [[[0.5, 0]], [[0.3, 0], [0.6, 0]]]})", "equally long"},
      {R"({"by_level": ["dragon"]})", "use a sign rule"},
      {R"({"marks": [[0.5, 0.5]], "decay": 0})", "outside (0, 10]"},
  };
  for (const auto& [motif, expected] : cases) {
    const std::string message = motif_complaint(motif);
    EXPECT_NE(message, "") << motif;
    EXPECT_NE(message.find(expected), std::string::npos) << motif << "\n" << message;
  }
}

TEST(TwoPointMotif, LevelsAndSignAreChecked) {
  EXPECT_EQ(complaint(R"({"levels": 1001})"), "'levels' = 1001 is outside [0, 1000]");
  EXPECT_EQ(complaint(R"({"levels": -1})"), "'levels' = -1 is outside [0, 1000]");
  EXPECT_NE(complaint(R"({"levels": 2.5})"), "");
  EXPECT_EQ(complaint(R"({"sign": "edge", "motif": {"marks": [[0.5, 0.5]], "sign": "level"}})"),
            "'sign' is given twice: in the curve and in its motif");
  EXPECT_EQ(complaint(R"({"levles": 3})"), "unknown key 'levles' in curve; did you mean 'levels'?");
}

}  // namespace
}  // namespace burin::curves
