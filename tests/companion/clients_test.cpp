// SPDX-License-Identifier: MIT
// The companion as teams use it: the program in one process, the clients of the examples in other processes, and the
// simulator as the robot, connected by pipes.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <future>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/record/digest.h"
#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/robots/companion/raw_client.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"

namespace reorient {
namespace {

const std::string kSource = kSourceFolder;

struct Setting {
  const char* name;
  std::string client;
  const char* way;
  const char* body;
  const char* field;
};

class CompanionClient : public ::testing::TestWithParam<Setting> {
 protected:
  std::string socket() const { return (folder_.path() / "s").string(); }
  std::vector<std::string> server() const { return {"run", "--robot", "companion", "--socket", socket()}; }

  /// The default scenario with a client: `learn` seconds to learn the room, then `after` seconds in which the belief
  /// must be corrected.
  static std::string play(const Setting& setting, const std::string& socket, int learn, int after, int pace = 1000) {
    return setting.client + " " + socket + " " + setting.way + " " + kTestRobot + " " + kSource + "/assets/robots/" +
           setting.body + ".toml " + kSource + "/assets/fields/" + setting.field + ".toml 1 160 " +
           std::to_string(learn) + " " + std::to_string(after) + " " + std::to_string(pace) + " 2>&1";
  }

  TemporaryFolder folder_;
};

TEST_P(CompanionClient, EndsWithACorrectBeliefAfterTheRobotWasMirrored) {
  const std::string recording = (folder_.path() / "run.mcap").string();
  {
    std::vector<std::string> words = server();
    words.insert(words.end(), {"--record", recording});
    ChildProgram companion(folder_.path(), words);
    ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
    EXPECT_EQ(std::system(play(GetParam(), socket(), 15, 10).c_str()), 0) << companion.out() << companion.err();
    EXPECT_NE(companion.err().find("starts without knowledge"), std::string::npos) << companion.err();
    EXPECT_NE(companion.out().find("flip_pose granted"), std::string::npos) << companion.out();
    companion.kill(SIGTERM);
    EXPECT_EQ(companion.wait(), 128 + SIGTERM);
  }
  ChildProgram replay(folder_.path(), {"replay", recording});
  EXPECT_EQ(replay.wait(), 0) << replay.out() << replay.err();
  EXPECT_NE(replay.out().find("all frames are the same as recorded"), std::string::npos) << replay.out();
}

const std::string kC = kCompanionClient;
const std::string kPython = "python3 " + kSource + "/examples/companion/client.py";

INSTANTIATE_TEST_SUITE_P(All, CompanionClient,
                         ::testing::Values(Setting{"CWithItsOwnLocalization", kC, "own", "nao-v6", "spl"},
                                           Setting{"CWithOursOnAnotherBody", kC, "ours", "booster-k1", "middle"},
                                           Setting{"PythonWithItsOwnOnAnotherBody", kPython, "own", "booster-k1",
                                                   "middle"},
                                           Setting{"PythonWithOurs", kPython, "ours", "nao-v6", "spl"}),
                         [](const auto& one) { return std::string(one.param.name); });

/// Controls the robot of a client that runs the default scenario. The robot learns until the test requests a lift or
/// ends, so that the scenario lasts long enough on any machine.
class HeldRobot {
 public:
  explicit HeldRobot(const std::filesystem::path& folder) : lift_(folder / "lift"), heartbeat_(folder / "heartbeat") {}
  ~HeldRobot() { lift(); }
  HeldRobot(const HeldRobot&) = delete;
  HeldRobot& operator=(const HeldRobot&) = delete;

  /// The prefix of a command in a shell.
  std::string environment() const {
    return "REORIENT_LIFT_WHEN=" + lift_.string() + " REORIENT_HEARTBEAT=" + heartbeat_.string() + " ";
  }
  void lift() const { std::ofstream(lift_) << '\n'; }
  /// Waits until the client has processed a frame, with or without a companion.
  bool await_frame() const {
    return await([this] { return std::filesystem::exists(heartbeat_); });
  }

 private:
  std::filesystem::path lift_, heartbeat_;
};

/// Time at which the companion has saved its state; the smallest time: never.
std::filesystem::file_time_type saved_at(const std::string& socket) {
  std::error_code missing;
  return std::filesystem::last_write_time(socket + ".state", missing);
}

/// Waits until the companion has started and finished a save. The first save may have started before the call, so it
/// waits for two.
bool await_whole_save(const std::string& socket) {
  const auto await_save = [&] {
    const auto before = saved_at(socket);
    return await([&] { return saved_at(socket) != before; });
  };
  if (!await_save()) return false;
  return await_save();
}

TEST_F(CompanionClient, ContinuesWithACompanionThatWasKilledAndRestarted) {
  const Setting setting{"", kC, "ours", "nao-v6", "spl"};
  std::future<int> client;
  const HeldRobot robot(folder_.path());
  const std::string job = robot.environment() + play(setting, socket(), 40, 15, 8);
  {
    const ChildProgram companion(folder_.path(), server());
    ASSERT_TRUE(companion.await("waiting for a client"));
    client = std::async(std::launch::async, [&] { return std::system(job.c_str()); });
    ASSERT_TRUE(companion.await("trusting/")) << companion.out();  // the room must be learned
    ASSERT_TRUE(await_whole_save(socket())) << companion.err();    // and saved
    companion.kill(SIGKILL);
  }
  const ChildProgram companion(folder_.path(), server());
  EXPECT_TRUE(companion.await("continues from the saved state")) << companion.err();
  robot.lift();
  EXPECT_EQ(client.get(), 0) << companion.out() << companion.err();
}

TEST_F(CompanionClient, ConnectsToACompanionThatStartsLater) {
  const Setting setting{"", kC, "ours", "nao-v6", "spl"};
  std::future<int> client;
  const HeldRobot robot(folder_.path());
  const std::string job = robot.environment() + play(setting, socket(), 20, 10, 20);
  client = std::async(std::launch::async, [&] { return std::system(job.c_str()); });
  ASSERT_TRUE(robot.await_frame());
  const ChildProgram companion(folder_.path(), server());
  EXPECT_TRUE(companion.await("client connected")) << companion.err();
  robot.lift();
  // The scenario may end before the room is learned. Then the belief stays wrong, and the exit code is 1.
  const int status = client.get();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) <= 1) << status << companion.out() << companion.err();
}

/// Whether the welcome reports saved knowledge; nothing: the frames are not answered.
std::optional<bool> knows_client(const std::string& socket, const reorient_hello& hello) {
  RawClient client(socket);
  client.introduce(hello);
  std::optional<bool> welcomed;
  std::uint64_t number = 0;
  const auto is_answered = [&] {
    for (const RawClient::Heard& one : client.hear()) {
      if (one.kind == REORIENT_WELCOME) welcomed = one.as<reorient_welcome>().continues != 0;
      if (one.kind == REORIENT_ANSWER) return true;
    }
    ++number;
    client.send_frame(0.1 * static_cast<double>(number), number);
    return false;
  };
  return await(is_answered, std::chrono::milliseconds(30)) ? welcomed : std::nullopt;
}

TEST_F(CompanionClient, FindsItsKnowledgeAfterAnotherRobotWasConnected) {
  ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  const reorient_hello one = small_hello(1);
  reorient_hello other = small_hello(2);
  other.body.yaw_limit = 0.5;
  EXPECT_EQ(knows_client(socket(), one), false);
  {
    RawClient curious(socket());
    curious.introduce(other);
  }
  EXPECT_EQ(knows_client(socket(), one), true) << "a client that only sends a hello must not change the state";
  EXPECT_FALSE(std::filesystem::exists(socket() + ".state.other"));
  EXPECT_EQ(knows_client(socket(), other), false);
  EXPECT_EQ(knows_client(socket(), one), true) << companion.err();
  EXPECT_EQ(knows_client(socket(), other), true) << companion.err();
  companion.kill(SIGTERM);
  companion.wait();
  const std::string state = socket() + ".state";
  ASSERT_TRUE(std::filesystem::exists(state));
  if (geteuid() != 0) return;
  // Only root can create a file of another user.
  ASSERT_EQ(chown(state.c_str(), 12345, 12345), 0);
  const ChildProgram again(folder_.path(), server());
  ASSERT_TRUE(again.await("waiting for a client")) << again.err();
  EXPECT_EQ(knows_client(socket(), other), false) << again.err();
  EXPECT_TRUE(again.await("belongs to another user")) << again.err();
}

TEST_F(CompanionClient, KeepsItsKnowledgeIfTheClockIsSetBack) {
  const reorient_hello hello = small_hello(1);
  {
    ChildProgram companion(folder_.path(), server());
    ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
    EXPECT_EQ(knows_client(socket(), hello), false);
    companion.kill(SIGTERM);
    companion.wait();
  }
  // The file contains the time of the clock that can be set, then the identity of the computer's start as a text after
  // its length. The second word is the digest of all bytes behind it.
  std::string state = read_text(socket() + ".state");
  std::string start;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> start;
  const std::size_t place = state.find(start);
  ASSERT_TRUE(!start.empty() && place != std::string::npos);
  double time = 0.0;
  const std::size_t at = place - sizeof(std::uint32_t) - sizeof(time);
  std::memcpy(&time, state.data() + at, sizeof(time));
  ASSERT_GT(time, 1.6e9) << "seconds since 1970";
  constexpr double kYear = 3.2e7;
  time += kYear;  // the clock was a year ahead when the state was saved
  std::memcpy(state.data() + at, &time, sizeof(time));
  const auto store = [&] {
    Digest digest;
    digest.add(std::string_view(state).substr(2 * sizeof(std::uint64_t)));
    const std::uint64_t value = digest.value();
    std::memcpy(state.data() + sizeof(value), &value, sizeof(value));
    folder_.write("s.state", state);
  };
  store();
  {
    ChildProgram companion(folder_.path(), server());
    ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
    EXPECT_EQ(knows_client(socket(), hello), true) << companion.err();
    companion.kill(SIGTERM);
    companion.wait();
  }
  // After another start of the computer, only this clock is left.
  state[place] = state[place] == '0' ? '1' : '0';
  store();
  const ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  EXPECT_EQ(knows_client(socket(), hello), false);
  EXPECT_TRUE(companion.await("saved later than now, by the clock of the computer")) << companion.err();
}

TEST_F(CompanionClient, ReportsThatItCannotKeepTheStateOfAnotherRobot) {
  const std::string aside = socket() + ".state.other";
  std::filesystem::create_directory(aside);
  {
    ChildProgram refused(folder_.path(), server());
    EXPECT_EQ(refused.wait(), 2);
    EXPECT_EQ(refused.err(), "reorient: cannot write '" + aside +
                                 "': expected a file, found a folder; name another file with --state\n");
  }
  std::filesystem::remove(aside);
  const ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  reorient_hello other = small_hello(2);
  other.body.yaw_limit = 0.5;
  EXPECT_EQ(knows_client(socket(), small_hello(1)), false);
  std::filesystem::create_directory(aside);
  EXPECT_EQ(knows_client(socket(), other), false);
  EXPECT_TRUE(companion.await(aside + ": cannot be written, so the state of the other robot is lost: Is a directory"))
      << companion.err();
}

/// The pose in the answer to a frame that contains this initial pose, or none.
std::optional<Pose2> pose_after(RawClient& client, double time, std::uint64_t number, std::optional<Pose2> told) {
  reorient_frame frame = standing_frame(number, time, client.paint(90));
  if (told) {
    frame.has |= REORIENT_HAS_TOLD_POSE;
    frame.told_pose[0] = told->position.x();
    frame.told_pose[1] = told->position.y();
    frame.told_pose[2] = told->rotation;
    frame.told_deviation[0] = frame.told_deviation[1] = 0.05;
  }
  if (!client.send(REORIENT_FRAME, frame)) return std::nullopt;
  std::optional<Pose2> pose;
  await([&] {
    const std::optional<reorient_answer> answer = client.answer();
    if (answer && answer->number == number) pose = Pose2(answer->pose[0], answer->pose[1], answer->pose[2]);
    return pose.has_value();
  });
  return pose;
}

std::ptrdiff_t threads_of(const ChildProgram& program) {
  std::error_code gone;
  return std::distance(std::filesystem::directory_iterator("/proc/" + std::to_string(program.id()) + "/task", gone),
                       {});
}

TEST_F(CompanionClient, NeedNotRepeatAnInitialPoseThatItSentJustBeforeTheCompanionWasKilled) {
  const reorient_hello hello = small_hello(1);
  const Pose2 told(-3.0, 2.0, 1.0);
  {
    const ChildProgram companion(folder_.path(), server());
    ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
    const std::ptrdiff_t threads = threads_of(companion);
    RawClient client(socket());
    client.introduce(hello);
    // The companion checks once after each frame whether to save. After the first frame it saves, in a separate thread.
    ASSERT_TRUE(pose_after(client, 0.0, 1, std::nullopt)) << companion.err();
    const auto never = std::filesystem::file_time_type::min();
    ASSERT_TRUE(await([&] { return saved_at(socket()) != never && threads_of(companion) == threads; }));
    // It saves data that a client sends only once at most ten times a second, and other data once a second. So it saves
    // at the check after this frame. On a slow machine a second may have passed anyway.
    let_time_pass(0.11);
    const auto before = saved_at(socket());
    const std::optional<Pose2> pose = pose_after(client, 0.1, 2, told);
    ASSERT_TRUE(pose) << companion.err();
    EXPECT_LT((pose->position - told.position).norm(), 0.3);
    ASSERT_TRUE(await([&] { return saved_at(socket()) != before; })) << "the state must be saved without another frame";
    companion.kill(SIGKILL);
  }
  const ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  RawClient client(socket());
  client.introduce(hello);
  const std::optional<Pose2> pose = pose_after(client, 1.0, 5, std::nullopt);
  ASSERT_TRUE(pose) << companion.err();
  EXPECT_LT((pose->position - told.position).norm(), 0.3) << pose->position.transpose();
}

/// The first command in the answers to these frames, of which a second of the robot's time has ten.
std::optional<std::uint32_t> command_within(RawClient& client, double begin, int frames, std::uint32_t done = 0,
                                            std::uint64_t server = 0) {
  std::optional<std::uint32_t> command;
  for (int i = 0; i < frames && !command; ++i) {
    const auto number = static_cast<std::uint64_t>(10.0 * begin) + static_cast<std::uint64_t>(i) + 1;
    reorient_frame frame = standing_frame(number, begin + 0.1 * i, client.paint(90));
    frame.has |= REORIENT_HAS_BELIEF;
    frame.done = done;
    frame.done_server = server;
    if (!client.send(REORIENT_FRAME, frame)) break;
    await([&] {
      const std::optional<reorient_answer> answer = client.answer();
      if (!answer || answer->number != number) return false;
      if (answer->command > done) command = answer->command;
      return true;
    });
  }
  return command;
}

constexpr const char* kFlipsOnce = R"(behavior "once" { initial = "waiting",
    state "waiting" { { "done", after = 1.0, because = "it is time" } },
    state "done" { enter = function() command.flip_pose() end } })";

TEST_F(CompanionClient, GetsACommandAtMostOnceAlsoIfTheCompanionIsKilledRightAfterIt) {
  const std::filesystem::path scripts = folder_.path() / "scripts";
  std::filesystem::create_directories(scripts / "behaviors");
  std::ofstream(scripts / "behaviors/once.lua") << kFlipsOnce;
  std::vector<std::string> words = server();
  words.insert(words.end(), {"--scripts", scripts.string(), "--behaviors", "once"});
  const reorient_hello hello = small_hello(1, REORIENT_OWN_LOCALIZATION);
  for (int run = 0; run < 3; ++run) {
    {
      std::vector<std::string> fresh = words;
      fresh.emplace_back("--fresh");
      const ChildProgram companion(folder_.path(), fresh);
      ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
      RawClient client(socket());
      client.introduce(hello);
      ASSERT_TRUE(command_within(client, 0.0, 2000)) << companion.out() << companion.err();
      companion.kill(SIGKILL);  // the client carries it out
    }
    const ChildProgram companion(folder_.path(), words);
    ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
    RawClient client(socket());
    client.introduce(hello);
    EXPECT_FALSE(command_within(client, 300.0, 30)) << "a second flip would cancel the first one";
    EXPECT_NE(companion.err().find("continues from the saved state"), std::string::npos) << companion.err();
  }
}

TEST_F(CompanionClient, GetsACommandAlsoIfTheStateCannotBeWritten) {
  const std::filesystem::path scripts = folder_.path() / "scripts", gone = folder_.path() / "gone";
  std::filesystem::create_directories(scripts / "behaviors");
  std::filesystem::create_directories(gone);
  std::ofstream(scripts / "behaviors/once.lua") << kFlipsOnce;
  std::vector<std::string> words = server();
  words.insert(words.end(),
               {"--scripts", scripts.string(), "--behaviors", "once", "--state", (gone / "state").string()});
  const ChildProgram companion(folder_.path(), words);
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  std::filesystem::remove_all(gone);
  RawClient client(socket());
  client.introduce(small_hello(1, REORIENT_OWN_LOCALIZATION));
  EXPECT_TRUE(command_within(client, 0.0, 2000)) << "a full disk must not keep the belief wrong";
  EXPECT_TRUE(companion.await((gone / "state").string())) << companion.err();
}

TEST_F(CompanionClient, IsReportedWhenItLeavesOrIsRefused) {
  const ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  {
    RawClient client(socket());
    reorient_hello hello = small_hello(1);
    hello.way = 9;
    client.introduce(hello);
    EXPECT_TRUE(companion.await("reorient: client refused: hello: way is 9")) << companion.err();
  }
  {
    RawClient client(socket());
    reorient_hello hello = small_hello(2);
    set_text(hello.body.name, "\x1b[2Jred");
    client.introduce(hello);
    EXPECT_TRUE(companion.await("client connected: \\x1B[2Jred")) << companion.err();
    EXPECT_EQ(companion.err().find('\x1b'), std::string::npos) << "the name must not control the terminal";
    ASSERT_TRUE(pose_after(client, 0.0, 1, std::nullopt)) << companion.err();
  }
  EXPECT_TRUE(companion.await("reorient: client left")) << companion.err();
}

TEST_F(CompanionClient, GetsOneLineForOptionsThatTheCompanionDoesNotUse) {
  const std::filesystem::path link = folder_.path() / "link";
  std::filesystem::create_symlink(folder_.path() / "precious", link);
  const std::pair<std::vector<std::string>, const char*> mistakes[] = {
      {{"run", "mirrored_placement", "--robot", "companion"}, "--robot companion: expected no scenario"},
      {{"run", "--robot", "companion", "--room", "hall.hdr"},
       "--room: expected --robot simulator, found --robot companion"},
      {{"run", "--robot", "companion", "--body", "nao-v6"},
       "--body: expected --robot simulator, found --robot companion"},
      {{"run", "--socket", "/tmp/s"}, "--socket: expected --robot companion, found --robot simulator"},
      {{"run", "--fresh"}, "--fresh: expected --robot companion, found --robot simulator"},
      {{"run", "--robot", "companion", "--socket", folder_.write("file", "x").string()},
       "expected a socket or no file, found another file"},
      {{"run", "--robot", "companion", "--socket", socket(), "--state", "/nowhere/state"}, "--state"},
      {{"run", "--robot", "unicorn"}, "--robot"},
      {{"run", "--robot", "companion", "--socket", socket(), "--behaviors", "orientatoin"}, "orientatoin"},
      {{"run", "--robot", "companion", "--socket", socket(), "--set", "pose_filter.particles=-1"},
       "pose_filter.particles"},
      {{"run", "--robot", "companion", "--socket", socket(), "--state", link.string()}, "found a symbolic link"},
  };
  for (const auto& [words, why] : mistakes) {
    ChildProgram program(folder_.path(), words);
    EXPECT_EQ(program.wait(), 2) << why;
    const std::string err = program.err();
    EXPECT_NE(err.find(why), std::string::npos) << err;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  }
}

TEST_F(CompanionClient, IsRefusedIfItsRobotDoesNotFitTheModelAndOtherClientsAreServed) {
  const std::string model = (folder_.path() / "hall.model").string();
  {
    ChildProgram other(folder_.path(), {"run", "mirrored_placement", "--width", "160", "--seconds", "20", "--body",
                                        "booster-k1", "--model", model});
    other.wait();
    ASSERT_TRUE(std::filesystem::exists(model)) << other.err();
  }
  std::vector<std::string> words = server();
  words.insert(words.end(), {"--model", model});
  ChildProgram companion(folder_.path(), words);
  ASSERT_TRUE(companion.await("waiting for a client")) << companion.err();
  std::string why;
  for (int i = 0; i < 3; ++i) {  // a robot with another height connects repeatedly
    RawClient client(socket());
    client.introduce(small_hello(1));
    await([&] { return !(why = client.refusal()).empty(); });
    EXPECT_NE(why.find("--model " + model), std::string::npos) << why;
  }
  EXPECT_TRUE(companion.await("--model " + model)) << companion.err();
  const Setting setting{"", kC, "ours", "booster-k1", "middle"};
  EXPECT_EQ(std::system(play(setting, socket(), 15, 10).c_str()), 0) << companion.out() << companion.err();
  companion.kill(SIGTERM);
  companion.wait();
  const std::string err = companion.err();
  EXPECT_EQ(err.find("--model"), err.rfind("--model")) << "the refusal must be logged once\n" << err;
}

TEST_F(CompanionClient, StartsWithoutKnowledgeAfterASideChange) {
  const std::string model = (folder_.path() / "hall.model").string();
  const auto begin = [&](bool sides_changed) {
    std::vector<std::string> words = server();
    words.insert(words.end(), {"--model", model});
    if (sides_changed) words.emplace_back("--sides-changed");
    return words;
  };
  const auto welcomed = [&](bool sides_changed) {
    ChildProgram companion(folder_.path(), begin(sides_changed));
    EXPECT_TRUE(companion.await("waiting for a client")) << companion.err();
    const std::optional<bool> knew = knows_client(socket(), small_hello(1));
    companion.kill(SIGTERM);
    companion.wait();
    return knew;
  };
  EXPECT_EQ(welcomed(false), false);
  EXPECT_EQ(welcomed(false), true);
  EXPECT_EQ(welcomed(true), false) << "its state is in the axes of the previous half";
  EXPECT_EQ(welcomed(true), true);
}

TEST_F(CompanionClient, IsServedUntilTheCompanionIsStopped) {
  ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("waiting for a client"));
  companion.kill(SIGTERM);
  EXPECT_EQ(companion.wait(), 128 + SIGTERM);
  EXPECT_FALSE(std::filesystem::exists(socket()));
  EXPECT_NE(companion.out().find("0 frames of 0 clients"), std::string::npos) << companion.out();
}

}  // namespace
}  // namespace reorient
