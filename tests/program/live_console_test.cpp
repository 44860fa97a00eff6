// What a person types while the robot runs.
#include "program/run/live_console.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/engine/frame_fixture.h"
#include "tests/temporary_folder.h"
#include "workbench/files/parameter_file.h"

namespace reorient {
namespace {

constexpr const char* kLamp = R"(param { level = { 0.5, range = { 0, 1 }, unit = "m", doc = "how bright" } }
behavior "tested" { initial = "off", state "off" {} })";
constexpr const char* kScene = R"(param { pace = { 1, range = { 0, 2 }, doc = "how fast" } }
scenario "scene" { behaviors = {}, initial = "waiting", state "waiting" {} })";

class LiveConsoleTest : public ::testing::Test {
 protected:
  LiveConsoleTest() {
    if (pipe(ends_) != 0) ADD_FAILURE() << "no pipe";
    ScriptTexts texts;
    texts.apply({"scenarios/scene.lua", ScriptText{kScene, ""}});
    scenario.emplace(texts, "scene", std::vector<ParameterChange>{}, nobody_);
    console.emplace(ends_[0], out_, &*scenario, [this] {
      std::vector<Parameter> all = loop.engine->parameters();
      for (const Parameter& parameter : scenario->parameters().list()) all.push_back(parameter);
      return all;
    });
    poll();
  }
  ~LiveConsoleTest() override {
    close(ends_[0]);
    close_writing();
  }

  void close_writing() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  void type(const std::string& text) const {
    ASSERT_EQ(write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  /// What the console says in one frame.
  std::string poll() {
    out_.str("");
    console->add_to(loop.inputs);
    loop.wanted = console->wanted();
    stage_.scenario = scenario->tick({loop.step().world, std::nullopt});
    console->observe(loop.record(), stage_);
    return out_.str();
  }
  std::string answer(const std::string& line) {
    type(line + "\n");
    return poll();
  }
  Parameter parameter(const std::string& name) {
    for (const Parameter& one : loop.engine->parameters()) {
      if (one.name == name) return one;
    }
    ADD_FAILURE() << "there is no parameter " << name;
    return {};
  }
  double level() { return std::get<double>(parameter("tested.level").value); }

  HandFedLoop loop{kLamp};
  std::optional<ScenarioHost> scenario;
  std::optional<LiveConsole> console;

 private:
  RecordedBehaviors nobody_;
  StageRecord stage_;
  std::ostringstream out_;
  int ends_[2] = {-1, -1};
};

TEST_F(LiveConsoleTest, SetsAParameter) {
  EXPECT_EQ(answer("set tested.level 0.75"), "  tested.level = 0.75\n");
  EXPECT_EQ(level(), 0.75);
  EXPECT_EQ(parameter("tested.level").origin, ParameterOrigin::live);
}

TEST_F(LiveConsoleTest, TellsWhatIsWrongAndChangesNothing) {
  EXPECT_NE(answer("set tested.level 7").find("0 to 1"), std::string::npos);
  EXPECT_NE(answer("set tested.levle 0.7").find("tested.level"), std::string::npos);
  EXPECT_NE(answer("set tested.level").find("set NAME VALUE"), std::string::npos);
  EXPECT_NE(answer("sett tested.level 1").find("did you mean 'set'"), std::string::npos);
  EXPECT_NE(answer("save /no/such/folder/file").find("cannot write"), std::string::npos);
  EXPECT_NE(answer("states now").find("there is no command"), std::string::npos);
  EXPECT_EQ(level(), 0.5);
}

TEST_F(LiveConsoleTest, ListsParametersAndStates) {
  answer("set tested.level 0.25");
  EXPECT_EQ(answer("params tested"), "  tested.level = 0.25  (0 to 1 m; live) how bright\n");
  EXPECT_NE(answer("params nothing").find("no parameter"), std::string::npos);
  EXPECT_NE(answer("states").find("tested"), std::string::npos);
  EXPECT_NE(answer("help").find("save FILE"), std::string::npos);
}

TEST_F(LiveConsoleTest, SavesWhatWasTuned) {
  answer("set tested.level 0.25");
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "tuned.toml";
  EXPECT_NE(answer("save " + file.string()).find("written"), std::string::npos);
  FrameSetup setup;
  setup.parameters = read_parameters(file);
  HandFedLoop again(kLamp, std::move(setup));
  for (const Parameter& one : again.engine->parameters()) {
    if (one.name == "tested.level") {
      EXPECT_EQ(std::get<double>(one.value), 0.25);
    }
  }
}

TEST_F(LiveConsoleTest, SetsWhatTheScenarioDeclaresToo) {
  EXPECT_EQ(answer("set scene.pace 2"), "  scene.pace = 2\n");
  EXPECT_EQ(std::get<double>(scenario->parameters().value("scene.pace")), 2.0);
  EXPECT_NE(answer("set scene.pace 3").find("0 to 2"), std::string::npos);
  EXPECT_NE(answer("states").find("scene"), std::string::npos);
}

TEST_F(LiveConsoleTest, NeverWaitsForALine) {
  EXPECT_EQ(poll(), "");
  type("set tested.le");
  EXPECT_EQ(poll(), "");
  type("vel 1\nset tested");
  EXPECT_EQ(poll(), "  tested.level = 1\n");
  type(".level 0\n");
  EXPECT_EQ(poll(), "  tested.level = 0\n");
}

TEST_F(LiveConsoleTest, OpensAPromptOnAnEmptyLineAndClosesItOnTheNext) {
  type("\n");
  EXPECT_EQ(poll(), "> ");
  EXPECT_TRUE(console->is_open());
  type("set tested.level 1\n");
  EXPECT_EQ(poll(), "  tested.level = 1\n> ");
  type("\n");
  poll();
  EXPECT_FALSE(console->is_open());
}

TEST_F(LiveConsoleTest, GoesOnWhenNobodyTypesAnyMore) {
  type("set tested.level 1\n");
  close_writing();
  EXPECT_EQ(poll(), "  tested.level = 1\n");
  EXPECT_EQ(poll(), "");
  EXPECT_EQ(poll(), "");
  EXPECT_FALSE(console->wants_to_quit());
}

TEST_F(LiveConsoleTest, EndsTheRunWhenAsked) {
  type("quit\nset tested.level 1\n");
  poll();
  EXPECT_TRUE(console->wants_to_quit());
}

TEST_F(LiveConsoleTest, DropsALineThatHasNoEnd) {
  std::string said;
  for (int i = 0; i < 10; ++i) {
    type(std::string(3000, 'x'));
    said += poll();
  }
  EXPECT_EQ(said, "");
  type("\nset tested.level 1\n");
  EXPECT_EQ(poll(), "  that line is too long\n  tested.level = 1\n");
}

TEST_F(LiveConsoleTest, SurvivesBytesThatAreNoText) {
  type(std::string("set \0\x80\xFF 1\n", 10));
  EXPECT_NE(poll(), "");
}

/// A run in real time at a terminal of its own.
class TerminalRun {
 public:
  TerminalRun() {
    process_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (process_ != 0) return;
    setenv("REORIENT_HOME", REORIENT_SOURCE_DIR, 1);
    execl(REORIENT_PROGRAM, REORIENT_PROGRAM, "--log", "off", "run", "patrol", "--realtime", "--width", "160",
          "--no-pictures", nullptr);
    _exit(127);
  }
  ~TerminalRun() {
    if (process_ <= 0) return;  // to signal -1 would be to signal everybody
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    close(terminal_);
  }
  TerminalRun(const TerminalRun&) = delete;
  TerminalRun& operator=(const TerminalRun&) = delete;

  /// False: this machine has no terminals to give (a bare root without /dev/pts).
  bool has_terminal() const { return process_ > 0; }
  void type(const std::string& keys) const { ASSERT_EQ(write(terminal_, keys.data(), keys.size()), std::ssize(keys)); }
  /// Whether `text` is shown within half a minute, after what was awaited before.
  bool await(const std::string& text) {
    for (int i = 0; i < 3000; ++i) {
      if (const std::size_t place = shown_.find(text); place != std::string::npos) {
        shown_.erase(0, place + text.size());
        return true;
      }
      pollfd waiting{terminal_, POLLIN, 0};
      if (poll(&waiting, 1, 10) != 1) continue;
      std::array<char, 4096> buffer;
      const ssize_t count = read(terminal_, buffer.data(), buffer.size());
      if (count <= 0) return false;  // the run has ended
      shown_.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return false;
  }

 private:
  int terminal_ = -1;
  pid_t process_ = -1;
  std::string shown_;
};

TEST(AtATerminal, CtrlDClosesThePromptAndTheRunGoesOn) {
  TerminalRun run;
  if (!run.has_terminal()) GTEST_SKIP() << "no pseudo-terminal can be opened here";
  ASSERT_TRUE(run.await("real time"));
  for (int i = 0; i < 2; ++i) {
    run.type("\n");
    ASSERT_TRUE(run.await("> ")) << i;
    run.type("\x04");
    ASSERT_TRUE(run.await("real time")) << i;  // the progress line is back
  }
  run.type("states\n");
  EXPECT_TRUE(run.await("penalty_marks"));
  run.type("quit\n");
  EXPECT_TRUE(run.await("digest: "));
}

}  // namespace
}  // namespace reorient
