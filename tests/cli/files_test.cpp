#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>

#include <gtest/gtest.h>

#include <cli/atomic_file.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

using Names = std::vector<std::string>;
namespace fs = std::filesystem;

mode_t mode_of(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777U : 0;
}

/// A drawing that takes minutes.
Names endless(const std::string& output) {
  return {"draw", "p.toml", "--all-points", "--max-points", "1e12", "-D", "levels=18", "-o", output, "--format", "svg"};
}

ToolSetup setup_of(const TemporaryFolder& folder) {
  return {folder.path().string(), {}, {}, {}};
}

void wait_until(const std::function<bool()>& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(condition());
}

/// The names in the folder but for those the test put there.
bool has_temporary(const TemporaryFolder& folder) {
  for (const std::string& name : folder.names()) {
    if (name.substr(0, 7) == ".burin-") return true;
  }
  return false;
}

TEST(Files, AnInterruptLeavesTheOldFileAndNoTemporary) {
  for (const auto& [signal, code] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGHUP, 129)}) {
    const TemporaryFolder folder;
    folder.write("p.toml", koch_text);
    folder.write("a.svg", "old");
    RunningTool tool(tool_words(endless("a.svg")), setup_of(folder));
    wait_until([&] { return has_temporary(folder); });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const auto sent = std::chrono::steady_clock::now();
    tool.send(signal);
    const Finished run = tool.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(2));
    EXPECT_EQ(run.code, code);
    EXPECT_EQ(run.out + run.err, "");
    EXPECT_EQ(folder.read("a.svg"), "old");
    EXPECT_EQ(folder.names(), (Names{"a.svg", "p.toml"}));
  }
}

TEST(Files, AnIgnoredInterruptStaysIgnored) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  ToolSetup setup = setup_of(folder);
  setup.in_child = [] { std::signal(SIGINT, SIG_IGN); };
  RunningTool tool(tool_words(endless("a.svg")), setup);
  wait_until([&] { return has_temporary(folder); });
  tool.send(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_TRUE(has_temporary(folder));
  tool.send(SIGTERM);
  EXPECT_EQ(tool.wait().code, 143);
}

TEST(Files, AnInterruptIsHeardWhileNobodyReadsThePipe) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  RunningTool tool(tool_words(endless("-")), setup_of(folder));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  tool.send(SIGINT);
  EXPECT_EQ(tool.wait(std::chrono::seconds(10)).code, 130);
}

TEST(Files, AnInterruptIsHeardWhileAFifoWaitsForItsReader) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  ASSERT_EQ(mkfifo(folder.file("fifo").c_str(), 0600), 0);
  RunningTool tool(tool_words(endless("fifo")), setup_of(folder));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  tool.send(SIGINT);
  EXPECT_EQ(tool.wait(std::chrono::seconds(10)).code, 130);
}

TEST(Files, AFifoIsWrittenDirectly) {
  const TemporaryFolder folder;
  const Finished run = shell_in(folder,
                                "mkfifo fifo; cat fifo > copy & burin draw koch -q -o fifo --format svg; wait; "
                                "burin draw koch -q -o a.svg; cmp copy a.svg; test -p fifo");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(Files, TheNextRunSweepsWhatADeadOneLeft) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  {
    RunningTool tool(tool_words(endless("a.svg")), setup_of(folder));
    wait_until([&] { return has_temporary(folder); });
    tool.send(SIGKILL);
    EXPECT_EQ(tool.wait().code, 128 + SIGKILL);
  }
  EXPECT_TRUE(has_temporary(folder));
  folder.write(".burin-notes.tmp", "mine");
  folder.write(".burin-1-0.tmp", "of a living process");
  EXPECT_EQ(burin_in(folder, {"draw", "p.toml", "-q"}).code, 0);
  EXPECT_EQ(folder.names(), (Names{".burin-1-0.tmp", ".burin-notes.tmp", "p.svg", "p.toml"}));
}

TEST(Files, ALivingRunIsNotSwept) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  RunningTool tool(tool_words(endless("a.svg")), setup_of(folder));
  wait_until([&] { return has_temporary(folder); });
  EXPECT_EQ(burin_in(folder, {"draw", "p.toml", "-q"}).code, 0);
  EXPECT_TRUE(has_temporary(folder));
  tool.send(SIGTERM);
  EXPECT_EQ(tool.wait().code, 143);
}

TEST(Files, AFullDiskLeavesTheOldFileAndTellsWhatToDo) {
  // Not 0, with which the thread sanitizer cannot start a program.
  for (const rlim_t limit : {rlim_t{1}, rlim_t{1000}, rlim_t{100000}}) {
    const TemporaryFolder folder;
    folder.write("a.svg", "old");
    ToolSetup setup;
    setup.in_child = [limit] {
      const rlimit size{limit, limit};
      if (setrlimit(RLIMIT_FSIZE, &size) != 0) _exit(125);
    };
    const Finished run = burin_in(folder, {"draw", "koch", "--all-points", "-D", "levels=9", "-o", "a.svg"}, setup);
    EXPECT_EQ(run.code, 5) << limit;
    EXPECT_TRUE(contains(run.err, "a.svg: error: cannot be written: File too large; free some space")) << run.err;
    EXPECT_EQ(folder.read("a.svg"), "old");
    EXPECT_EQ(folder.names(), Names{"a.svg"});
  }
}

TEST(Files, ADeviceThatIsFull) {
  const TemporaryFolder folder;
  for (const char* format : {"svg", "csv", "dump"}) {
    const Finished run = burin_in(folder, {"draw", "koch", "-D", "levels=3", "--format", format, "-o", "/dev/full"});
    EXPECT_EQ(run.code, 5) << format;
    EXPECT_TRUE(contains(run.err, "/dev/full: error: cannot be written: No space left on device")) << run.err;
  }
  EXPECT_TRUE(folder.names().empty());
  const Finished list = shell_in(folder, "burin list > /dev/full");
  EXPECT_EQ(list.code, 5);
  EXPECT_TRUE(contains(list.err, "stdout: error: ")) << list.err;
  const Finished pipe = shell_in(folder, "burin draw koch -q -o - > /dev/full");
  EXPECT_EQ(pipe.code, 5);
  EXPECT_TRUE(contains(pipe.err, "stdout: error: ")) << pipe.err;
}

TEST(Files, AClosedPipeIsQuiet) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  for (const Names& words : {Names{"list"}, Names{"--help"}, endless("-")}) {
    ToolSetup setup = setup_of(folder);
    // The reading end is gone before the tool begins.
    setup.in_child = [] {
      std::array<int, 2> ends{};
      if (pipe2(ends.data(), O_CLOEXEC) != 0 || dup2(ends[1], STDOUT_FILENO) < 0) _exit(125);
      close(ends[0]);
    };
    const Finished run = RunningTool(tool_words(words), setup).wait();
    EXPECT_EQ(run.code, 5) << words.front();
    EXPECT_EQ(run.err, "") << words.front();
  }
}

TEST(Files, AClosedStdoutNeverTurnsIntoAFile) {
  const TemporaryFolder folder;
  ToolSetup setup;
  setup.in_child = [] { close(STDOUT_FILENO); };
  const Finished run = burin_in(folder, {"draw", "koch", "-o", "a.svg"}, setup);
  EXPECT_EQ(run.code, 5);
  EXPECT_FALSE(contains(folder.read("a.svg"), "points drawn"));
}

TEST(Files, PlacesThatCannotBeWrittenAreFoundBeforeTheWork) {
  const TemporaryFolder folder;
  folder.write("p.toml", koch_text);
  folder.write("file", "");
  fs::create_directory(folder.path() / "folder.svg");
  for (const auto& [path, said] :
       {std::pair("missing/a.svg", "make its folder first"), std::pair("file/a.svg", "make its folder first"),
        std::pair("folder.svg", "name a file in it"), std::pair("/proc/self/a.svg", "cannot be written"),
        std::pair("", "name of a file")}) {
    Names words = endless("good.svg");
    words.insert(words.end(), {"-o", path});
    if (std::string(path).empty()) words = {"draw", "p.toml", "-o", ""};
    const auto begin = std::chrono::steady_clock::now();
    const Finished run = burin_in(folder, words);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << path;
    EXPECT_EQ(run.code, std::string(path).empty() ? 2 : 5) << path << run.err;
    EXPECT_TRUE(contains(run.err, said)) << run.err;
    EXPECT_EQ(folder.names(), (Names{"file", "folder.svg", "p.toml"})) << path;
  }
}

TEST(Files, SymbolicLinksStayAndTheirTargetIsReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "real");
  folder.write("real/a.svg", "old");
  fs::create_symlink("real/a.svg", folder.path() / "link.svg");
  fs::create_symlink("link.svg", folder.path() / "link2.svg");
  fs::create_symlink("real/b.svg", folder.path() / "dangling.svg");
  fs::create_symlink("round.svg", folder.path() / "round.svg");
  EXPECT_EQ(burin_in(folder, {"draw", "koch", "-q", "-o", "link2.svg", "-o", "dangling.svg"}).code, 0);
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.svg"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link2.svg"));
  EXPECT_TRUE(contains(folder.read("real/a.svg"), "<svg"));
  EXPECT_EQ(folder.read("real/b.svg"), folder.read("real/a.svg"));
  EXPECT_EQ(burin_in(folder, {"draw", "koch", "-q", "-o", "round.svg"}).code, 5);
}

TEST(Files, ModesAreKeptOrFollowTheUmask) {
  const TemporaryFolder folder;
  folder.write("old.svg", "old");
  fs::permissions(folder.path() / "old.svg", static_cast<fs::perms>(0604));
  ToolSetup setup;
  setup.in_child = [] { umask(027); };
  EXPECT_EQ(burin_in(folder, {"draw", "koch", "-q", "-o", "old.svg", "-o", "new.svg"}, setup).code, 0);
  EXPECT_EQ(mode_of(folder.file("old.svg")), 0604U);
  EXPECT_EQ(mode_of(folder.file("new.svg")), 0640U);
}

TEST(AtomicFile, NothingAppearsBeforeTheCommit) {
  const TemporaryFolder folder;
  folder.write("a", "old");
  cli::Temporaries temporaries;
  {
    const auto file = cli::AtomicFile::open(folder.file("a"), temporaries, {});
    ASSERT_TRUE(file);
    EXPECT_TRUE((*file)->write(std::string(1 << 20, 'x')));
    EXPECT_EQ(folder.read("a"), "old");
    EXPECT_EQ((*file)->byte_count(), 1U << 20U);
  }
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
  const auto file = cli::AtomicFile::open(folder.file("a"), temporaries, {});
  ASSERT_TRUE(file);
  EXPECT_TRUE((*file)->write("new"));
  EXPECT_TRUE((*file)->commit());
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(AtomicFile, RemovingAllTemporariesTakesThemAway) {
  const TemporaryFolder folder;
  cli::Temporaries temporaries;
  const auto file = cli::AtomicFile::open(folder.file("a"), temporaries, {});
  ASSERT_TRUE(file);
  EXPECT_TRUE(has_temporary(folder));
  temporaries.remove_all();
  EXPECT_FALSE(has_temporary(folder));
  EXPECT_FALSE((*file)->commit());
}

}  // namespace
}  // namespace burin::test
