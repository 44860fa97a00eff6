// The companion as teams meet it: the program in a process of its own, the examples' clients in others, and a robot
// that is the simulator behind a pipe.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <future>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/robots/companion/raw_client.h"
#include "tests/temporary_folder.h"

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

  /// The main job with a client: `learn` seconds to learn the room, then `after` in which the belief has to come right.
  static std::string play(const Setting& setting, const std::string& socket, int learn, int after, int pace = 1000) {
    return setting.client + " " + socket + " " + setting.way + " " + kTestRobot + " " + kSource + "/assets/robots/" +
           setting.body + ".toml " + kSource + "/assets/fields/" + setting.field + ".toml 1 160 " +
           std::to_string(learn) + " " + std::to_string(after) + " " + std::to_string(pace) + " 2>&1";
  }

  TemporaryFolder folder_;
};

TEST_P(CompanionClient, EndsRightAfterItsRobotWasTurnedRound) {
  const std::string recording = (folder_.path() / "run.mcap").string();
  {
    std::vector<std::string> words = server();
    words.insert(words.end(), {"--record", recording});
    ChildProgram companion(folder_.path(), words);
    ASSERT_TRUE(companion.await("no client has come yet")) << companion.err();
    EXPECT_EQ(std::system(play(GetParam(), socket(), 15, 10).c_str()), 0) << companion.out() << companion.err();
    EXPECT_NE(companion.err().find("beginning anew"), std::string::npos) << companion.err();
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

TEST_F(CompanionClient, GoesOnWithACompanionThatWasKilledAndBegunAgain) {
  const Setting setting{"", kC, "ours", "nao-v6", "spl"};
  std::future<int> client;
  {
    const ChildProgram companion(folder_.path(), server());
    ASSERT_TRUE(companion.await("no client has come yet"));
    client = std::async(std::launch::async, [&] { return std::system(play(setting, socket(), 40, 15, 8).c_str()); });
    ASSERT_TRUE(companion.await("trusting/")) << companion.out();  // the room is learned
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));  // and kept
    companion.kill(SIGKILL);
  }
  const ChildProgram companion(folder_.path(), server());
  EXPECT_TRUE(companion.await("going on from before")) << companion.err();
  EXPECT_EQ(client.get(), 0) << companion.out() << companion.err();
}

TEST_F(CompanionClient, FindsItsWayToACompanionThatComesLater) {
  const Setting setting{"", kC, "ours", "nao-v6", "spl"};
  std::future<int> client =
      std::async(std::launch::async, [&] { return std::system(play(setting, socket(), 20, 10, 20).c_str()); });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const ChildProgram companion(folder_.path(), server());
  EXPECT_TRUE(companion.await("a client has come")) << companion.err();
  client.wait();
}

/// Whether it is welcomed to what was known before; nothing: its frames are not answered.
std::optional<bool> goes_on(const std::string& socket, const reorient_hello& hello) {
  RawClient client(socket);
  client.introduce(hello);
  std::optional<bool> welcomed;
  for (int i = 1; i < 1000; ++i) {
    client.send_frame(0.1 * i, static_cast<std::uint64_t>(i));
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    for (const RawClient::Heard& one : client.hear()) {
      if (one.kind == REORIENT_WELCOME) welcomed = one.as<reorient_welcome>().goes_on != 0;
      if (one.kind == REORIENT_ANSWER) return welcomed;
    }
  }
  return std::nullopt;
}

TEST_F(CompanionClient, FindsWhatWasKnownThoughAnotherRobotWasThereMeanwhile) {
  ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("no client has come yet")) << companion.err();
  const reorient_hello one = small_hello(1);
  reorient_hello other = small_hello(2);
  other.body.yaw_limit = 0.5;
  EXPECT_EQ(goes_on(socket(), one), false);
  {
    RawClient curious(socket());
    curious.introduce(other);
  }
  EXPECT_EQ(goes_on(socket(), one), true) << "who only says hello changes nothing";
  EXPECT_FALSE(std::filesystem::exists(socket() + ".state.other"));
  EXPECT_EQ(goes_on(socket(), other), false);
  EXPECT_EQ(goes_on(socket(), one), true) << companion.err();
  EXPECT_EQ(goes_on(socket(), other), true) << companion.err();
  companion.kill(SIGTERM);
  companion.wait();
  const std::string state = socket() + ".state";
  ASSERT_TRUE(std::filesystem::exists(state));
  if (geteuid() != 0) return;
  // Only root can make a file that is another user's.
  ASSERT_EQ(chown(state.c_str(), 12345, 12345), 0);
  const ChildProgram again(folder_.path(), server());
  ASSERT_TRUE(again.await("no client has come yet")) << again.err();
  EXPECT_EQ(goes_on(socket(), other), false) << again.err();
  EXPECT_TRUE(again.await("it is another user's")) << again.err();
}

/// The pose in the answer to a frame that tells the pose there, or none.
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
  for (int i = 0; i < 1000; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::optional<reorient_answer> answer = client.answer();
    if (answer && answer->number == number) return Pose2(answer->pose[0], answer->pose[1], answer->pose[2]);
  }
  return std::nullopt;
}

TEST_F(CompanionClient, IsNotAskedAgainForAPoseThatWasToldJustBeforeTheCompanionWasKilled) {
  const reorient_hello hello = small_hello(1);
  const Pose2 told(-3.0, 2.0, 1.0);
  {
    const ChildProgram companion(folder_.path(), server());
    ASSERT_TRUE(companion.await("no client has come yet")) << companion.err();
    RawClient client(socket());
    client.introduce(hello);
    std::uint64_t number = 0;
    for (; number < 3; ++number) {
      ASSERT_TRUE(pose_after(client, 0.1 * static_cast<double>(number), number + 1, std::nullopt)) << companion.err();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    const std::optional<Pose2> pose = pose_after(client, 0.1 * static_cast<double>(number), number + 1, told);
    ASSERT_TRUE(pose) << companion.err();
    EXPECT_LT((pose->position - told.position).norm(), 0.3);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // much less than a second
    companion.kill(SIGKILL);
  }
  const ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("no client has come yet")) << companion.err();
  RawClient client(socket());
  client.introduce(hello);
  const std::optional<Pose2> pose = pose_after(client, 1.0, 5, std::nullopt);
  ASSERT_TRUE(pose) << companion.err();
  EXPECT_LT((pose->position - told.position).norm(), 0.3) << pose->position.transpose();
}

TEST_F(CompanionClient, IsToldInOneLineWhatTheCompanionDoesNotHeed) {
  const std::filesystem::path link = folder_.path() / "link";
  std::filesystem::create_symlink(folder_.path() / "precious", link);
  const std::pair<std::vector<std::string>, const char*> mistakes[] = {
      {{"run", "turned_round", "--robot", "companion"}, "--robot companion plays no scenario"},
      {{"run", "--robot", "companion", "--room", "hall.hdr"}, "--room: the companion would not heed it"},
      {{"run", "--robot", "companion", "--body", "nao-v6"}, "--body: the companion would not heed it"},
      {{"run", "--socket", "/tmp/s"}, "--socket: only --robot companion heeds it"},
      {{"run", "--fresh"}, "--fresh: only --robot companion heeds it"},
      {{"run", "--robot", "companion", "--socket", folder_.write("file", "x").string()},
       "there is a file of this name"},
      {{"run", "--robot", "companion", "--socket", socket(), "--state", "/nowhere/state"}, "--state"},
      {{"run", "--robot", "unicorn"}, "--robot"},
      {{"run", "--robot", "companion", "--socket", socket(), "--behaviors", "orientatoin"}, "orientatoin"},
      {{"run", "--robot", "companion", "--socket", socket(), "--set", "pose_filter.particles=-1"},
       "pose_filter.particles"},
      {{"run", "--robot", "companion", "--socket", socket(), "--state", link.string()}, "that is a link"},
  };
  for (const auto& [words, why] : mistakes) {
    ChildProgram program(folder_.path(), words);
    EXPECT_EQ(program.wait(), 2) << why;
    const std::string err = program.err();
    EXPECT_NE(err.find(why), std::string::npos) << err;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  }
}

TEST_F(CompanionClient, IsRefusedWhereItsRobotDoesNotFitTheModelAndOthersAreServed) {
  const std::string model = (folder_.path() / "hall.model").string();
  {
    ChildProgram other(folder_.path(), {"run", "turned_round", "--width", "160", "--seconds", "20", "--body",
                                        "booster-k1", "--model", model});
    other.wait();
    ASSERT_TRUE(std::filesystem::exists(model)) << other.err();
  }
  std::vector<std::string> words = server();
  words.insert(words.end(), {"--model", model});
  ChildProgram companion(folder_.path(), words);
  ASSERT_TRUE(companion.await("no client has come yet")) << companion.err();
  std::string why;
  for (int i = 0; i < 3; ++i) {  // a client of another height comes again and again
    RawClient client(socket());
    client.introduce(small_hello(1));
    why.clear();
    for (int j = 0; j < 500 && why.empty(); ++j) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      why = client.refusal();
    }
    EXPECT_NE(why.find("--model " + model), std::string::npos) << why;
  }
  EXPECT_TRUE(companion.await("--model " + model)) << companion.err();
  const Setting setting{"", kC, "ours", "booster-k1", "middle"};
  EXPECT_EQ(std::system(play(setting, socket(), 15, 10).c_str()), 0) << companion.out() << companion.err();
  companion.kill(SIGTERM);
  companion.wait();
  const std::string err = companion.err();
  EXPECT_EQ(err.find("--model"), err.rfind("--model")) << "it is told once\n" << err;
}

TEST_F(CompanionClient, BeginsAnewWhereTheSidesHaveChanged) {
  const std::string model = (folder_.path() / "hall.model").string();
  const auto begin = [&](bool sides_changed) {
    std::vector<std::string> words = server();
    words.insert(words.end(), {"--model", model});
    if (sides_changed) words.emplace_back("--sides-changed");
    return words;
  };
  const auto welcomed = [&](bool sides_changed) {
    ChildProgram companion(folder_.path(), begin(sides_changed));
    EXPECT_TRUE(companion.await("no client has come yet")) << companion.err();
    const std::optional<bool> knew = goes_on(socket(), small_hello(1));
    companion.kill(SIGTERM);
    companion.wait();
    return knew;
  };
  EXPECT_EQ(welcomed(false), false);
  EXPECT_EQ(welcomed(false), true);
  EXPECT_EQ(welcomed(true), false) << "its state is in the axes of before";
  EXPECT_EQ(welcomed(true), true);
}

TEST_F(CompanionClient, IsServedUntilSomebodyEndsTheCompanion) {
  ChildProgram companion(folder_.path(), server());
  ASSERT_TRUE(companion.await("no client has come yet"));
  companion.kill(SIGTERM);
  EXPECT_EQ(companion.wait(), 128 + SIGTERM);
  EXPECT_FALSE(std::filesystem::exists(socket()));
  EXPECT_NE(companion.out().find("0 frames of 0 clients"), std::string::npos) << companion.out();
}

}  // namespace
}  // namespace reorient
