#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "cli/tool.hpp"

/// `burin watch`: the drawing follows its preset and data however they are saved.
namespace burin::test {
namespace {

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

std::string preset_with(int levels) {
  return "burin = 1\n[[layer]]\nname = \"curve\"\ncurve = { family = \"two-point\", levels = " +
         std::to_string(levels) + " }\n";
}

/// Whether something comes true in time; far more of it than a loaded machine should need.
bool soon(const std::function<bool()>& happens) {
  const Clock::time_point end = Clock::now() + std::chrono::seconds(20);
  while (!happens()) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// `burin watch` in a folder of its own, and what it has drawn.
class Watched {
 public:
  explicit Watched(const std::string& text, std::vector<std::string> options = {}) {
    folder_.write("a.toml", text);
    options.insert(options.begin(), {"watch", "a.toml"});
    ToolSetup setup;
    setup.folder = folder_.path().string();
    tool_.emplace(tool_words(std::move(options)), setup);
  }

  const TemporaryFolder& folder() const { return folder_; }

  /// Whether the drawing becomes that of the preset, which `burin draw` makes elsewhere.
  bool becomes(const std::string& text, const std::string& output = "a.svg") const {
    const TemporaryFolder elsewhere;
    elsewhere.write("a.toml", text);
    if (folder_.has("points.csv")) elsewhere.write("points.csv", folder_.read("points.csv"));
    EXPECT_EQ(burin_in(elsewhere, {"draw", "a.toml", "-q", "-o", output}).code, 0);
    return soon([&] { return folder_.has(output) && folder_.read(output) == elsewhere.read(output); });
  }

  Finished stopped_by(int signal) {
    tool_->send(signal);
    return tool_->wait();
  }

 private:
  TemporaryFolder folder_;
  std::optional<RunningTool> tool_;
};

TEST(Watch, FollowsEveryWayOfSaving) {
  Watched watched(preset_with(1));
  const TemporaryFolder& folder = watched.folder();
  EXPECT_TRUE(watched.becomes(preset_with(1)));

  folder.write("a.toml", preset_with(2));  // in place
  EXPECT_TRUE(watched.becomes(preset_with(2)));

  folder.write("a.toml~", preset_with(3));  // beside, and renamed
  fs::rename(folder.file("a.toml~"), folder.file("a.toml"));
  EXPECT_TRUE(watched.becomes(preset_with(3)));

  fs::rename(folder.file("a.toml"), folder.file("a.bak"));  // the old one moved away, a new one made
  folder.write("a.toml", preset_with(4));
  EXPECT_TRUE(watched.becomes(preset_with(4)));

  fs::remove(folder.file("a.toml"));  // removed for a while
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  folder.write("a.toml", preset_with(5));
  EXPECT_TRUE(watched.becomes(preset_with(5)));

  fs::create_directory(folder.path() / "real");  // replaced by a link, whose target is then saved
  folder.write("real/b.toml", preset_with(1));
  fs::create_symlink("real/b.toml", folder.path() / "link");
  fs::rename(folder.file("link"), folder.file("a.toml"));
  EXPECT_TRUE(watched.becomes(preset_with(1)));
  folder.write("real/b.tmp", preset_with(2));
  fs::rename(folder.file("real/b.tmp"), folder.file("real/b.toml"));
  EXPECT_TRUE(watched.becomes(preset_with(2)));

  fs::rename(folder.path() / "real", folder.path() / "old");  // the folder of the target made anew
  fs::create_directory(folder.path() / "real");
  folder.write("real/b.toml", preset_with(3));
  EXPECT_TRUE(watched.becomes(preset_with(3)));

  const Finished finished = watched.stopped_by(SIGINT);
  EXPECT_EQ(finished.code, 130);
  EXPECT_TRUE(contains(finished.out, "a.svg: ")) << finished.out;
}

TEST(Watch, FollowsDataFilesOnceTheyAreNamed) {
  const std::string with_data =
      "burin = 1\n[[layer]]\ncurve = { family = \"two-point\", base = { csv = \"points.csv\" }, levels = 1 }\n";
  Watched watched(preset_with(1));
  EXPECT_TRUE(watched.becomes(preset_with(1)));
  watched.folder().write("points.csv", "0,0\n3,1\n");
  watched.folder().write("a.toml", with_data);
  EXPECT_TRUE(watched.becomes(with_data));
  watched.folder().write("points.csv", "0,0\n1,3\n4,4\n");
  EXPECT_TRUE(watched.becomes(with_data));
  EXPECT_EQ(watched.stopped_by(SIGTERM).code, 143);
}

TEST(Watch, KeepsTheLastGoodDrawingAndShowsWhatIsWrong) {
  Watched watched(preset_with(1), {"-o", "a.svg", "-o", "a.csv"});
  EXPECT_TRUE(watched.becomes(preset_with(1)));
  EXPECT_TRUE(watched.becomes(preset_with(1), "a.csv"));
  const std::string before = watched.folder().read("a.svg");
  watched.folder().write("a.toml", "burin = 1\n[[layer]]\ncurve = { family = \"two-pint\" }\n");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_TRUE(watched.folder().read("a.svg") == before);
  watched.folder().write("a.toml", preset_with(2));
  EXPECT_TRUE(watched.becomes(preset_with(2)));
  EXPECT_TRUE(watched.becomes(preset_with(2), "a.csv"));
  const Finished finished = watched.stopped_by(SIGINT);
  EXPECT_TRUE(contains(finished.err, "a.toml:3:")) << finished.err;
  EXPECT_TRUE(contains(finished.err, "a.svg, a.csv stays as it was until a.toml is right")) << finished.err;
  EXPECT_EQ(watched.folder().names(), (std::vector<std::string>{"a.csv", "a.svg", "a.toml"}));
}

TEST(Watch, DrawsSoonAndOnlyWhenSomethingChanged) {
  Watched watched(preset_with(1));
  EXPECT_TRUE(watched.becomes(preset_with(1)));
  const TemporaryFolder& folder = watched.folder();
  Clock::duration fastest = std::chrono::seconds(20);
  for (const int levels : {2, 3, 4}) {
    const fs::file_time_type before = fs::last_write_time(folder.file("a.svg"));
    const Clock::time_point saved = Clock::now();
    folder.write("a.toml", preset_with(levels));
    EXPECT_TRUE(soon([&] { return fs::last_write_time(folder.file("a.svg")) != before; }));
    fastest = std::min(fastest, Clock::now() - saved);
    EXPECT_TRUE(watched.becomes(preset_with(levels)));
  }
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(fastest).count();
  RecordProperty("fastest_ms", static_cast<int>(milliseconds));
  EXPECT_LT(milliseconds, 500) << "from the end of writing to the new drawing";  // 20 on two cores that were busy

  folder.write("other.txt", "not ours");
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const std::string lines = watched.stopped_by(SIGINT).out;
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 4) << lines;
}

TEST(Watch, RefusesWhatItCannotFollow) {
  const TemporaryFolder folder;
  folder.write("a.toml", preset_with(1));
  const auto expect_problem = [&](const std::vector<std::string>& words, int code, const std::string& message) {
    const Finished run = burin_in(folder, words);
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_TRUE(contains(run.err, message)) << run.err;
  };
  expect_problem({"watch"}, 2, "burin watch: error: say what to draw");
  expect_problem({"watch", "-"}, 2, "stdin does not change");
  expect_problem({"watch", "a.toml", "-o", "-"}, 2, "not stdout");
  expect_problem({"watch", "a.toml", "--seed", "1..3"}, 2, "one seed at a time");
  expect_problem({"watch", "a.toml", "--sweep", "a=1..3"}, 2, "--sweep");
  expect_problem({"watch", "missing.toml"}, 3, "missing.toml");
}

TEST(Watch, DoesNotDrawOverWhatItDrawsFrom) {
  const std::string with_data =
      "burin = 1\n[[layer]]\ncurve = { family = \"two-point\", base = { csv = \"points.csv\" }, levels = 1 }\n";
  const TemporaryFolder folder;
  folder.write("a.toml", with_data);
  folder.write("points.csv", "0,0\n3,1\n");
  ToolSetup setup;
  setup.folder = folder.path().string();
  RunningTool tool(tool_words({"watch", "a.toml", "-o", "./points.csv"}), setup);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  tool.send(SIGINT);
  const Finished finished = tool.wait();
  EXPECT_TRUE(contains(finished.err, "is what the drawing is made from")) << finished.err;
  EXPECT_EQ(folder.read("points.csv"), "0,0\n3,1\n");
}

}  // namespace
}  // namespace burin::test
