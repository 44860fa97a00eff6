// One frame from observation to request, with a robot that is only a list of observations.
#include "engine/frame.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/parameters/parameter_registry.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr double kStep = 1.0 / 30.0;

/// Hands out what it was told to feel, and keeps what it was asked for.
class ListedRobot : public Robot {
 public:
  ListedRobot() : image(160, 120) {
    for (int y = 0; y < image.height(); ++y) {
      std::uint8_t* row = image.row(y);
      for (int x = 0; x < 2 * image.width(); ++x)
        row[x] = static_cast<std::uint8_t>(x % 2 == 0 ? 40 + x / 2 : 128 + y / 4);
    }
    next.camera = CameraModel().scaled_to(image.width(), image.height());
  }

  const RobotDimensions& dimensions() const override { return dimensions_; }
  bool observe(Observation& observation) override {
    if (frames_left == 0) return false;
    --frames_left;
    next.image = image.view();
    observation = next;
    next.time += kStep;
    return true;
  }
  void request(const Request& request) override { requests.push_back(request); }

  Image image;
  Observation next;
  int frames_left = -1;  ///< negative: never ends
  std::vector<Request> requests;

 private:
  RobotDimensions dimensions_;
};

/// A loop around one scenario's text.
struct Loop {
  explicit Loop(const std::string& scenario, const FrameOptions& options = {}) {
    declare(parameters, registry);
    folder.write("scenarios/tested.lua", scenario);
    scripts = std::make_unique<ScriptHost>(folder.path(), registry);
    scripts->load_scenario("tested");
    frame = std::make_unique<FrameLoop>(robot, *scripts, parameters, FieldDimensions{}, options);
  }

  const World& world() const { return frame->world(); }
  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) ASSERT_TRUE(frame->step());
  }
  /// Steps until a command was granted.
  const Rearrangement& rearranged() {
    for (int i = 0; i < 100 && !frame->rearrangement(); ++i) frame->step();
    return frame->rearrangement().value();
  }

  ListedRobot robot;
  TemporaryFolder folder;
  CoreParameters parameters;
  ParameterRegistry registry;
  std::unique_ptr<ScriptHost> scripts;
  std::unique_ptr<FrameLoop> frame;
};

const char* const kIdle = R"(scenario "tested" {})";

/// Stands where it was told; half a second later it says `command`.
std::string told_and_then(const std::string& command) {
  return R"(scenario "tested" { initial = "told",
    state "told" { enter = function() belief.set_initial_pose(-2, 1, 0.5) end, { "acting", after = 0.5, because = "it is time" } },
    state "acting" { enter = function() )" +
         command + R"( end } })";
}
const std::string kTold = told_and_then("");

void expect_near(const Pose2& a, const Pose2& b) {
  EXPECT_LT((a.position - b.position).norm(), 0.2) << a.position.transpose() << " and " << b.position.transpose();
  EXPECT_LT(std::abs(angle_difference(a.rotation, b.rotation)), 0.2);
}

TEST(Frame, EndsWithTheRobotsLastObservation) {
  Loop loop(kIdle);
  loop.robot.frames_left = 2;
  EXPECT_TRUE(loop.frame->step());
  EXPECT_TRUE(loop.frame->step());
  EXPECT_FALSE(loop.frame->step());
  EXPECT_EQ(loop.world().frame, 2u);
  EXPECT_EQ(loop.robot.requests.size(), 2u);
}

TEST(Frame, KeepsTheRobotsTime) {
  Loop loop(kIdle);
  loop.robot.next.time = 7.0;
  loop.step(3);
  EXPECT_DOUBLE_EQ(loop.world().time, 7.0 + 2.0 * kStep);
  EXPECT_NEAR(loop.world().time_step, kStep, 1e-12);
}

TEST(Frame, HandsTheScriptsRequestToTheRobot) {
  Loop loop(R"(scenario "tested" { update = function() head.look(0.3, -0.1, 2) walk.velocity(0.1, 0, 0.4) end })");
  loop.step();
  ASSERT_EQ(loop.robot.requests.size(), 1u);
  const Request& request = loop.robot.requests.front();
  ASSERT_TRUE(request.head);
  EXPECT_EQ(request.head->angles.yaw, 0.3);
  EXPECT_EQ(request.head->angles.pitch, -0.1);
  EXPECT_EQ(request.head->speed, 2.0);
  EXPECT_EQ(request.walk.forward, 0.1);
  EXPECT_EQ(request.walk.turn, 0.4);
}

TEST(Frame, BelievesWhatItIsTold) {
  Loop loop(kTold);
  EXPECT_FALSE(loop.world().pose_known);
  loop.step();
  EXPECT_TRUE(loop.world().pose_known);
  expect_near(loop.world().pose.pose, Pose2(-2.0, 1.0, 0.5));
}

TEST(Frame, CarriesTheBeliefAlongWithTheOdometry) {
  Loop loop(kTold);
  loop.step(2);
  for (int i = 1; i <= 10; ++i) {
    loop.robot.next.odometry = Pose2(0.05 * i, 0.0, 0.0);
    loop.step();
  }
  const Pose2 walked = Pose2(-2.0, 1.0, 0.5) * Pose2(0.5, 0.0, 0.0);
  EXPECT_LT((loop.world().pose.pose.position - walked.position).norm(), 0.25);
}

TEST(Frame, FlipsTheBeliefInTheFrameThatGrantsIt) {
  Loop loop(told_and_then("command.flip_pose()"));
  const Rearrangement flip = loop.rearranged();
  EXPECT_EQ(flip.command, Command::flip_pose);
  EXPECT_EQ(flip.time, loop.world().time);
  expect_near(flip.belief_before.pose, Pose2(-2.0, 1.0, 0.5));
  expect_near(loop.world().pose.pose, Pose2(2.0, -1.0, 0.5 - kPi));
  expect_near(loop.world().pose.pose, flip.belief_after.pose);
  EXPECT_EQ(flip.particles_before.size(), flip.particles_after.size());
  EXPECT_TRUE(loop.world().pose_known);
  ASSERT_EQ(loop.frame->commands().size(), 1u);
  EXPECT_EQ(loop.frame->commands().front().verdict, Verdict::granted);
  loop.step();
  EXPECT_FALSE(loop.frame->rearrangement()) << "a rearrangement is of one frame";
}

TEST(Frame, KeepsTheBeliefWhereACommandIsRefused) {
  Loop loop(told_and_then("command.flip_pose()"));
  loop.robot.next.foot_load = 0.0;
  loop.step(30);
  EXPECT_TRUE(loop.world().carried);
  EXPECT_FALSE(loop.frame->rearrangement());
  expect_near(loop.world().pose.pose, Pose2(-2.0, 1.0, 0.5));
}

TEST(Frame, KnowsThePoseNoMoreAfterAReset) {
  Loop loop(told_and_then("command.reset_orientation()"));
  EXPECT_EQ(loop.rearranged().command, Command::reset_orientation);
  EXPECT_FALSE(loop.world().pose_known);
  loop.step(5);
  EXPECT_FALSE(loop.world().pose_known);
  EXPECT_FALSE(loop.world().training);
}

TEST(Frame, KnowsThePoseStillAfterAPurge) {
  Loop loop(told_and_then("command.purge_reflection()"));
  EXPECT_EQ(loop.rearranged().command, Command::purge_reflection);
  EXPECT_TRUE(loop.world().pose_known);
}

TEST(Frame, TrainsOnlyWithAPose) {
  Loop unknown(kIdle);
  unknown.step(10);
  EXPECT_FALSE(unknown.world().training);
  EXPECT_EQ(unknown.world().trained_seconds, 0.0);

  Loop told(kTold);
  told.step(10);
  EXPECT_TRUE(told.world().training);
  EXPECT_NEAR(told.world().trained_seconds, 9 * kStep, 1e-9);
}

TEST(Frame, NeitherTrainsNorEvaluatesNorSeesTheFieldWhileItLies) {
  Loop loop(kTold);
  loop.step(10);
  const double trained = loop.world().trained_seconds;
  loop.robot.next.torso.pitch = 1.5;
  loop.step();
  EXPECT_TRUE(loop.world().fallen);
  EXPECT_FALSE(loop.world().training);
  EXPECT_FALSE(loop.world().evaluating);
  EXPECT_EQ(loop.world().line_points, 0);
  EXPECT_EQ(loop.world().confidence.visible_tiles, 0);
  loop.step(10);
  EXPECT_EQ(loop.world().trained_seconds, trained);
}

TEST(Frame, NeitherTrainsNorEvaluatesWhileItIsCarried) {
  Loop loop(kTold);
  loop.step(10);
  loop.robot.next.foot_load = 0.0;
  loop.step(10);
  EXPECT_TRUE(loop.world().carried);
  EXPECT_FALSE(loop.world().training);
  EXPECT_FALSE(loop.world().evaluating);
  loop.robot.next.foot_load = 5.3;
  loop.step(10);
  EXPECT_TRUE(loop.world().training);
}

TEST(Frame, RestsWhatAScriptPausesFromTheNextFrameOn) {
  Loop loop(R"(scenario "tested" { initial = "told",
    state "told" { enter = function() belief.set_initial_pose(-2, 1, 0.5) end, { "pausing", after = 0.5 } },
    state "pausing" { enter = function() command.pause_training() command.pause_evaluation() end, { "going on", after = 0.5 } },
    state "going on" {} })");
  loop.step(10);
  EXPECT_TRUE(loop.world().training);
  EXPECT_TRUE(loop.world().evaluating);
  loop.step(15);
  EXPECT_FALSE(loop.world().training);
  EXPECT_FALSE(loop.world().evaluating);
  loop.step(15);
  EXPECT_TRUE(loop.world().training);
  EXPECT_TRUE(loop.world().evaluating);
}

TEST(Frame, HasNoConfidenceWithoutRoomAwareness) {
  Loop loop(kTold, {.seed = 1, .room_awareness = false});
  for (int i = 0; i < 40; ++i) {
    loop.step();
    const Confidences& confidence = loop.world().confidence;
    for (const double value : {confidence.current, confidence.opposite, confidence.coverage, confidence.goal_own,
                               confidence.goal_opponent}) {
      ASSERT_EQ(value, 0.0);
    }
    ASSERT_FALSE(loop.world().training);
    ASSERT_FALSE(loop.world().evaluating);
  }
  EXPECT_EQ(loop.frame->room(), nullptr);
}

TEST(Frame, ObeysAParameterThatIsChangedBetweenTwoFrames) {
  Loop loop(kIdle);
  loop.step();
  loop.registry.set("pose_filter.particles", "77", ParameterOrigin::live);
  loop.step();
  std::vector<Pose2> poses;
  loop.frame->pose_filter().append_poses(poses);
  EXPECT_EQ(poses.size(), 77u);
}

/// After three frames, the second of which differs.
std::uint64_t digest_after(const std::function<void(ListedRobot&)>& differ, const FrameOptions& options = {}) {
  Loop loop(kTold, options);
  loop.step();
  differ(loop.robot);
  loop.step(2);
  return loop.frame->digest().value();
}

TEST(FrameDigest, IsTheSameForTheSameObservations) {
  const auto nothing = [](ListedRobot&) {};
  EXPECT_EQ(digest_after(nothing), digest_after(nothing));
}

TEST(FrameDigest, ChangesWithAnyBitOfTheImage) {
  const std::uint64_t before = digest_after([](ListedRobot&) {});
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(319, 0), std::pair(1, 60), std::pair(160, 61),
                             std::pair(0, 119), std::pair(319, 119)}) {
    EXPECT_NE(digest_after([x = x, y = y](ListedRobot& robot) { robot.image.row(y)[x] ^= 1; }), before)
        << x << ' ' << y;
  }
}

TEST(FrameDigest, ChangesWithEachMeasurement) {
  const std::uint64_t before = digest_after([](ListedRobot&) {});
  const std::pair<const char*, std::function<void(Observation&)>> changes[] = {
      {"time", [](Observation& o) { o.time += 1e-9; }},
      {"head yaw", [](Observation& o) { o.head.yaw += 1e-9; }},
      {"head pitch", [](Observation& o) { o.head.pitch += 1e-9; }},
      {"torso roll", [](Observation& o) { o.torso.roll += 1e-9; }},
      {"torso pitch", [](Observation& o) { o.torso.pitch += 1e-9; }},
      {"odometry x", [](Observation& o) { o.odometry.position.x() += 1e-9; }},
      {"odometry y", [](Observation& o) { o.odometry.position.y() += 1e-9; }},
      {"odometry rotation", [](Observation& o) { o.odometry.rotation += 1e-9; }},
      {"foot load", [](Observation& o) { o.foot_load += 1e-9; }},
      {"hip height", [](Observation& o) { o.hip_height += 1e-9; }},
      {"penalized", [](Observation& o) { o.penalized = true; }},
      {"focal length", [](Observation& o) { o.camera.focal.x() += 1e-9; }},
      {"distortion", [](Observation& o) { o.camera.k1 += 1e-9; }},
  };
  for (const auto& [name, change] : changes) {
    EXPECT_NE(digest_after([&change = change](ListedRobot& robot) { change(robot.next); }), before) << name;
  }
}

TEST(FrameDigest, ChangesWithTheCommandsAlone) {
  const auto digest_of = [](const std::string& scenario) {
    Loop loop(scenario, {.seed = 1, .room_awareness = false});
    loop.step(30);
    return loop.frame->digest().value();
  };
  EXPECT_NE(digest_of(told_and_then("command.pause_training()")),
            digest_of(told_and_then("command.pause_evaluation()")));
  EXPECT_EQ(digest_of(told_and_then("command.pause_training()")), digest_of(told_and_then("command.pause_training()")));
}

}  // namespace
}  // namespace reorient
