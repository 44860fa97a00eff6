// SPDX-License-Identifier: MIT
// One frame from the inputs to the answer.
#include "engine/frame.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "engine/script/script_error.h"
#include "robots/simulator/simulator.h"
#include "tests/engine/frame_fixture.h"
#include "tests/perception/room/saved_models.h"

namespace reorient {
namespace {

constexpr double kStep = HandFedLoop::kStep;
const Pose2 kPlace(-2.0, 1.0, 0.5);
/// Its initial pose is set at the start.
struct LoopWithPose : HandFedLoop {
  explicit LoopWithPose(const std::string& behavior, FrameSetup setup = {}) : HandFedLoop(behavior, std::move(setup)) {
    set_pose(kPlace);
  }
};

TEST(Frame, UsesTheTimeOfTheRobot) {
  HandFedLoop loop(kIdle);
  loop.inputs.observation.time = 7.0;
  loop.step(3);
  EXPECT_DOUBLE_EQ(loop.world().time, 7.0 + 2.0 * kStep);
  EXPECT_NEAR(loop.world().time_step, kStep, 1e-12);
  EXPECT_EQ(loop.world().frame, 3u);
}

TEST(Frame, LoadsCameraAnglesFromASavedModelOfTheSameBodyOnly) {
  KnownBias known{digest_of(RobotBody()), {}};
  known.bias.torso.pitch = 0.05;
  known.bias.deviation = 0.005;
  const auto begun_with = [](const KnownBias& bias) {
    FrameSetup setup;
    setup.model = test::some_model(1);
    setup.model->camera_bias = bias;
    HandFedLoop loop(kIdle, std::move(setup));
    return loop.step().world.camera_bias;
  };
  EXPECT_NEAR(begun_with(known).torso.pitch, 0.05, 1e-6);
  EXPECT_LT(begun_with(known).deviation, from_degrees(1.0));
  RobotBody taller;
  taller.dimensions.torso_height += 0.01;
  EXPECT_EQ(begun_with({digest_of(taller), known.bias}).torso.pitch, 0.0) << "the angles belong to another body";
}

TEST(Frame, AnswersWithTheRequestsOfScripts) {
  HandFedLoop loop(
      R"(behavior "tested" { update = function() head.look(0.3, -0.1, 2) walk.velocity(0.1, 0, 0.4) end })");
  const Request& request = loop.step().answer.request;
  ASSERT_TRUE(request.head);
  EXPECT_EQ(request.head->angles.yaw, 0.3);
  EXPECT_EQ(request.head->angles.pitch, -0.1);
  EXPECT_EQ(request.head->speed, 2.0);
  EXPECT_EQ(request.walk.forward, 0.1);
  EXPECT_EQ(request.walk.turn, 0.4);
}

TEST(Frame, AppliesASetPoseInTheSameFrame) {
  HandFedLoop loop(kIdle);
  loop.step();
  EXPECT_FALSE(loop.world().pose_known);
  loop.set_pose(kPlace);
  loop.step();
  EXPECT_TRUE(loop.world().pose_known);
  expect_near(loop.world().pose.pose, kPlace);
  ASSERT_TRUE(loop.record().inputs.initial_pose);
  expect_near(loop.record().inputs.initial_pose->pose, kPlace);
  loop.step();
  EXPECT_FALSE(loop.record().inputs.initial_pose);
}

TEST(Frame, AppliesInputsOfTheRobotsOwnSoftwareAsWell) {
  HandFedLoop loop(kIdle);
  loop.inputs.observation.external.initial_pose = InitialPose{kPlace};
  loop.inputs.observation.external.referee = RefereeState{true};
  loop.step();
  EXPECT_TRUE(loop.world().pose_known);
  EXPECT_TRUE(loop.world().referee.penalized);
  loop.inputs.observation.external = {};
  loop.step();
  EXPECT_TRUE(loop.world().referee.penalized) << "until the referee ends the penalty";
}

constexpr const char* kWalking = R"(behavior "restless" { initial = "on", state "on" {
  update = function() head.look(0.5, 0.1, 1) walk.velocity(0.1, 0, 0) end } })";

TEST(Frame, WalksOnlyIfTheRefereePermits) {
  HandFedLoop loop(kWalking);
  const std::pair<RefereeState, bool> cases[] = {
      {{}, true},
      {{false, GameState::initial}, false},
      {{false, GameState::ready}, true},
      {{false, GameState::set}, false},
      {{false, GameState::playing}, true},
      {{true, GameState::playing}, false},
      {{false, GameState::finished}, false},
      {{false, GameState::standby}, false},
      {{false, GameState::playing, true}, false},
  };
  for (const auto& [referee, walks] : cases) {
    loop.inputs.external.referee = referee;
    loop.step();
    EXPECT_EQ(loop.world().may_walk, walks);
    EXPECT_EQ(loop.record().answer.request.walk.forward > 0.0, walks) << to_string(referee.state);
    EXPECT_EQ(loop.record().answer.request.head.has_value(), !referee.stopped) << "the head must stop, too";
  }
}

TEST(Frame, MovesTheBeliefWithTheOdometry) {
  LoopWithPose loop(kIdle);
  loop.step(2);
  for (int i = 1; i <= 10; ++i) {
    loop.inputs.observation.odometry = Pose2(0.05 * i, 0.0, 0.0);
    loop.step();
  }
  const Pose2 walked = kPlace * Pose2(0.5, 0.0, 0.0);
  EXPECT_LT((loop.world().pose.pose.position - walked.position).norm(), 0.25);
}

TEST(Frame, FlipsTheBeliefInTheFrameThatGrantsIt) {
  LoopWithPose loop(then("command.flip_pose()"));
  loop.wanted = {Topic::pose_particles};
  const FrameRecord& record = loop.reoriented();
  const ReorientationRecord& flip = *record.reorientation;
  EXPECT_EQ(flip.reorientation, Reorientation::flip_pose);
  EXPECT_EQ(record.name(flip.issuer.machine), "tested");
  EXPECT_EQ(record.name(flip.issuer.state), "acting");
  EXPECT_EQ(record.name(flip.issuer.reason), "it is time");
  expect_near(flip.belief_before.pose, kPlace, 0.2);
  expect_near(loop.world().pose.pose, reflect(kPlace), 0.2);
  expect_near(loop.world().pose.pose, flip.belief_after.pose, 0.2);
  EXPECT_EQ(record.pose_particles.before.size(), record.pose_particles.particles.size());
  expect_near(record.pose_particles.before.front(), kPlace, 0.2);
  EXPECT_TRUE(loop.world().pose_known);
  EXPECT_EQ(record.answer.reorientation, Reorientation::flip_pose);
  ASSERT_EQ(record.commands.size(), 1u);
  EXPECT_EQ(record.commands.front().verdict, Verdict::granted);
  loop.step();
  EXPECT_FALSE(loop.record().reorientation) << "a reorientation is recorded in one frame only";
  EXPECT_FALSE(loop.record().answer.reorientation);
  EXPECT_TRUE(loop.record().pose_particles.before.empty());
}

TEST(Frame, DoesNotChangeTheBeliefIfACommandIsRefused) {
  LoopWithPose loop(then("command.flip_pose()"));
  loop.lift();
  for (int i = 0; i < 30; ++i) {
    loop.step();
    EXPECT_FALSE(loop.record().reorientation);
  }
  EXPECT_EQ(loop.world().posture, Posture::lifted);
  expect_near(loop.world().pose.pose, kPlace);
}

TEST(Frame, SeesTheFieldWithBothCamerasEachWithItsOwnPose) {
  SimulatorParameters parameters;
  parameters.width = 320;
  parameters.cameras = Cameras::both;
  const FieldDimensions field;
  Simulator simulator(parameters, RobotBody(), field, procedural_hall(1, {}), Pose2(-0.8, 0.0, 0.0),
                      1);  // before the center circle
  FrameSetup setup;
  setup.scripts.apply({"behaviors/tested.lua", ScriptText{kIdle, ""}});
  setup.behaviors = {"tested"};
  FrameLoop engine(std::move(setup));
  FrameInputs inputs;
  inputs.external.initial_pose = InitialPose{Pose2(-0.8, 0.0, 0.0)};
  std::size_t lower_points = 0;
  for (int i = 0; i < 60; ++i) {
    simulator.observe(inputs.observation);
    const FrameRecord& record = engine.step(inputs);
    inputs.external = {};
    ASSERT_TRUE(record.inputs.lower);
    EXPECT_LT(record.inputs.lower->time, record.inputs.upper->time);
    EXPECT_EQ(record.inputs.room_camera, HeadCamera::upper);
    lower_points += record.percepts[1].line_points.size();
    for (const LinePoint& point : record.percepts[1].line_points) {
      const Eigen::Vector2d on_field = simulator.ground_truth().pose * point.position;
      EXPECT_LT(on_field.norm(), 2.5) << "the lower camera looks near the feet";
    }
  }
  EXPECT_GT(lower_points, 60u);
  EXPECT_LT((engine.record().world.pose.pose.position - Eigen::Vector2d(-0.8, 0.0)).norm(), 0.2);
}

TEST(Frame, UsesTheLowerCameraForTheRoomWithoutAnUpperCamera) {
  LoopWithPose loop(kIdle);
  loop.step();
  EXPECT_EQ(loop.record().inputs.room_camera, HeadCamera::upper);
  loop.inputs.observation.lower = loop.inputs.observation.upper;
  loop.inputs.observation.upper.reset();
  loop.inputs.observation.time += 0.05;
  loop.inputs.observation.lower->time = loop.inputs.observation.time;
  loop.engine->step(loop.inputs);
  EXPECT_EQ(loop.record().inputs.room_camera, HeadCamera::lower);
  EXPECT_GT(loop.world().confidence.visible_tiles, 0);
  loop.inputs.observation.lower.reset();
  loop.engine->step(loop.inputs);
  EXPECT_FALSE(loop.record().inputs.room_camera);
}

TEST(Frame, HasAnUnknownPoseAfterAReset) {
  LoopWithPose loop(then("command.reset_orientation()"));
  EXPECT_EQ(loop.reoriented().reorientation->reorientation, Reorientation::reset_orientation);
  EXPECT_FALSE(loop.world().pose_known);
  loop.step(5);
  EXPECT_FALSE(loop.world().pose_known);
  EXPECT_FALSE(loop.world().training);
}

TEST(Frame, HasAKnownPoseAfterAPurge) {
  LoopWithPose loop(then("command.purge_reflection()"));
  EXPECT_EQ(loop.reoriented().reorientation->reorientation, Reorientation::purge_reflection);
  EXPECT_TRUE(loop.world().pose_known);
}

TEST(Frame, ReportsThatAnUnknownRoomCannotDistinguishThePoses) {
  HandFedLoop loop(kIdle);
  const Answer& answer = loop.step().answer;
  EXPECT_FALSE(answer.room.usable);
  EXPECT_EQ(answer.room.evidence, 0.0);
}

TEST(Frame, TrainsOnlyWithAKnownPose) {
  HandFedLoop unknown(kIdle);
  unknown.step(10);
  EXPECT_FALSE(unknown.world().training);
  EXPECT_EQ(unknown.world().trained_seconds, 0.0);

  LoopWithPose known(kIdle);
  known.step(10);
  EXPECT_TRUE(known.world().training);
  EXPECT_NEAR(known.world().trained_seconds, 9 * kStep, 1e-9);  // not in the frame in which the pose was set
}

TEST(Frame, DoesNotTrainInTheFrameInWhichAPoseIsSet) {
  LoopWithPose loop(kIdle);
  loop.step(10);
  const double trained = loop.world().trained_seconds;
  loop.set_pose(Pose2(1.0, 0.5, 0.0));
  loop.step();
  EXPECT_FALSE(loop.world().training);
  EXPECT_EQ(loop.world().trained_seconds, trained);
  loop.step();
  EXPECT_TRUE(loop.world().training);
}

TEST(Frame, TrainsForAtMostAFifthOfASecondWithOneImage) {
  LoopWithPose loop(kIdle);
  loop.step(10);
  const double trained = loop.world().trained_seconds;
  loop.inputs.observation.time += 2.0;
  loop.step();
  EXPECT_NEAR(loop.world().trained_seconds, trained + 0.2, 1e-9);
}

TEST(Frame, DiscardsTheLearnedRoomIfTheWallChanges) {
  LoopWithPose loop(kIdle);
  loop.step(10);
  loop.inputs.parameter_changes.push_back({"view_filter.sharpness", "100", ParameterOrigin::live, ""});
  loop.step();
  EXPECT_NEAR(loop.world().trained_seconds, 10 * kStep, 1e-9);
  loop.inputs.parameter_changes.push_back({"wall.columns", "36", ParameterOrigin::live, ""});
  loop.step();
  EXPECT_NEAR(loop.world().trained_seconds, kStep, 1e-9);
}

TEST(Frame, NeitherTrainsNorEvaluatesNorDetectsTheFieldWhileLying) {
  LoopWithPose loop(kIdle);
  loop.step(10);
  const double trained = loop.world().trained_seconds;
  loop.inputs.observation.body.torso.pitch = 1.5;
  loop.inputs.observation.upper->robot_from_camera =
      robot_from_camera(RobotDimensions(), {}, {0.0, 1.5}, RobotDimensions().torso_height);
  loop.step();
  EXPECT_EQ(loop.world().posture, Posture::lying);
  EXPECT_FALSE(loop.world().training);
  EXPECT_FALSE(loop.world().evaluating);
  EXPECT_EQ(loop.world().line_points, 0);
  EXPECT_EQ(loop.world().confidence.visible_tiles, 0);
  loop.step(10);
  EXPECT_EQ(loop.world().trained_seconds, trained);
}

TEST(Frame, IgnoresAnInitialPoseFarFromAnyField) {
  LoopWithPose loop(kIdle);
  loop.step(10);
  const Pose2 before = loop.world().pose.pose;
  for (const Pose2& pose : {Pose2(1e308, 0.0, 0.0), Pose2(0.0, std::nan(""), 0.0)}) {
    loop.inputs.external.initial_pose = InitialPose{pose};
    loop.step();
    EXPECT_FALSE(loop.record().inputs.initial_pose);
    ASSERT_EQ(loop.record().logs.size(), 1u);
    EXPECT_NE(loop.record().logs[0].text.find("initial pose ignored: expected a pose within 100 m"), std::string::npos);
    EXPECT_NEAR((loop.world().pose.pose.position - before.position).norm(), 0.0, 0.1);
  }
}

TEST(Frame, NeitherTrainsNorEvaluatesWhileLifted) {
  LoopWithPose loop(kIdle);
  loop.step(10);
  loop.lift();
  EXPECT_EQ(loop.world().posture, Posture::lifted);
  EXPECT_FALSE(loop.world().training);
  EXPECT_FALSE(loop.world().evaluating);
  EXPECT_EQ(loop.world().time_since_disturbance, 0.0);
  loop.put_down();
  EXPECT_TRUE(loop.world().training);
  EXPECT_GT(loop.world().time_since_disturbance, 0.0);
}

TEST(Frame, AppliesAPauseOfAScriptFromTheNextFrame) {
  LoopWithPose loop(R"(behavior "tested" { initial = "waiting",
    state "waiting" { { "pausing", after = 0.5 } },
    state "pausing" { enter = function() command.pause_training() command.pause_evaluation() end, { "running", after = 0.5 } },
    state "running" {} })");
  loop.step(10);
  EXPECT_TRUE(loop.world().training);
  EXPECT_TRUE(loop.world().evaluating);
  loop.step(15);
  EXPECT_FALSE(loop.world().training);
  EXPECT_FALSE(loop.world().evaluating);
  EXPECT_TRUE(loop.record().answer.training_paused);
  EXPECT_EQ(loop.record().leases.size(), 2u);
  loop.step(15);
  EXPECT_TRUE(loop.world().training);
  EXPECT_TRUE(loop.world().evaluating);
  EXPECT_TRUE(loop.record().leases.empty());
}

TEST(Frame, HasNoConfidenceWithoutRoomAwareness) {
  FrameSetup setup;
  setup.room_awareness = false;
  LoopWithPose loop(kIdle, std::move(setup));
  loop.wanted = {Topic::room};
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
  EXPECT_TRUE(loop.record().room.model.empty());
}

TEST(Frame, StartsWithItsOverridesAndAppliesAChange) {
  FrameSetup setup;
  setup.parameters.push_back({"pose_filter.particles", "66", ParameterOrigin::command_line, ""});
  HandFedLoop loop(kIdle, std::move(setup));
  loop.wanted = {Topic::pose_particles};
  EXPECT_EQ(loop.step().pose_particles.particles.size(), 66u);
  loop.inputs.parameter_changes.push_back({"pose_filter.particles", "77", ParameterOrigin::live, ""});
  loop.step();
  EXPECT_EQ(loop.record().pose_particles.particles.size(), 77u);
  ASSERT_EQ(loop.record().parameter_changes.size(), 1u);
  EXPECT_EQ(loop.record().parameter_changes[0].value, "77");
  EXPECT_EQ(loop.record().parameter_changes[0].refusal, "");
  loop.inputs.parameter_changes.push_back({"pose_filter.particles", "-1", ParameterOrigin::live, ""});
  loop.step();
  EXPECT_EQ(loop.record().pose_particles.particles.size(), 77u);
  EXPECT_NE(loop.record().parameter_changes[0].refusal.find("10 to 10000"), std::string::npos);
}

TEST(Frame, AppliesAnEditBeforeItsBehaviorsTick) {
  HandFedLoop loop(R"(behavior "tested" { update = function() walk.velocity(0.1, 0, 0) end })");
  EXPECT_EQ(loop.step().answer.request.walk.forward, 0.1);
  loop.inputs.script_edits.push_back(
      {"behaviors/tested.lua",
       ScriptText{R"(behavior "tested" { update = function() walk.velocity(0.2, 0, 0) end })", ""}});
  EXPECT_EQ(loop.step().answer.request.walk.forward, 0.2);
  ASSERT_EQ(loop.record().reloads.size(), 1u);
  EXPECT_TRUE(loop.record().reloads[0].accepted);
  loop.inputs.script_edits.push_back({"behaviors/tested.lua", ScriptText{"behavior \"broken", ""}});
  EXPECT_EQ(loop.step().answer.request.walk.forward, 0.2);
  EXPECT_FALSE(loop.record().reloads[0].accepted);
  EXPECT_EQ(loop.record().reloads[0].fault.line, 1);
  EXPECT_TRUE(loop.step().reloads.empty());
}

TEST(Frame, RefusesAnInvalidSetupWithAReason) {
  const auto refusal = [](const std::function<void(FrameSetup&)>& spoil) -> std::string {
    FrameSetup setup;
    spoil(setup);
    try {
      HandFedLoop loop(kIdle, std::move(setup));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refusal([](FrameSetup& setup) { setup.behaviors = {"tset"}; }).find("script not found"), std::string::npos);
  EXPECT_NE(refusal([](FrameSetup& setup) {
              setup.parameters = {{"pose_filter.particles", "x", ParameterOrigin::file, "team.toml:3"}};
            }).find("invalid value 'x'"),
            std::string::npos);
  EXPECT_EQ(refusal([](FrameSetup& setup) {
              setup.parameters = {{"later.x", "x", ParameterOrigin::file, ""}};
            }),
            "accepted");
}

TEST(Frame, FillsExpensiveTopicsOnlyOnRequest) {
  LoopWithPose loop(then("command.flip_pose()"));
  loop.step(3);
  const FrameRecord& record = loop.record();
  EXPECT_EQ(record.filled, Topics::always());
  EXPECT_TRUE(record.pose_particles.particles.empty());
  EXPECT_TRUE(record.room.model.empty());
  EXPECT_TRUE(record.images.upper.empty());
  EXPECT_TRUE(record.conditions.empty());
  EXPECT_TRUE(record.parameters.empty());
  EXPECT_TRUE(record.room.evidence.empty());
  loop.wanted = Topics::all();
  loop.step();
  EXPECT_EQ(record.filled, Topics::all());
  EXPECT_FALSE(record.pose_particles.particles.empty());
  EXPECT_FALSE(record.room.model.empty());
  EXPECT_EQ(record.room.evidence.size(), record.room.model.size());
  EXPECT_EQ(record.images.upper.data, loop.image.view().data);
  ASSERT_EQ(record.conditions.size(), 1u);
  EXPECT_EQ(record.name(record.conditions[0].target), "acting");
  EXPECT_NEAR(record.conditions[0].waited, 3 * kStep, 1e-9);
  EXPECT_FALSE(record.parameters.empty());
  EXPECT_GT(record.costs.seconds[static_cast<std::size_t>(Stage::room)], 0.0);
}

}  // namespace
}  // namespace reorient
