#include <atomic>
#include <cmath>
#include <mutex>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include <burin/base/number_text.hpp>
#include <cli/memory_budget.hpp>
#include <cli/name_pattern.hpp>
#include <cli/seed_list.hpp>
#include <cli/series.hpp>
#include <cli/sweep.hpp>
#include <cli/tbb_executor.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

using cli::NamePattern;
using cli::SeedList;
using cli::Series;
using cli::SeriesRequest;
using cli::Sweep;
using cli::TbbExecutor;
using Seeds = std::vector<std::uint64_t>;
using Texts = std::vector<std::string>;

Seeds seeds_of(std::string_view text) {
  const Result<SeedList> list = SeedList::read(text);
  if (!list) {
    ADD_FAILURE() << text << ": " << list.problems().front().message;
    return {};
  }
  EXPECT_EQ(list->count(), static_cast<double>(list->all().size())) << text;
  return list->all();
}

Texts values_of(std::string_view text) {
  const Result<Sweep> sweep = Sweep::read(text);
  if (!sweep) {
    ADD_FAILURE() << text << ": " << sweep.problems().front().message;
    return {};
  }
  EXPECT_EQ(sweep->count(), static_cast<double>(sweep->values().size())) << text;
  return sweep->values();
}

std::string sweep_problem(std::string_view text) {
  const Result<Sweep> sweep = Sweep::read(text);
  return sweep ? std::string() : sweep.problems().front().message;
}

TEST(SeedList, ReadsNumbersRangesAndMixtures) {
  EXPECT_EQ(seeds_of("7"), (Seeds{7}));
  EXPECT_EQ(seeds_of("0..4"), (Seeds{0, 1, 2, 3, 4}));
  EXPECT_EQ(seeds_of("4..1"), (Seeds{4, 3, 2, 1}));
  EXPECT_EQ(seeds_of("5..5"), (Seeds{5}));
  EXPECT_EQ(seeds_of("7,19,33"), (Seeds{7, 19, 33}));
  EXPECT_EQ(seeds_of("1..3,7,9..8"), (Seeds{1, 2, 3, 7, 9, 8}));
  const std::uint64_t top = ~std::uint64_t{0};
  EXPECT_EQ(seeds_of("-2..2"), (Seeds{top - 1, top, 0, 1, 2}));
  EXPECT_EQ(seeds_of("1..-1"), (Seeds{1, 0, top}));
  EXPECT_EQ(seeds_of("18446744073709551614..18446744073709551615"), (Seeds{top - 1, top}));
  EXPECT_EQ(seeds_of("-0"), (Seeds{0}));
}

TEST(SeedList, RandomSeedsDiffer) {
  EXPECT_EQ(seeds_of("random").size(), 1U);
  const Seeds five = seeds_of("random*4,3");
  ASSERT_EQ(five.size(), 5U);
  EXPECT_EQ(five[4], 3U);
  EXPECT_NE(five[0], five[1]);
}

TEST(SeedList, HugeRangesAreCountedNotListed) {
  EXPECT_EQ(SeedList::read("0..1000000000000000000")->count(), 1e18);
  EXPECT_EQ(SeedList::read("0..18446744073709551615")->count(), 0x1p64);
  EXPECT_EQ(SeedList::read("random*18446744073709551615,1")->count(), 0x1p64);
}

TEST(SeedList, RefusesWhatIsNoSeed) {
  for (const char* text : {"",
                           ",",
                           "1,",
                           ",1",
                           "1,,2",
                           "x",
                           "1.5",
                           "1..",
                           "..3",
                           "1..2..3",
                           "0...3",
                           "0..1e18",
                           "0x10",
                           " 1",
                           "1 ",
                           "+1",
                           "--1",
                           "1-3",
                           "18446744073709551616",
                           "-9223372036854775809",
                           "randoms",
                           "random*",
                           "random*0",
                           "random*-1",
                           "random..3",
                           "0..random",
                           "Random"}) {
    const Result<SeedList> list = SeedList::read(text);
    ASSERT_FALSE(list) << text;
    EXPECT_TRUE(contains(list.problems().front().message, "--seed must be")) << text;
  }
}

TEST(SeedList, EveryRangeHasItsEnds) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 200; ++round) {
    const auto first = static_cast<std::int64_t>(random()) >> (round % 63);
    const std::int64_t last = first + static_cast<std::int64_t>(random() % 41) - 20;
    const Seeds seeds = seeds_of(std::to_string(first) + ".." + std::to_string(last));
    ASSERT_EQ(seeds.size(), static_cast<std::size_t>(std::abs(last - first)) + 1);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      const std::int64_t step = static_cast<std::int64_t>(i) * (last < first ? -1 : 1);
      EXPECT_EQ(seeds[i], static_cast<std::uint64_t>(first + step)) << first << ' ' << last;
    }
  }
}

TEST(Sweep, SpacesNumbersEvenlyWithBothEnds) {
  EXPECT_EQ(values_of("t=0.1..0.9:9"), (Texts{"0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9"}));
  EXPECT_EQ(values_of("t=0.9..0.1:3"), (Texts{"0.9", "0.5", "0.1"}));
  EXPECT_EQ(values_of("t=0..1:4"), (Texts{"0", "0.3333333333333333", "0.6666666666666666", "1"}));
  EXPECT_EQ(values_of("t=-1e-3..1e-3:3"), (Texts{"-0.001", "0", "0.001"}));
  EXPECT_EQ(values_of("t=1..1.001:2"), (Texts{"1", "1.001"}));
  EXPECT_EQ(values_of("t=-1e308..1e308:3"), (Texts{"-1e+308", "0", "1e+308"}));
}

TEST(Sweep, WholeNumbersListsUnitsAndMixtures) {
  EXPECT_EQ(values_of("levels=1..4"), (Texts{"1", "2", "3", "4"}));
  EXPECT_EQ(values_of("levels=2..-1"), (Texts{"2", "1", "0", "-1"}));
  EXPECT_EQ(values_of("levels=0..9:4"), (Texts{"0", "3", "6", "9"}));
  EXPECT_EQ(values_of("levels=1..3,8,5..6"), (Texts{"1", "2", "3", "8", "5", "6"}));
  EXPECT_EQ(values_of("motif=koch,levy,bud"), (Texts{"koch", "levy", "bud"}));
  EXPECT_EQ(values_of("w=0.1mm..0.3mm:3"), (Texts{"0.1mm", "0.2mm", "0.3mm"}));
  EXPECT_EQ(values_of("w=1..3mm"), (Texts{"1mm", "2mm", "3mm"}));
  EXPECT_EQ(values_of("a=1=2"), (Texts{"1=2"}));
}

TEST(Sweep, EveryNumberLiesWhereItShould) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> exponent(-6.0, 6.0);
  for (int round = 0; round < 200; ++round) {
    const double from = std::pow(10.0, exponent(random)) - 3.0;
    const double to = std::pow(10.0, exponent(random));
    const auto count = static_cast<std::size_t>(2 + random() % 40);
    const Texts texts = values_of("k=" + shortest_text(from) + ".." + shortest_text(to) + ":" + std::to_string(count));
    ASSERT_EQ(texts.size(), count);
    EXPECT_EQ(*parse_number(texts.front()), from);
    EXPECT_EQ(*parse_number(texts.back()), to);
    const double step = (to - from) / static_cast<double>(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(*parse_number(texts[i]), from + step * static_cast<double>(i),
                  (std::abs(from) + std::abs(to)) * 4e-15);
    }
  }
}

TEST(Sweep, RefusalsTeach) {
  EXPECT_TRUE(contains(sweep_problem("levels"), "--sweep name=1..5"));
  EXPECT_TRUE(contains(sweep_problem("=1"), "needs a knob"));
  EXPECT_TRUE(contains(sweep_problem("seed=0..9"), "--seed"));
  EXPECT_TRUE(contains(sweep_problem("t=0.1..0.9"), "say how many values '0.1..0.9' has: 0.1..0.9:5"));
  EXPECT_TRUE(contains(sweep_problem("t=1mm..2cm:3"), "different units"));
  EXPECT_TRUE(contains(sweep_problem("t=3..3"), "are the same"));
  for (const char* text : {"t=", "t=,", "t=1,", "t=a..b", "t=1..", "t=..2:3", "t=1...2", "t=1..2:", "t=1..2:1",
                           "t=1..2:0", "t=1..2:-3", "t=1..2:2.5", "t=1..2:1e3", "t=nan..1:3", "t=0..inf:3",
                           "t=1e400..2:3", "t=0..1:99999999999999999999", "t=1:2..3", "t=0..1e300"}) {
    EXPECT_TRUE(contains(sweep_problem(text), std::string("--sweep ") + text)) << text << sweep_problem(text);
  }
}

preset::Source source_of_knobs() {
  return {"k.toml",
          "burin = 1\nseed = 5\n[knobs]\nlevels = { default = 3, min = 0, max = 9 }\nturn = { default = 0.5 }\n"
          "motif = { default = \"koch\", choices = [\"koch\", \"levy\"] }\n"};
}

preset::Overrides with_knob(const std::string& name, const std::string& value) {
  preset::Overrides overrides;
  overrides.knobs.emplace_back(name, value);
  return overrides;
}

Result<Series> series_of(const Texts& sweeps, std::string_view seeds, const preset::Overrides& overrides = {},
                         double max_results = 1000.0) {
  SeriesRequest request;
  request.max_results = max_results;
  for (const std::string& sweep : sweeps) request.sweeps.push_back(*Sweep::read(sweep));
  if (!seeds.empty()) request.seeds.push_back(*SeedList::read(seeds));
  const preset::Source source = source_of_knobs();
  return Series::make(request, source, overrides, *preset::summarise(source, overrides));
}

std::string series_problems(const Texts& sweeps, std::string_view seeds, const preset::Overrides& overrides = {}) {
  const Result<Series> series = series_of(sweeps, seeds, overrides);
  return series ? std::string() : problems_text(series.problems());
}

TEST(Series, IsEveryCombinationAndTheLastAxisGoesFastest) {
  const Result<Series> series = series_of({"levels=1..3", "motif=koch,levy"}, "8,9");
  ASSERT_TRUE(series);
  ASSERT_EQ(series->count(), 12U);
  EXPECT_EQ(series->label(0), "levels=1 motif=koch seed=8");
  EXPECT_EQ(series->label(1), "levels=1 motif=koch seed=9");
  EXPECT_EQ(series->label(2), "levels=1 motif=levy seed=8");
  EXPECT_EQ(series->label(11), "levels=3 motif=levy seed=9");
  const preset::Overrides last = series->overrides(11, with_knob("turn", "1"));
  EXPECT_EQ(last.seed, 9U);
  EXPECT_EQ(last.knobs,
            (std::vector<std::pair<std::string, std::string>>{{"turn", "1"}, {"levels", "3"}, {"motif", "levy"}}));
}

TEST(Series, WithoutAxesIsOneResultWithThePresetsSeed) {
  const Result<Series> series = series_of({}, "");
  ASSERT_TRUE(series);
  EXPECT_EQ(series->count(), 1U);
  EXPECT_EQ(series->seed(0), 5U);
  EXPECT_EQ(series->overrides(0, {}).seed, std::nullopt);
  preset::Overrides other;
  other.seed = 8;
  EXPECT_EQ(series_of({}, "", other)->seed(0), 8U);
}

TEST(Series, IsHeldAgainstThePresetBeforeAnythingIsDrawn) {
  EXPECT_EQ(series_problems({"levls=1..3"}, ""),
            "--sweep levls=1..3: error: no knob 'levls'; did you mean 'levels'?\n");
  EXPECT_TRUE(contains(series_problems({"levels=8..11"}, ""), "'levels' = 10 is outside [0, 9]"));
  EXPECT_TRUE(contains(series_problems({"levels=8..11"}, ""), "'levels' = 11 is outside [0, 9]"));
  EXPECT_TRUE(contains(series_problems({"motif=koch,lvy"}, ""), "'motif' = lvy is none of its choices"));
  EXPECT_TRUE(contains(series_problems({"levels=1..7:3", "turn=x"}, ""), "turn")) << "all problems are told";
  EXPECT_EQ(series_problems({"levels=1..9:4"}, ""),
            "--sweep levels=1..9:4: error: 'levels' takes whole numbers, but 4 values from 1 to 9 have fractions "
            "between; :3 or :5 would fit\n");
  EXPECT_TRUE(contains(series_problems({"levels=1", "levels=2"}, ""), "swept twice"));
  EXPECT_TRUE(contains(series_problems({"levels=1,2"}, "", with_knob("levels", "3")), "also set by -D"));
}

TEST(Series, TooManyResultsAreALimit) {
  for (const char* seeds : {"0..1000", "0..18446744073709551615", "random*100000000000"}) {
    const Result<Series> series = series_of({"turn=0..1:9"}, seeds);
    ASSERT_FALSE(series);
    EXPECT_EQ(series.problems().front().trouble, Trouble::limit);
    EXPECT_TRUE(contains(series.problems().front().message, "--max-results"));
  }
  EXPECT_TRUE(contains(series_of({"turn=0..1:18446744073709551615", "levels=0..9"}, "0..9").problems().front().message,
                       "--max-results"));
  EXPECT_TRUE(series_of({"levels=0..9"}, "0..99"));
}

TEST(NamePattern, FillsInAndKeepsBraces) {
  const cli::NameValues values{{"a", "1"}, {"b", "x/y"}};
  EXPECT_EQ(NamePattern::read("o/{a}-{b}.svg")->fill(values), "o/1-x_y.svg");
  EXPECT_EQ(NamePattern::read("{{a}}{a}.svg")->fill(values), "{a}1.svg");
  EXPECT_EQ(NamePattern::read("{{a}}{a}.svg")->text(), "{{a}}{a}.svg");
  EXPECT_EQ(NamePattern::read("plain")->fill({}), "plain");
  EXPECT_FALSE(NamePattern::read("plain{{")->has_placeholders());
  for (const char* wrong : {"{", "}", "a{b", "a}b", "{a}}", "{{a}"}) EXPECT_FALSE(NamePattern::read(wrong)) << wrong;
  const Result<Done> unknown = NamePattern::read("{c}.svg")->check({"a", "b"});
  ASSERT_FALSE(unknown);
  EXPECT_TRUE(contains(unknown.problems().front().message, "there are {a}, {b}"));
  EXPECT_FALSE(NamePattern::read("{}.svg")->check({"a"}));
}

TEST(NamePattern, AddsBeforeTheSuffix) {
  const auto added = [](const char* path) {
    NamePattern pattern = *NamePattern::read(path);
    pattern.add("n");
    return pattern.text();
  };
  EXPECT_EQ(added("a.svg"), "a-{n}.svg");
  EXPECT_EQ(added("o.d/a.b.svg"), "o.d/a.b-{n}.svg");
  EXPECT_EQ(added("o.d/a"), "o.d/a-{n}");
  EXPECT_EQ(added("{x}.svg"), "{x}-{n}.svg");
  EXPECT_EQ(added("o.d/{x}"), "o.d/{x}-{n}");
  EXPECT_EQ(added("a.{x}"), "a-{n}.{x}");
  EXPECT_EQ(added(".svg"), ".svg-{n}");
  EXPECT_EQ(added("o/.svg"), "o/.svg-{n}");
}

TEST(NamePattern, ValuesAreSafeInFileNames) {
  EXPECT_EQ(cli::name_safe("0.25"), "0.25");
  EXPECT_EQ(cli::name_safe("-3"), "-3");
  EXPECT_EQ(cli::name_safe("../../etc/passwd"), ".._.._etc_passwd");
  EXPECT_EQ(cli::name_safe(".."), "__");
  EXPECT_EQ(cli::name_safe(""), "_");
  EXPECT_EQ(cli::name_safe("#ff0000"), "_ff0000");
  EXPECT_EQ(cli::name_safe(std::string_view("a\0b\n", 4)), "a_b_");
  EXPECT_EQ(cli::name_safe("gr\xc3\xbcn"), "gr\xc3\xbcn");
  EXPECT_EQ(cli::name_safe(std::string(5000, 'x')).size(), 100U);
}

TEST(TbbExecutor, RunsEveryTaskOnceOnSeveralThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> runs(100);
    TbbExecutor(threads).run(runs.size(), [&](std::size_t i) { ++runs[i]; });
    for (const std::atomic<int>& one : runs) EXPECT_EQ(one, 1);
  }
  // Two tasks that wait for each other end only when both run at once.
  std::atomic<int> met = 0;
  TbbExecutor(2).run(2, [&](std::size_t) {
    ++met;
    for (int i = 0; i < 10000 && met < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  EXPECT_EQ(met, 2);
}

TEST(TbbExecutor, SmallWorkStaysOnTheCallingThread) {
  const auto here = std::this_thread::get_id();
  TbbExecutor(8).run(1, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
  TbbExecutor(1).run(3, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
}

TEST(TbbExecutor, AnExceptionReachesTheCaller) {
  EXPECT_THROW(TbbExecutor(2).run(4,
                                  [](std::size_t i) {
                                    if (i == 1) throw std::bad_alloc();
                                  }),
               std::bad_alloc);
}

TEST(MemoryBudget, DrawingsTogetherStayWithinIt) {
  cli::MemoryBudget budget(10.0);
  std::mutex mutex;
  double used = 0.0;
  double most = 0.0;
  TbbExecutor(4).run(40, [&](std::size_t i) {
    const double bytes = i % 7 == 3 ? 50.0 : 4.0;
    const cli::MemoryBudget::Share share(&budget, bytes);
    {
      const std::lock_guard lock(mutex);
      used += bytes;
      most = std::max(most, used > 50.0 ? 1000.0 : used == 50.0 ? 0.0 : used);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(mutex);
    used -= bytes;
  });
  EXPECT_LE(most, 10.0);
  EXPECT_GT(most, 0.0);
}

}  // namespace
}  // namespace burin::test
