#include <algorithm>
#include <cmath>
#include <set>

#include <burin/curves/family.hpp>

#include "placing_support.hpp"

/// The tests of reference curves.md, part H, and what presets may ask of a placing.
namespace burin::primitives {
namespace {

double degrees(Vec2 v) {
  return std::atan2(v.y, v.x) * 180.0 / M_PI;
}

const std::vector<Vec2> open5{{0, 0}, {1, 2}, {3, 2}, {4, 0}, {6, 1}};

TEST(Placing, PutsTheReferencesSquareInItsPlace) {
  // The unit square with its feature point in the middle, at (3, 2), twice as large and turned by 90 degrees.
  Recorder recorder;
  const PlacingSpec how = spec(R"({"use": "square", "scale": 2, "rotate": 90})");
  const Figures figures{figure({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})};
  Placing placing(recorder, how, figures, {}, {});
  const std::vector<Vec2> dot{{3, 2}};
  ASSERT_EQ(placing.begin({}), Flow::go);
  ASSERT_EQ(placing.points(dot), Flow::go);
  ASSERT_EQ(placing.end(), Flow::go);
  const auto expected = testing::reference("curves.json")["H_placement"]["place"];
  ASSERT_EQ(recorder.recording().all_points().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(recorder.recording().all_points()[i], (Vec2{expected[i][0], expected[i][1]}));
  }
}

TEST(Placing, TurnsWithTangentEdgeAndNormal) {
  const double tangents[] = {1.1071487177940904, .5535743588970453, -.5535743588970453, -.3217505543966422,
                             .4636476090008061};
  const std::vector<Placed> tangent = place_along(R"({"use": "a", "rotate": "tangent"})", open5);
  const std::vector<Placed> normal = place_along(R"({"use": "a", "rotate": "normal"})", open5);
  const std::vector<Placed> edge = place_along(R"({"use": "a", "rotate": "edge"})", open5);
  ASSERT_EQ(tangent.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT(distance(tangent[i].anchor(), open5[i]), 1e-12);
    EXPECT_NEAR(degrees(tangent[i].direction()), tangents[i] * 180 / M_PI, 1e-9);
    EXPECT_NEAR(degrees(normal[i].direction()), tangents[i] * 180 / M_PI - 90, 1e-9);
    const Vec2 out = i < 4 ? open5[i + 1] - open5[i] : open5[4] - open5[3];
    EXPECT_NEAR(degrees(edge[i].direction()), degrees(out), 1e-9);
  }
}

TEST(Placing, ScalesByLengthLevelAndPlace) {
  const double means[] = {2.2360679774997898, 2.118033988749895, 2.118033988749895, 2.2360679774997898,
                          2.2360679774997898};
  Setting setting;
  setting.slot_from_model = scaling(10, 10);
  const std::vector<Placed> by_length = place_along(spec(R"({"use": "a", "scale": "0.5*length"})"), {{open5}}, setting);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(length(by_length[i].direction()), 0.5 * means[i], 1e-12);
  // 8 mm at level 0; a model unit is 10 mm.
  const std::vector<Placed> by_level = place_along(spec(R"({"use": "a", "scale": "8*0.5^level"})"),
                                                   {{{{0, 0}}, false, 0}, {{{0, 0}}, false, 3}}, setting);
  EXPECT_NEAR(length(by_level[0].direction()), 0.8, 1e-15);
  EXPECT_NEAR(length(by_level[1].direction()), 0.1, 1e-15);
  const std::vector<Placed> by_place = place_along(spec(R"({"use": "a", "scale": "px"})"), {{open5}}, setting);
  ASSERT_EQ(by_place.size(), 4U);  // nothing of no size
  EXPECT_NEAR(length(by_place[3].direction()), 6.0, 1e-12);
}

TEST(Placing, WhatIsTurnedBeforeIsTurnedAfter) {
  // Rotating the input rotates every figure for frames, none for a fixed turn.
  const Affine2 turn = translation({3, -1}) * rotation_degrees(37);
  std::vector<Vec2> turned;
  for (const Vec2 p : open5) turned.push_back(turn(p));
  for (const bool closed : {false, true}) {
    for (const char* rotate : {"edge", "tangent", "normal", "tangent + 20"}) {
      const PlacingSpec how = spec(R"({"use": "a", "scale": "length", "rotate": ")" + std::string(rotate) + "\"}");
      const std::vector<Placed> before = place_along(how, {{open5, closed}});
      const std::vector<Placed> after = place_along(how, {{turned, closed}});
      ASSERT_EQ(before.size(), after.size());
      for (std::size_t i = 0; i < before.size(); ++i) {
        for (const Vec2 u : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0.3, 2}}) {
          EXPECT_LT(distance(turn(before[i].at(u)), after[i].at(u)), 1e-12) << rotate;
        }
      }
    }
    const std::vector<Placed> fixed = place_along(R"({"use": "a", "rotate": 15})", turned, closed);
    for (const Placed& placed : fixed) EXPECT_NEAR(degrees(placed.direction()), 15.0, 1e-9);
  }
}

TEST(Placing, EdgesEveryNthAndLengths) {
  EXPECT_EQ(place_along(R"({"use": "a", "at": "edges"})", open5).size(), 4U);
  EXPECT_EQ(place_along(R"({"use": "a", "at": "edges"})", open5, true).size(), 5U);
  EXPECT_EQ(place_along(R"({"use": "a", "every": 2})", open5).size(), 3U);
  EXPECT_EQ(place_along(R"({"use": "a", "every": 3})", open5, true).size(), 2U);
  Setting setting;
  setting.slot_from_model = scaling(10, 10);
  const std::vector<Placed> along = place_along(spec(R"({"use": "a", "every": "5mm"})"), {{{{0, 0}, {2, 0}}}}, setting);
  ASSERT_EQ(along.size(), 4U);
  EXPECT_NEAR(along[3].anchor().x, 1.5, 1e-12);
}

/// The figures that layers S_0 ... S_top of a Koch curve get, level by level.
std::vector<std::size_t> counts_by_level(const std::string& mode, int top, const std::string& base) {
  const curves::Family& family = *curves::find_family("two-point");
  const PlacingSpec how = spec(R"({"use": "a", "mode": ")" + mode + "\"}");
  PlacedSink sink;
  const Figures figures{arrow()};
  Placing placing(sink, how, figures, {}, {});
  std::vector<std::size_t> counts;
  for (int level = 0; level <= top; ++level) {
    const testing::ReadParams read =
        testing::read_params("two-point", R"({"base": ")" + base + R"(", "levels": )" + std::to_string(level) + "}");
    const std::size_t before = sink.placed.size();
    placing.begin_level(family.retained_every(*read.params));
    EXPECT_EQ(family.draw(*read.params, {}, placing), Flow::go);
    counts.push_back(sink.placed.size() - before);
    for (std::size_t i = before; i < sink.placed.size(); ++i) EXPECT_EQ(sink.placed[i].level, level);
  }
  return counts;
}

TEST(Placing, AllAndNewCountExactly) {
  // One edge: k^l + 1 points of each S_l; new are k^l - k^(l-1) of them. A closed base of N edges: N times that.
  EXPECT_EQ(counts_by_level("all", 5, "segment"), (std::vector<std::size_t>{2, 5, 17, 65, 257, 1025}));
  EXPECT_EQ(counts_by_level("new", 5, "segment"), (std::vector<std::size_t>{2, 3, 12, 48, 192, 768}));
  EXPECT_EQ(counts_by_level("all", 3, "triangle"), (std::vector<std::size_t>{3, 12, 48, 192}));
  EXPECT_EQ(counts_by_level("new", 3, "triangle"), (std::vector<std::size_t>{3, 9, 36, 144}));
}

TEST(Placing, NewPointsOfAllLevelsAreTheLastLevel) {
  const curves::Family& family = *curves::find_family("two-point");
  const PlacingSpec how = spec(R"({"use": "a", "mode": "new"})");
  PlacedSink sink;
  const Figures figures{arrow()};
  Placing placing(sink, how, figures, {}, {});
  std::set<std::pair<double, double>> placed;
  Recorder last;
  for (int level = 0; level <= 4; ++level) {
    const testing::ReadParams read =
        testing::read_params("two-point", R"({"motif": "minkowski", "levels": )" + std::to_string(level) + "}");
    placing.begin_level(family.retained_every(*read.params));
    EXPECT_EQ(family.draw(*read.params, {}, placing), Flow::go);
    if (level == 4) {
      EXPECT_EQ(family.draw(*read.params, {}, last), Flow::go);
    }
  }
  for (const Placed& each : sink.placed) placed.emplace(each.anchor().x, each.anchor().y);
  ASSERT_EQ(sink.placed.size(), last.recording().all_points().size());
  for (const Vec2 p : last.recording().all_points()) EXPECT_TRUE(placed.contains({p.x, p.y}));
}

TEST(Placing, EveryNthCountsNewPointsAlone) {
  std::vector<Vec2> line;
  for (int i = 0; i <= 16; ++i) line.push_back({static_cast<double>(i), 0});
  std::vector<double> xs;
  for (const Placed& placed : place_along(spec(R"({"use": "a", "mode": "new", "every": 2})"), {{line}}, {}, 4)) {
    xs.push_back(placed.anchor().x);
  }
  EXPECT_EQ(xs, (std::vector<double>{1, 3, 6, 9, 11, 14}));  // of 1 2 3 5 6 7 9 10 11 13 14 15
}

TEST(Placing, ADragonsVerticesAreDistinct) {
  const curves::Family& family = *curves::find_family("two-point");
  const testing::ReadParams read = testing::read_params("two-point", R"({"motif": "dragon", "levels": 12})");
  Setting setting;
  setting.slot_from_model = rotation_degrees(33) * scaling(80, 80);
  const auto placed = [&](const std::string& json) {
    PlacedSink sink;
    const PlacingSpec how = spec(json);
    const Figures figures{arrow()};
    Placing placing(sink, how, figures, setting, {});
    placing.begin_level(family.retained_every(*read.params));
    EXPECT_EQ(family.draw(*read.params, {}, placing), Flow::go);
    EXPECT_FALSE(placing.overflowed());
    return sink.placed;
  };
  Recorder recorder;
  EXPECT_EQ(family.draw(*read.params, {}, recorder), Flow::go);
  std::set<std::pair<std::int64_t, std::int64_t>> distinct;
  for (const Vec2 p : recorder.recording().all_points()) {
    distinct.emplace(std::llround(p.x * 64), std::llround(p.y * 64));  // the lattice of level 12
  }
  EXPECT_EQ(placed(R"({"use": "a"})").size(), 4097U);
  EXPECT_LT(distinct.size(), 3000U);
  EXPECT_EQ(placed(R"({"use": "a", "distinct": true})").size(), distinct.size());
  const std::vector<Placed> apart = placed(R"({"use": "a", "apart": "3mm"})");
  EXPECT_GT(apart.size(), 20U);
  for (std::size_t i = 0; i < apart.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(80 * distance(apart[i].anchor(), apart[j].anchor()), 3.0 * (1 - 1e-9));
    }
  }
}

TEST(Placing, JitterStaysWithinItsLengthAndHangsOnTheSeed) {
  const std::vector<Vec2> line(2000, Vec2{1, 1});
  const PlacingSpec how = spec(R"({"use": "a", "jitter": "2mm"})");
  const std::vector<Placed> placed = place_along(how, {{line}}, {.seed = 7});
  double mean_square = 0.0;
  for (const Placed& each : placed) {
    EXPECT_LE(distance(each.anchor(), {1, 1}), 2.0);
    mean_square += length_squared(each.anchor() - Vec2{1, 1}) / 2000;
  }
  EXPECT_NEAR(mean_square, 2.0, 0.1);  // even over a disc: r^2 / 2
  EXPECT_EQ(placed[5].at, place_along(how, {{line}}, {.seed = 7})[5].at);
  EXPECT_NE(placed[5].at, place_along(how, {{line}}, {.seed = 8})[5].at);
  // Symmetric copies are alike.
  EXPECT_EQ(placed[5].at, place_along(how, {{line}}, {.column = 3, .copy = 9, .seed = 7})[5].at);
}

TEST(Placing, RandomTurnsAreEvenAndPathsDiffer) {
  const std::vector<Vec2> line(2000, Vec2{0, 0});
  const std::vector<Placed> placed =
      place_along(spec(R"({"use": "a", "rotate": "random"})"), {{line}, {line}}, {.seed = 3});
  Vec2 sum;
  for (const Placed& each : placed) sum = sum + 0.2 * each.direction();
  EXPECT_LT(length(sum) / 4000, 0.03);
  EXPECT_NE(placed[0].at, placed[2000].at);
}

TEST(Placing, MirrorsOnTheFiguresOwnAxis) {
  const auto sides = [](const std::string& mirror) {
    std::string all;
    for (const Placed& placed : place_along(R"({"use": "a", "rotate": 90, "mirror": ")" + mirror + "\"}", open5)) {
      EXPECT_NEAR(degrees(placed.direction()), 90.0, 1e-12);
      all += placed.at.determinant() > 0 ? '+' : '-';
    }
    return all;
  };
  EXPECT_EQ(sides("none"), "+++++");
  EXPECT_EQ(sides("all"), "-----");
  EXPECT_EQ(sides("alternate"), "+-+-+");
  EXPECT_NE(sides("random").find('-'), std::string::npos);
}

TEST(Placing, FiguresPensAndWhetherToPlaceFollowThePlace) {
  std::vector<Vec2> line;
  for (int i = 0; i < 10; ++i) line.push_back({static_cast<double>(i), 0});
  const auto xs = [&](const std::string& json, const PenFilter& filter = {}) {
    std::string all;
    for (const Placed& placed : place_along(spec(json), {{line}}, {}, 0, filter)) {
      all += std::to_string(std::lround(placed.anchor().x));
    }
    return all;
  };
  EXPECT_EQ(xs(R"({"use": {"by": "x", "at": [3, 6], "of": ["a", "none", "b"]}})"), "0126789");
  EXPECT_EQ(xs(R"({"use": "a", "when": "mod(x, 3) == 0"})"), "0369");
  EXPECT_EQ(xs(R"({"use": "a", "when": {"by": "x", "at": [2, 4], "of": [0, 1, 0]}})"), "23");
  EXPECT_EQ(xs(R"({"use": "a", "when": "(4 - x)^0.5"})"), "0123");  // NaN places nothing
  EXPECT_EQ(xs(R"({"use": "a", "rotate": "(4 - x)^0.5"})"), "01234");
  EXPECT_EQ(xs(R"({"use": ["a", "none"]})"), "02468");
  // Pens share one sequence of places.
  Choice<std::string> pens{{"ink", "red"}, {5.0}, variable("x")};
  EXPECT_EQ(xs(R"({"use": "a", "apart": "2mm"})", {&pens, 0}), "024");
  EXPECT_EQ(xs(R"({"use": "a", "apart": "2mm"})", {&pens, 1}), "68");
}

TEST(Placing, WhereTheSlotPutsACurveChangesNothingInTheModel) {
  // Mirrored and turned copies: figures are placed in the copy's own frame.
  const PlacingSpec how = spec(R"({"use": "a", "rotate": "tangent + 10", "scale": "2mm", "jitter": "1mm"})");
  const std::vector<Placed> plain = place_along(how, {{open5}}, {.slot_from_model = scaling(4, 4), .seed = 5});
  const std::vector<Placed> mirrored =
      place_along(how, {{open5}}, {.slot_from_model = rotation_degrees(60) * scaling(-4, 4), .copy = 1, .seed = 5});
  ASSERT_EQ(plain.size(), mirrored.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    for (const Vec2 u : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}) {
      EXPECT_LT(distance(plain[i].at(u), mirrored[i].at(u)), 1e-14);
    }
  }
}

TEST(Placing, ContoursArePathsOfTheirOwnAndStopsAreHeeded) {
  PlacedSink sink;
  const PlacingSpec how = spec(R"({"use": "a", "rotate": "tangent"})");
  const Figures figures{arrow()};
  Placing placing(sink, how, figures, {}, {});
  const std::vector<Vec2> first{{0, 0}, {1, 0}};
  const std::vector<Vec2> second{{5, 0}, {5, 1}, {5, 2}};
  ASSERT_EQ(placing.begin({}), Flow::go);
  ASSERT_EQ(placing.points(first), Flow::go);
  ASSERT_EQ(placing.contour(), Flow::go);
  ASSERT_EQ(placing.points(second), Flow::go);
  ASSERT_EQ(placing.end(), Flow::go);
  ASSERT_EQ(sink.placed.size(), 5U);
  EXPECT_NEAR(degrees(sink.placed[1].direction()), 0.0, 1e-12);
  EXPECT_NEAR(degrees(sink.placed[2].direction()), 90.0, 1e-12);

  std::stop_source source;
  source.request_stop();
  Stoppable stopped(sink, source.get_token());
  Placing ended(stopped, how, figures, {}, {});
  ASSERT_EQ(ended.begin({}), Flow::go);
  EXPECT_EQ(ended.points(second), Flow::stop);
}

TEST(PlacingSpec, SaysWhatDoesNotGoTogether) {
  EXPECT_EQ(complaint(R"({"every": 2})"), "'use' is missing: which figure is placed, as in { use = \"leaf\" }");
  EXPECT_EQ(complaint(R"({"use": "a", "every": 0})"),
            "'every': expected a whole number from 1, or a length such as \"6mm\"");
  EXPECT_EQ(complaint(R"({"use": "a", "every": "0mm"})"), "'every': a length along the curve must be above 0");
  EXPECT_EQ(complaint(R"({"use": "a", "every": "2mm", "at": "edges"})"), "'at' does not go with a length in 'every'");
  EXPECT_EQ(complaint(R"({"use": "a", "every": "2mm", "mode": "new"})"), "'mode' does not go with a length in 'every'");
  EXPECT_EQ(complaint(R"({"use": "a", "at": "edges", "mode": "new"})"),
            "'mode' does not go with at = \"edges\": only points are new");
  EXPECT_EQ(complaint(R"({"use": "a", "apart": "-2mm"})"), "'apart' = -2 mm is outside [0, inf) mm");
}

TEST(PlacingSpec, KnowsWhatItHangsOn) {
  EXPECT_FALSE(uses_chance(spec(R"({"use": "a"})")));
  EXPECT_TRUE(uses_chance(spec(R"({"use": "a", "jitter": 1})")));
  EXPECT_TRUE(uses_chance(spec(R"({"use": "a", "mirror": "random"})")));
  EXPECT_TRUE(uses_chance(spec(R"({"use": "a", "rotate": "random"})")));
  EXPECT_TRUE(uses_chance(spec(R"({"use": {"by": "rand", "at": [0.5], "of": ["a", "b"]}})")));
  EXPECT_FALSE(depends_on_slot(spec(R"({"use": "a", "scale": "length + x", "rotate": "tangent"})")));
  EXPECT_TRUE(depends_on_slot(spec(R"({"use": "a", "scale": "pr/10"})")));
  EXPECT_TRUE(depends_on_slot(spec(R"({"use": "a", "when": "copy"})")));
  EXPECT_TRUE(fills_every_place(spec(R"({"use": "a", "rotate": "random"})")));
  EXPECT_FALSE(fills_every_place(spec(R"({"use": ["a", "none"]})")));
  EXPECT_FALSE(fills_every_place(spec(R"({"use": "a", "apart": "1mm"})")));
}

}  // namespace
}  // namespace burin::primitives
