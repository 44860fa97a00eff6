// SPDX-License-Identifier: MIT
// The client of the header that teams copy, with a companion in the same process.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#define REORIENT_COMPANION_CLIENT
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "robots/companion/companion.h"
#include "robots/companion/reorient_companion.h"
#include "tests/robots/companion/raw_client.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class CClient : public ::testing::Test {
 protected:
  CClient() { open(client_); }
  ~CClient() override { reorient_close(&client_); }
  CClient(const CClient&) = delete;
  CClient& operator=(const CClient&) = delete;

  std::string path() const { return (folder_.path() / "socket").string(); }

  void open(reorient_client& client, const reorient_hello& hello = small_hello(7, REORIENT_OWN_LOCALIZATION)) {
    EXPECT_EQ(reorient_open(&client, path().c_str(), &hello), 0);
  }

  void begin_companion() {
    companion_.emplace(CompanionOptions{path(), no_known_robots(), ++servers_, [this] { return now_; },
                                        [this] { return ++looks_ > 3; }, 0.0});
    begun_ = false;
  }

  /// The next observation, if one has arrived.
  std::optional<Observation> observed() {
    looks_ = 0;
    const Handshake* const handshake = companion_->wait_for_handshake();
    if (handshake == nullptr) return std::nullopt;
    if (!begun_) companion_->begin(*handshake, false, 1);
    begun_ = true;
    Observation observation;
    looks_ = 0;
    if (!companion_->observe(observation)) return std::nullopt;
    return observation;
  }

  /// Sends the next frame, with the robot `x` meters from its start.
  bool send(double x = 0.0, std::uint32_t has = 0) {
    reorient_frame frame{};
    reorient_image_begin(&client_, 0);
    reorient_image_written(&client_, 0, &frame);
    time_ += 0.1;
    frame.time = time_;
    frame.has = REORIENT_HAS_TIME | has;
    frame.odometry[0] = x;
    frame.told_pose[0] = -2.0;
    frame.told_pose[1] = 1.0;
    frame.told_deviation[0] = frame.told_deviation[1] = 0.1;
    const bool sent = reorient_send_frame(&client_, &frame, nullptr, nullptr) != 0;
    EXPECT_EQ(frame.has, REORIENT_HAS_TIME | has) << "the call does not change the frame of the caller";
    return sent;
  }

  /// Reads all messages and returns the last one of a type.
  std::optional<reorient_event> heard(int wanted) {
    std::optional<reorient_event> last;
    reorient_event event;
    while (const int kind = reorient_receive(&client_, &event)) {
      if (kind == wanted) last = event;
    }
    return last;
  }

  void answer(std::optional<Reorientation> reorientation = std::nullopt) {
    Answer answer;
    answer.reorientation = reorientation;
    companion_->answer(answer);
  }

  TemporaryFolder folder_;
  double now_ = 1000.0, time_ = 0.0;
  int looks_ = 0;
  std::uint64_t servers_ = 0;
  bool begun_ = false;
  std::optional<Companion> companion_;
  reorient_client client_{};
};

TEST_F(CClient, MovesAnInitialPoseWithTheOdometryUntilAServerListens) {
  EXPECT_FALSE(send(0.0, REORIENT_HAS_TOLD_POSE));
  EXPECT_FALSE(send(0.25));
  EXPECT_FALSE(send(0.5, REORIENT_OTHER_HALF));
  begin_companion();
  EXPECT_TRUE(send(0.5, REORIENT_OTHER_HALF));
  auto observation = observed();
  ASSERT_TRUE(observation && observation->external.initial_pose);
  const InitialPose& initial = *observation->external.initial_pose;
  const Pose2 expected = reflect(Pose2(-1.5, 1.0, 0.0));
  EXPECT_NEAR((initial.pose.position - expected.position).norm(), 0.0, 1e-9) << initial.pose.position.transpose();
  EXPECT_NEAR(angle_difference(initial.pose.rotation, expected.rotation), 0.0, 1e-9);
  EXPECT_NEAR(initial.position_deviation, 0.15, 1e-9) << "a tenth of half a meter";
  EXPECT_TRUE(send(0.5, REORIENT_OTHER_HALF));
  observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->external.initial_pose) << "it is sent once";
}

TEST_F(CClient, DescribesALensAfterItsHello) {
  begin_companion();
  EXPECT_TRUE(send());
  auto observation = observed();
  ASSERT_TRUE(observation && observation->upper);
  EXPECT_EQ(observation->upper->camera.projection, CameraProjection::pinhole);
  reorient_disconnect(&client_);
  client_.lenses[0] = {REORIENT_LENS_FISHEYE, 4, {0.02, -0.004, 0.001, -0.0002}};
  EXPECT_TRUE(send());
  observation = observed();
  ASSERT_TRUE(observation && observation->upper);
  EXPECT_EQ(observation->upper->camera.projection, CameraProjection::fisheye);
  EXPECT_EQ(observation->upper->camera.k2, -0.004);
}

TEST_F(CClient, DropsAnInitialPoseThatBecameTooUncertain) {
  EXPECT_FALSE(send(0.0, REORIENT_HAS_TOLD_POSE));
  EXPECT_FALSE(send(30.0));
  begin_companion();
  EXPECT_TRUE(send(30.0));
  const auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->external.initial_pose);
}

TEST_F(CClient, SendsAnInitialPoseAgainThatTheCompanionMayHaveLost) {
  begin_companion();
  EXPECT_TRUE(send(0.0, REORIENT_HAS_TOLD_POSE));
  companion_.reset();
  EXPECT_FALSE(heard(REORIENT_ANSWER));
  begin_companion();
  EXPECT_TRUE(send());
  auto observation = observed();
  ASSERT_TRUE(observation && observation->external.initial_pose);
  answer();
  EXPECT_TRUE(heard(REORIENT_ANSWER));
  // The server received it, but may not have saved it: if it is killed now, the next one does not know it.
  const auto restart = [&] {
    companion_.reset();
    EXPECT_FALSE(heard(REORIENT_ANSWER));
    begin_companion();
    EXPECT_TRUE(send(0.5));
    observation = observed();
    ASSERT_TRUE(observation);
    EXPECT_FALSE(observation->external.initial_pose) << "the server may be the same one";
    answer();
    EXPECT_TRUE(heard(REORIENT_ANSWER));
    EXPECT_TRUE(send(0.5));
    observation = observed();
    ASSERT_TRUE(observation);
  };
  restart();
  ASSERT_TRUE(observation->external.initial_pose);
  EXPECT_NEAR(observation->external.initial_pose->pose.position.x(), -1.5, 1e-9);
  for (int i = 0; i <= REORIENT_TOLD_FRAMES; ++i) {
    answer();
    EXPECT_TRUE(heard(REORIENT_ANSWER));
    EXPECT_TRUE(send(0.5));
    observation = observed();
    ASSERT_TRUE(observation);
    EXPECT_FALSE(observation->external.initial_pose) << "once, as long as this server runs";
  }
  restart();
  EXPECT_FALSE(observation->external.initial_pose) << "the server has saved it long ago";
}

TEST_F(CClient, MovesAnUncertainInitialPoseToo) {
  reorient_frame frame{};
  frame.has = REORIENT_HAS_TIME | REORIENT_HAS_TOLD_POSE;
  frame.told_deviation[0] = 0.1;
  frame.told_deviation[1] = 3.2;  // the position is known, the rotation is not
  frame.time = time_ += 0.1;
  EXPECT_FALSE(reorient_send_frame(&client_, &frame, nullptr, nullptr));
  EXPECT_FALSE(send());
  begin_companion();
  EXPECT_TRUE(send());
  const auto observation = observed();
  ASSERT_TRUE(observation && observation->external.initial_pose);
  EXPECT_NEAR(observation->external.initial_pose->rotation_deviation, 3.2, 1e-9);
}

TEST_F(CClient, IgnoresACommandForTheBeliefBeforeAnInitialPose) {
  begin_companion();
  EXPECT_TRUE(send());
  ASSERT_TRUE(observed());
  EXPECT_TRUE(send(0.0, REORIENT_HAS_TOLD_POSE));
  answer(Reorientation::flip_pose);
  auto event = heard(REORIENT_ANSWER);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->answer.command_kind, std::uint32_t{REORIENT_FLIP});
  EXPECT_EQ(reorient_take_command(&client_, &event->answer), 0);
  ASSERT_TRUE(observed());
  answer(Reorientation::flip_pose);
  event = heard(REORIENT_ANSWER);
  ASSERT_TRUE(event);
  EXPECT_EQ(reorient_take_command(&client_, &event->answer), int{REORIENT_FLIP});
  EXPECT_EQ(reorient_take_command(&client_, &event->answer), 0);
}

TEST_F(CClient, DoesNotRepeatACommandFromAnOldAnswerAfterTheServerChanged) {
  begin_companion();
  EXPECT_TRUE(send());
  ASSERT_TRUE(observed());
  answer(Reorientation::flip_pose);
  const auto event = heard(REORIENT_ANSWER);
  ASSERT_TRUE(event);
  EXPECT_EQ(reorient_take_command(&client_, &event->answer), int{REORIENT_FLIP});
  companion_.reset();
  EXPECT_FALSE(heard(REORIENT_ANSWER));
  begin_companion();
  EXPECT_TRUE(send());
  ASSERT_TRUE(observed());
  EXPECT_TRUE(heard(REORIENT_WELCOME));
  EXPECT_EQ(reorient_take_command(&client_, &event->answer), 0) << "the command of another server";
}

TEST_F(CClient, ReadsARefusalAlthoughSendingFails) {
  begin_companion();
  RawClient first(path());
  first.introduce(small_hello(3));
  EXPECT_TRUE(send()) << "the refusal has not arrived yet";
  static_cast<void>(observed());
  EXPECT_FALSE(send());
  const auto event = heard(REORIENT_REFUSAL);
  ASSERT_TRUE(event);
  EXPECT_NE(std::string(event->refusal.why).find("another client is connected"), std::string::npos);
  EXPECT_LT(client_.socket, 0);
}

TEST_F(CClient, ClosesABrokenConnectionWithTheNextFrame) {
  begin_companion();
  EXPECT_TRUE(send());
  companion_.reset();
  EXPECT_FALSE(send());
  begin_companion();
  EXPECT_TRUE(send());
  EXPECT_TRUE(observed());
}

TEST_F(CClient, DoesNotConnectToAnotherUsersCompanion) {
  begin_companion();
  EXPECT_TRUE(send());
  reorient_disconnect(&client_);
  if (geteuid() != 0) GTEST_SKIP() << "only root can change its user";
  ASSERT_EQ(chmod(folder_.path().c_str(), 0777), 0);
  ASSERT_EQ(chmod(path().c_str(), 0777), 0);
  companion_.reset();
  ASSERT_EQ(seteuid(12345), 0);
  begin_companion();
  ASSERT_EQ(seteuid(0), 0);
  EXPECT_FALSE(send());
  EXPECT_LT(client_.socket, 0);
}

TEST_F(CClient, SendsPerceptsOfItsDetectorWithTheNextFrame) {
  client_.detector = REORIENT_PERCEPTS_INSTEAD;
  begin_companion();
  reorient_percept ball{};
  ball.what = REORIENT_PERCEPT_BALL;
  ball.confidence = 1.0f;
  ball.at[0] = 2.0f;
  reorient_set_percepts(&client_, &ball, 1);
  EXPECT_TRUE(send());
  auto observation = observed();
  ASSERT_TRUE(observation && observation->percepts);
  EXPECT_TRUE(observation->percepts->replaces_vision);
  ASSERT_EQ(observation->percepts->list.size(), 1u);
  EXPECT_EQ(observation->percepts->list[0].at[0], 2.0);
  EXPECT_TRUE(send());
  observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->percepts) << "percepts are those of one frame";
  reorient_set_percepts(&client_, nullptr, 0);
  EXPECT_TRUE(send());
  observation = observed();
  ASSERT_TRUE(observation && observation->percepts);
  EXPECT_TRUE(observation->percepts->list.empty());
}

TEST_F(CClient, WithoutADetectorSendsNoPercepts) {
  begin_companion();
  const reorient_percept ball{};
  reorient_set_percepts(&client_, &ball, 1);
  EXPECT_TRUE(send());
  const auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->percepts);
}

}  // namespace
}  // namespace reorient
