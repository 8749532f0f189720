#include <sys/resource.h>
#include <thread>

#include <gtest/gtest.h>

#include "cli/tool.hpp"

/// Many results from one command.
namespace burin::test {
namespace {

using Names = std::vector<std::string>;
namespace fs = std::filesystem;

/// A coast whose bumps the seed turns.
constexpr const char* coast_text =
    "burin = 1\n"
    "seed = 12\n"
    "[knobs]\n"
    "levels = { default = 3, min = 0, max = 18, doc = \"refinement levels\" }\n"
    "bump = { default = 0.3, min = 0, max = 0.6, doc = \"height of a bump\" }\n"
    "ink = { default = \"black\", kind = \"color\" }\n"
    "[pens]\n"
    "ink = { color = \"$ink\", width = \"0.3mm\" }\n"
    "[[layer]]\n"
    "name = \"coast\"\n"
    "curve = { family = \"two-point\", levels = \"$levels\", motif = { marks = [[\"1/3\", 0], [0.5, \"$bump\"], "
    "[\"2/3\", 0]], sign = \"random\" } }\n";

Names names_in(const fs::path& folder) {
  Names names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Runs, SeedsGoIntoFilesOfAFolderThatIsMade) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  const Finished run = burin_in(folder, {"draw", "coast.toml", "--seed", "0..2,7", "-o", "out/{preset}-{seed}.svg"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(names_in(folder.path() / "out"), (Names{"coast-0.svg", "coast-1.svg", "coast-2.svg", "coast-7.svg"}));
  EXPECT_NE(folder.read("out/coast-0.svg"), folder.read("out/coast-1.svg"));
  // A line each, in order.
  std::size_t at = 0;
  for (const char* name : {"out/coast-0.svg: ", "out/coast-1.svg: ", "out/coast-2.svg: ", "out/coast-7.svg: "}) {
    at = run.out.find(name, at);
    ASSERT_NE(at, std::string::npos) << run.out;
  }
}

TEST(Runs, EachFileIsTheSingleDrawing) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  ASSERT_EQ(burin_in(folder, {"draw", "coast.toml", "-q", "--seed", "3,4", "--sweep", "bump=0.1..0.5:3", "-D",
                              "levels=2", "-o", "{n}.svg"})
                .code,
            0);
  ASSERT_EQ(
      burin_in(folder, {"draw", "coast.toml", "-q", "--seed", "4", "-D", "levels=2", "-D", "bump=0.3", "-o", "s.svg"})
          .code,
      0);
  EXPECT_EQ(folder.read("4.svg"), folder.read("s.svg"));
  EXPECT_TRUE(contains(folder.read("s.svg"), "bump=0.3"));
}

TEST(Runs, TheNumberOfThreadsChangesNothing) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  Names formats{"svg", "csv", "dump"};
  Names words{"draw", "coast.toml", "--seed", "0..11", "-D", "levels=4"};
#ifdef BURIN_HAS_CAIRO
  formats.insert(formats.end(), {"pdf", "png"});
  words.insert(words.end(), {"--size", "200px"});
#endif
  Finished one;
  for (const char* threads : {"1", "2", "5"}) {
    Names all = words;
    all.insert(all.end(), {"--threads", threads});
    for (const std::string& format : formats) all.insert(all.end(), {"-o", format + "/{seed}." + format});
    const Finished run = burin_in(folder, all);
    ASSERT_EQ(run.code, 0) << run.err;
    if (*threads == '1') {
      one = run;
    } else {
      EXPECT_EQ(run.out, one.out) << threads;
    }
    for (const std::string& format : formats) {
      const fs::path kept = folder.path() / (format + "-1");
      if (*threads == '1') {
        fs::rename(folder.path() / format, kept);
        continue;
      }
      ASSERT_EQ(names_in(kept), names_in(folder.path() / format));
      for (const std::string& name : names_in(kept)) {
        EXPECT_TRUE(folder.read(format + "-1/" + name) == folder.read(format + "/" + name)) << name << threads;
      }
      fs::remove_all(folder.path() / format);
    }
  }
}

#ifdef BURIN_HAS_CAIRO
TEST(Runs, CairosSvgDoesNotDependOnItsNeighbours) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  for (const char* threads : {"1", "3"}) {
    ASSERT_EQ(burin_in(folder, {"draw", "coast.toml", "-q", "--seed", "0..5", "--backend", "cairo", "--threads",
                                threads, "-o", std::string(threads) + "/{seed}.svg"})
                  .code,
              0);
  }
  for (const std::string& name : names_in(folder.path() / "1")) {
    EXPECT_TRUE(folder.read("1/" + name) == folder.read("3/" + name)) << name;
  }
}
#endif

TEST(Runs, WhatTellsResultsApartIsAddedAndSaid) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  const Finished run =
      burin_in(folder, {"draw", "coast.toml", "--seed", "0,1", "--sweep", "levels=1,2", "-o", "a.svg"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "note: 4 results go to a-{levels}-{seed}.svg\n");
  EXPECT_EQ(folder.names(), (Names{"a-1-0.svg", "a-1-1.svg", "a-2-0.svg", "a-2-1.svg", "coast.toml"}));
  EXPECT_EQ(burin_in(folder, {"draw", "coast.toml", "-q", "--seed", "8,9"}).err, "");
  EXPECT_TRUE(folder.has("coast-8.svg") && folder.has("coast-9.svg"));
  const Finished numbered = burin_in(folder, {"draw", "coast.toml", "--seed", "1..10", "-o", "n/{n}.csv"});
  EXPECT_EQ(numbered.err, "");
  EXPECT_EQ(names_in(folder.path() / "n").front(), "01.csv");
  EXPECT_EQ(names_in(folder.path() / "n").back(), "10.csv");
  EXPECT_EQ(burin_in(folder, {"draw", "coast.toml", "-q", "-o", "{preset}-of-{seed}{{}}.svg"}).code, 0);
  EXPECT_TRUE(folder.has("coast-of-12{}.svg"));
}

TEST(Runs, NoTwoResultsInOneFile) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  fs::create_directory(folder.path() / "real");
  fs::create_directory_symlink("real", folder.path() / "link");
  for (const Names& wrong : {Names{"--seed", "1,1", "-o", "{seed}.svg"}, Names{"--seed", "3..5,4", "-o", "a.svg"},
                             Names{"--sweep", "ink=#ff0000,_ff0000", "-o", "{ink}.svg"},
                             Names{"--seed", "1,2", "-o", "real/{seed}.svg", "-o", "link/{seed}.svg"}}) {
    Names words{"draw", "coast.toml"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const Finished run = burin_in(folder, words);
    EXPECT_NE(run.code, 0);
    EXPECT_TRUE(contains(run.err, "error: ")) << run.err;
  }
  EXPECT_TRUE(contains(burin_in(folder, {"draw", "coast.toml", "--seed", "1,1", "-o", "{seed}.svg"}).err,
                       "two results would be written to 1.svg: seed=1 and seed=1"));
  EXPECT_EQ(folder.names(), (Names{"coast.toml", "link", "real"}));
  EXPECT_TRUE(fs::is_empty(folder.path() / "real"));
}

TEST(Runs, WrongCommandLinesTeach) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  struct Case {
    Names options;
    int code;
    const char* said;
  };
  for (const Case& c :
       {Case{{"--seed", "0..9", "-o", "-"}, 2, "cannot go into one stream"},
        Case{{"--seed", "0..9", "-o", "/dev/stdout"}, 2, "cannot go into one stream"},
        Case{{"-o", "{sed}.svg"}, 2, "there are {preset}, {seed}, {n}"},
        Case{{"--sweep", "levels=1,2", "-o", "{lvls}.svg"}, 2, "{n}, {levels}"},
        Case{{"-o", "{seed.svg"}, 2, "'{' without '}'"}, Case{{"--seed", "0..1e18"}, 2, "--seed must be"},
        Case{{"--seed", "0..1000000000000000000"}, 4, "--max-results"},
        Case{{"--seed", "0..9", "--max-results", "9"}, 4, "10 results are more than 9"},
        Case{{"--sweep", "levels"}, 2, "needs a knob"},
        Case{{"--sweep", "levels=17..19"}, 3, "'levels' = 19 is outside [0, 18]"},
        Case{{"--threads", "0"}, 2, "--threads"}}) {
    Names words{"draw", "coast.toml"};
    words.insert(words.end(), c.options.begin(), c.options.end());
    const Finished run = burin_in(folder, words);
    EXPECT_EQ(run.code, c.code) << c.said << run.err;
    EXPECT_TRUE(contains(run.err, c.said)) << run.err;
  }
  EXPECT_EQ(folder.names(), Names{"coast.toml"});
}

TEST(Runs, AResultThatFailsLeavesTheOthers) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  const Finished run = burin_in(folder, {"draw", "coast.toml", "--all-points", "--max-points", "1000", "--sweep",
                                         "levels=3..6", "--seed", "1,2"});
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_TRUE(contains(run.err, "[levels=5 seed=1 and 1 more]")) << run.err;
  EXPECT_TRUE(contains(run.err, "[levels=6 seed=1 and 1 more]")) << run.err;
  EXPECT_TRUE(contains(run.err, "4 of 8 results are drawn\n")) << run.err;
  EXPECT_EQ(folder.names(), (Names{"coast-3-1.svg", "coast-3-2.svg", "coast-4-1.svg", "coast-4-2.svg", "coast.toml"}));
}

TEST(Runs, WhatIsWrongWithThePresetIsSaidOnce) {
  const TemporaryFolder folder;
  folder.write("bad.toml", std::string(coast_text) + "pen = \"inc\"\n");
  const Finished run = burin_in(folder, {"draw", "bad.toml", "--seed", "0..49"});
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err.find("'inc'"), run.err.rfind("'inc'")) << run.err;
  EXPECT_EQ(folder.names(), Names{"bad.toml"});
}

TEST(Runs, SeedsForAPieceWithoutRandomnessAreWarnedAbout) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  const Names words{"draw", "p.toml", "--seed", "0..1", "-o", "{seed}.svg"};
  const Finished run = burin_in(folder, words);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "warning: nothing in 'p.toml' is random: every seed gives the same picture\n");
  EXPECT_TRUE(folder.has("0.svg") && folder.has("1.svg"));
  Names quiet = words;
  quiet.emplace_back("-q");
  EXPECT_EQ(burin_in(folder, quiet).err, "");
  EXPECT_EQ(burin_in(folder, {"draw", "p.toml", "--seed", "3"}).err, "");
}

TEST(Runs, AnInterruptInTheMiddleKeepsWholeFilesOnly) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  RunningTool tool(tool_words({"draw", "coast.toml", "--all-points", "--max-points", "1e12", "--threads", "2",
                               "--sweep", "levels=1..18", "-o", "out/{levels}.svg"}),
                   {folder.path().string(), {}, {}, {}});
  const fs::path first = folder.path() / "out/1.svg";
  for (int i = 0; i < 1000 && !fs::exists(first); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  tool.send(SIGINT);
  const Finished run = tool.wait(std::chrono::seconds(20));
  EXPECT_EQ(run.code, 130);
  EXPECT_TRUE(contains(run.err, " of 18 results are drawn\n")) << run.err;
  const Names names = names_in(folder.path() / "out");
  EXPECT_GE(names.size(), 1U);
  EXPECT_LT(names.size(), 18U);
  for (const std::string& name : names) {
    EXPECT_NE(name.front(), '.') << name;
    const std::string svg = folder.read("out/" + name);
    EXPECT_TRUE(svg.size() > 7 && svg.substr(svg.size() - 7) == "</svg>\n") << name;
  }
}

TEST(Runs, AFullDiskEndsTheRun) {
  const TemporaryFolder folder;
  folder.write("coast.toml", coast_text);
  ToolSetup setup;
  setup.in_child = [] {
    const rlimit size{500, 500};
    if (setrlimit(RLIMIT_FSIZE, &size) != 0) _exit(125);
  };
  const Finished run = burin_in(folder, {"draw", "coast.toml", "--threads", "1", "--seed", "0..49"}, setup);
  EXPECT_EQ(run.code, 5);
  EXPECT_TRUE(contains(run.err, "coast-0.svg: error: cannot be written: File too large")) << run.err;
  EXPECT_FALSE(contains(run.err, "coast-1.svg")) << run.err;
  EXPECT_TRUE(contains(run.err, "0 of 50 results are drawn")) << run.err;
  EXPECT_EQ(folder.names(), Names{"coast.toml"});
}

TEST(Runs, AFolderThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  const Finished run = burin_in(folder, {"draw", "koch", "-o", "a/b/c.svg"});
  EXPECT_EQ(run.code, 5);
  EXPECT_TRUE(contains(run.err, "the folder 'a' is missing")) << run.err;
  folder.write("file", "");
  const Finished blocked = burin_in(folder, {"draw", "koch", "-o", "file/{seed}.svg"});
  EXPECT_EQ(blocked.code, 5);
  EXPECT_TRUE(contains(blocked.err, "file/1.svg: error: cannot be written")) << blocked.err;
}

}  // namespace
}  // namespace burin::test
