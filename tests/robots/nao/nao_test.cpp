// SPDX-License-Identifier: MIT
// A fully simulated NAO, in simulated time.
#include "robots/nao/nao.h"

#include <cmath>
#include <cstring>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/field_dimensions.h"
#include "tests/robots/nao/twin/nao_world.h"

namespace reorient::nao {
namespace {

const Room& hall() {
  static const Room room = procedural_hall(1, room_shape_for(FieldDimensions{}));
  return room;
}

SimulatorParameters small() {
  SimulatorParameters parameters;
  parameters.width = 160;
  return parameters;
}

/// A port that delivers the datagrams of a test.
class WrittenReferee : public RefereePort {
 public:
  std::span<const std::byte> receive() override {
    if (waiting.empty()) return {};
    now = waiting.front();
    waiting.pop_front();
    return now;
  }
  void accept_sender() override { ++accepted; }
  void answer(std::span<const std::byte> datagram) override { answers.emplace_back(datagram.begin(), datagram.end()); }

  void say(int state, int penalty) {
    std::vector<std::byte> bytes(158);
    std::memcpy(bytes.data(), "RGme", 4);
    bytes[4] = std::byte{20};
    bytes[10] = static_cast<std::byte>(state);
    bytes[12] = std::byte{1};
    bytes[18] = std::byte{5};
    bytes[18 + 10 + 3 * 1] = static_cast<std::byte>(penalty);  // the second player
    waiting.push_back(bytes);
  }

  std::deque<std::vector<std::byte>> waiting;
  std::vector<std::byte> now;
  std::vector<std::vector<std::byte>> answers;
  int accepted = 0;
};

class NaoTest : public testing::Test {
 protected:
  NaoTest() : world_(small(), RobotBody(), FieldDimensions{}, hall(), Pose2(-3.2, -3.5, kPi / 2.0), 1) {
    options_.width = 160;
    options_.stands_at_once = true;
    options_.team = 5;
    options_.player = 2;
  }
  ~NaoTest() override { EXPECT_EQ(world_.body().complaint(), ""); }

  void begin() {
    NaoSurroundings around = world_.surroundings([this] { return world_.now() > deadline_; });
    around.referee = &referee_;
    nao_.emplace(options_, around);
  }
  /// Processes frames for some seconds. Returns false if no more frames follow.
  bool run(double seconds) {
    for (const double end = world_.now() + seconds; world_.now() < end;) {
      deadline_ = end + 1.0;
      if (!nao_->observe(observation_)) return false;
      ++frames_;
      Answer answer;
      answer.request.head = head_;
      nao_->answer(answer);
    }
    return true;
  }

  NaoWorld world_;
  WrittenReferee referee_;
  NaoOptions options_;
  std::optional<Nao> nao_;
  Observation observation_;
  std::optional<HeadRequest> head_;
  double deadline_ = 1e9;
  int frames_ = 0;
};

TEST_F(NaoTest, StandsUpAndDeliversTheImagesOfItsSimulator) {
  begin();
  ASSERT_TRUE(run(8.0));
  EXPECT_EQ(nao_->guard().state, GuardState::standing);
  frames_ = 0;
  ASSERT_TRUE(run(3.0));
  EXPECT_NEAR(frames_, 83, 3);
  ASSERT_TRUE(observation_.upper);
  EXPECT_EQ(observation_.upper->image.width, 160);
  EXPECT_EQ(observation_.reported_posture, ReportedPosture::unknown) << "the engine finds it by itself";
  EXPECT_NEAR(observation_.body.acceleration.z(), 9.81, 0.5);
  EXPECT_NEAR(observation_.body.foot_load, 5.3, 1.0);
  EXPECT_EQ(nao_->missing(), Missing::nothing);
}

TEST_F(NaoTest, ReportsGettingUpWhileItDoesNotStand) {
  options_.stands_at_once = false;
  begin();
  ASSERT_TRUE(run(6.0));
  EXPECT_EQ(observation_.reported_posture, ReportedPosture::getting_up);
}

TEST_F(NaoTest, UsesTheHeadAnglesAtTheExposureOfAnImage) {
  begin();
  ASSERT_TRUE(run(8.0));
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    head_ = HeadRequest{{1.2 * std::sin(0.05 * i), 0.1}, 3.0};
    ASSERT_TRUE(run(0.03));
    // The simulator's ground truth of the same image, except for the noise of its sensors.
    const Isometry3 truth = world_.simulator().field_from_camera();
    const Isometry3 robot =
        Isometry3(Eigen::Translation3d(world_.simulator().ground_truth().pose.position.x(),
                                       world_.simulator().ground_truth().pose.position.y(), 0.0)) *
        Eigen::AngleAxisd(world_.simulator().ground_truth().pose.rotation, Eigen::Vector3d::UnitZ());
    const Isometry3 believed = robot * observation_.upper->robot_from_camera;
    const double angle = Eigen::AngleAxisd(truth.linear().transpose() * believed.linear()).angle();
    worst = std::max(worst, angle);
  }
  EXPECT_LT(worst, 0.02);
}

TEST_F(NaoTest, TurnsTheHeadAsRequested) {
  begin();
  ASSERT_TRUE(run(8.0));
  head_ = HeadRequest{{-0.8, 0.2}, 2.0};
  ASSERT_TRUE(run(2.0));
  EXPECT_NEAR(observation_.body.head.yaw, -0.8, 0.03);
  EXPECT_NEAR(observation_.body.head.pitch, 0.2, 0.03);
}

TEST_F(NaoTest, StandsUpPausesAndEndsByTheChestButton) {
  options_.stands_at_once = false;
  begin();
  ASSERT_TRUE(run(5.0));
  const auto press = [this](double seconds) {
    world_.body().press_chest(true);
    const bool continues = run(seconds);
    world_.body().press_chest(false);
    return continues;
  };
  ASSERT_TRUE(press(0.3));
  ASSERT_TRUE(run(4.0));
  EXPECT_EQ(nao_->guard().state, GuardState::standing);
  ASSERT_TRUE(press(0.3));
  ASSERT_TRUE(run(0.2));
  EXPECT_TRUE(nao_->is_paused());
  head_ = HeadRequest{{1.0, 0.0}, 2.0};
  ASSERT_TRUE(run(1.0));
  EXPECT_LT(observation_.body.head.yaw, 0.1) << "it does not move while it is paused";
  ASSERT_TRUE(press(0.3));
  ASSERT_TRUE(run(1.0));
  EXPECT_GT(observation_.body.head.yaw, 0.9);
  EXPECT_FALSE(press(4.0)) << "a press of 3 s ends the run";
  nao_.reset();
  for (int i = 0; i < 400; ++i) world_.step();
  EXPECT_EQ(world_.report().state, GuardState::sitting);
}

TEST_F(NaoTest, SitsDownWhenTheEngineEnds) {
  begin();
  ASSERT_TRUE(run(8.0));
  nao_.reset();
  for (int i = 0; i < 400; ++i) world_.step();
  EXPECT_EQ(world_.report().state, GuardState::sitting);
  EXPECT_TRUE(world_.body().sits());
}

TEST_F(NaoTest, HasNoFramesWithoutAGuardAndReportsIt) {
  world_.hide_guard(true);
  begin();
  EXPECT_FALSE(run(3.0));
  EXPECT_EQ(nao_->missing(), Missing::guard);
  EXPECT_GT(nao_->missing_for(), 2.0);
  world_.hide_guard(false);
  EXPECT_TRUE(run(3.0));
}

TEST_F(NaoTest, ReceivesTheRefereeAndAnswersOnceASecond) {
  begin();
  ASSERT_TRUE(run(5.0));
  referee_.say(3, 0);
  deadline_ = 1e9;
  ASSERT_TRUE(nao_->observe(observation_));
  ASSERT_TRUE(observation_.external.referee);
  EXPECT_EQ(observation_.external.referee->state, GameState::playing);
  EXPECT_EQ(referee_.accepted, 1);
  referee_.waiting.push_back({std::byte{'R'}, std::byte{'G'}, std::byte{'m'}, std::byte{'e'}});
  ASSERT_TRUE(nao_->observe(observation_));
  EXPECT_EQ(referee_.accepted, 1) << "the other datagrams are about another game or invalid";
  for (int i = 0; i < 8; ++i) {
    referee_.say(3, 4);
    ASSERT_TRUE(run(0.5));
  }
  EXPECT_NEAR(static_cast<double>(referee_.answers.size()), 5.0, 1.0);
  EXPECT_EQ(referee_.answers.front().size(), 32u);
}

TEST_F(NaoTest, ReportsOnceThatItIgnoresAnUnknownVersionOfTheReferee) {
  std::vector<std::string> lines;
  NaoSurroundings around = world_.surroundings([this] { return world_.now() > deadline_; });
  around.referee = &referee_;
  around.tell = [&](const std::string& line) { lines.push_back(line); };
  nao_.emplace(options_, around);
  for (int i = 0; i < 3; ++i) {
    referee_.say(3, 0);
    referee_.waiting.back()[4] = std::byte{21};
  }
  ASSERT_TRUE(run(5.0));
  EXPECT_FALSE(observation_.external.referee);
  EXPECT_EQ(lines, std::vector<std::string>{
                       "GameController: datagram ignored: expected version 18, 19 or 20, found version 21"});
  EXPECT_TRUE(referee_.answers.empty());
}

TEST_F(NaoTest, StaysDownWithAnEmptyBatteryUntilTheButtonIsPressed) {
  begin();
  ASSERT_TRUE(run(8.0));
  world_.body().set_charge(0.04f);
  ASSERT_TRUE(run(5.0));
  EXPECT_EQ(nao_->guard().state, GuardState::sitting);
  world_.body().set_charge(0.9f);
  ASSERT_TRUE(run(5.0));
  EXPECT_EQ(nao_->guard().state, GuardState::sitting) << "it is charging, and the cable is short";
  world_.body().press_chest(true);
  ASSERT_TRUE(run(0.3));
  world_.body().press_chest(false);
  ASSERT_TRUE(run(5.0));
  EXPECT_EQ(nao_->guard().state, GuardState::standing);
}

TEST_F(NaoTest, StaysDownAfterALegDidNotReachItsTarget) {
  begin();
  world_.body().block(kLeftKneePitch);
  ASSERT_TRUE(run(9.0));
  world_.body().block(kJoints);
  ASSERT_TRUE(run(6.0));
  EXPECT_EQ(nao_->guard().state, GuardState::sitting) << "it does not try again and again";
}

TEST_F(NaoTest, ReportsWhatIsMissingInEachOutage) {
  std::vector<Missing> reported;
  NaoSurroundings around = world_.surroundings([this] { return world_.now() > deadline_; });
  around.tell_missing = [&](Missing missing) { reported.push_back(missing); };
  nao_.emplace(options_, around);
  ASSERT_TRUE(run(8.0));
  reported.clear();
  for (int i = 0; i < 2; ++i) {
    world_.hide_guard(true);
    EXPECT_FALSE(run(3.0));
    world_.hide_guard(false);
    ASSERT_TRUE(run(3.0));
  }
  EXPECT_EQ(reported, (std::vector<Missing>{Missing::guard, Missing::guard}));
}

TEST_F(NaoTest, StaysDownAfterItsEngineWasStoppedUntilTheButtonIsPressed) {
  begin();
  ASSERT_TRUE(run(8.0));
  ASSERT_EQ(nao_->guard().state, GuardState::standing);
  for (int i = 0; i < 500; ++i) world_.step();  // SIGSTOP for 6 s
  ASSERT_EQ(world_.report().state, GuardState::sitting);
  ASSERT_TRUE(run(6.0));
  EXPECT_EQ(nao_->guard().state, GuardState::sitting);
  world_.body().press_chest(true);
  ASSERT_TRUE(run(0.3));
  world_.body().press_chest(false);
  ASSERT_TRUE(run(5.0));
  EXPECT_EQ(nao_->guard().state, GuardState::standing);
  EXPECT_FALSE(nao_->is_paused());
}

TEST_F(NaoTest, StaysDownAfterItsGuardWasRestartedUntilTheButtonIsPressed) {
  begin();
  ASSERT_TRUE(run(8.0));
  world_.stop_guard();  // SIGTERM
  for (int i = 0; i < 500; ++i) world_.step();
  ASSERT_TRUE(world_.body().is_soft());
  world_.restart_guard();
  ASSERT_TRUE(run(6.0));
  EXPECT_EQ(nao_->guard().state, GuardState::soft);
  EXPECT_TRUE(world_.body().sits());
  world_.body().press_chest(true);
  ASSERT_TRUE(run(0.3));
  world_.body().press_chest(false);
  ASSERT_TRUE(run(5.0));
  EXPECT_EQ(nao_->guard().state, GuardState::standing);
}

TEST_F(NaoTest, KeepsStandingWhenItsGuardIsKilledAndRestarted) {
  begin();
  ASSERT_TRUE(run(8.0));
  world_.restart_guard();
  ASSERT_TRUE(run(1.0));
  EXPECT_TRUE(world_.body().stands());
  ASSERT_TRUE(run(3.0));
  EXPECT_EQ(nao_->guard().state, GuardState::standing);
}

TEST_F(NaoTest, ShowsOnlyWhatIsTrueNow) {
  constexpr Lights::Color kDark, kGreen{0.0f, 0.5f, 0.0f}, kWhite{0.3f, 0.3f, 0.3f}, kBlue{0.0f, 0.0f, 0.2f};
  const auto lights = [this] {
    BodyRequest request;
    EXPECT_TRUE(world_.shared().request.read(request));
    return request.lights;
  };
  begin();
  world_.camera().is_plugged = false;
  EXPECT_FALSE(run(3.0));
  EXPECT_EQ(lights().chest, kDark) << "no frame has arrived";
  EXPECT_EQ(lights().left_eye[0], kDark);
  world_.camera().is_plugged = true;
  ASSERT_TRUE(run(10.0));
  EXPECT_EQ(nao_->guard().state, GuardState::standing);
  EXPECT_EQ(lights().chest, kGreen);
  EXPECT_EQ(lights().left_eye[0], kBlue);
  head_ = HeadRequest{{0.5, 0.0}, 1.0};
  ASSERT_TRUE(run(0.1));
  world_.camera().is_plugged = false;
  EXPECT_FALSE(run(3.0));
  EXPECT_EQ(lights().chest, kDark) << "the engine processes no frames";
  EXPECT_EQ(lights().left_eye[0], kDark);
  BodyRequest request;
  ASSERT_TRUE(world_.shared().request.read(request));
  EXPECT_EQ(request.moves_head, 0u) << "nor does it move without seeing";
  EXPECT_EQ(request.posture, WantedPosture::stand);
  world_.camera().is_plugged = true;
  world_.body().set_charge(0.04f);
  ASSERT_TRUE(run(8.0));
  EXPECT_EQ(nao_->guard().state, GuardState::sitting);
  EXPECT_EQ(lights().chest, kWhite) << "the engine does not use images of a sitting robot";
}

TEST_F(NaoTest, ContinuesAfterTheCameraWasUnplugged) {
  begin();
  ASSERT_TRUE(run(8.0));
  world_.camera().is_plugged = false;
  for (int i = 0; i < 100; ++i) world_.step();
  world_.camera().is_plugged = true;
  frames_ = 0;
  ASSERT_TRUE(run(4.0));
  EXPECT_GT(frames_, 60);
  EXPECT_GE(nao_->counts().restarts, 1u);
}

}  // namespace
}  // namespace reorient::nao
