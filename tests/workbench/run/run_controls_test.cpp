// SPDX-License-Identifier: MIT
// Requests of the user to a run: actions of the operator, and the pace.
#include "workbench/run/run_controls.h"

#include <chrono>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/workbench/run/hand_fed_robot.h"

namespace reorient {
namespace {

using Texts = std::vector<std::string>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The message of what `call` throws; empty if it throws nothing.
std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

OperatorRequestValues pose_values(double x, double y, double degrees) {
  OperatorRequestValues values;
  values.x = x;
  values.y = y;
  values.degrees = degrees;
  return values;
}

/// A user who acts before a frame, and during a pause.
class User : public InputSource {
 public:
  void add_to(FrameInputs& inputs) override {
    if (before) before(frames++, inputs);
  }
  void add_while_paused(FrameInputs& inputs, const FrameRecord& last, const SceneTruth& /*scene*/) override {
    if (paused) paused(polls++, inputs, last);
  }

  std::function<void(int frame, FrameInputs& inputs)> before;
  std::function<void(int poll, FrameInputs& inputs, const FrameRecord& last)> paused;
  int frames = 0, polls = 0;
};

/// Stores the parts of frames that the tests compare.
class Watcher : public Observer {
 public:
  void observe(const FrameRecord& frame, const SceneTruth& scene) override {
    times.push_back(frame.world.time);
    scenes.push_back(scene);
    changes.push_back(frame.parameter_changes.size());
    initial_poses.push_back(frame.inputs.initial_pose);
  }
  /// The notes of this frame: "viewer: mirror".
  Texts notes(std::size_t frame) const {
    Texts all;
    for (const LogRecord& log : scenes[frame].scenario.logs)
      all.push_back(scenes[frame].scenario.name(log.machine) + ": " + log.text);
    return all;
  }

  std::vector<double> times;
  std::vector<SceneTruth> scenes;
  std::vector<std::size_t> changes;
  std::vector<std::optional<InitialPose>> initial_poses;
};

class ControlledRun : public ::testing::Test {
 protected:
  /// Runs until this many frames were observed.
  RunEnd run_frames(std::size_t frames, bool has_operator = true) {
    run.emplace(has_operator);
    RunParts parts = run->parts({&user}, {&watcher});
    parts.stop = [&, frames] { return watcher.times.size() >= frames || is_stopped; };
    return RunLoop(std::move(parts)).run();
  }
  void request(const std::string& name, const OperatorRequestValues& values = {}) {
    run->controls.request(operator_request(name, values), kViewerName);
  }

  std::optional<HandFedRun> run;
  User user;
  Watcher watcher;
  bool is_stopped = false;
};

TEST_F(ControlledRun, TakesNoFrameWhileItIsPaused) {
  std::size_t frames_of_pause = 0;
  user.before = [&](int frame, FrameInputs&) {
    if (frame == 3) run->controls.change_pace("pause").pause();
  };
  user.paused = [&](int poll, FrameInputs&, const FrameRecord& last) {
    frames_of_pause = watcher.times.size();
    EXPECT_EQ(last.world.time, watcher.times.back());
    if (poll == 5) run->controls.change_pace("resume").resume();
  };
  run_frames(7);
  EXPECT_EQ(frames_of_pause, 4u) << "the pause begins after the frame of the request";
  EXPECT_EQ(user.polls, 6);
  for (std::size_t i = 1; i < watcher.times.size(); ++i)
    EXPECT_NEAR(watcher.times[i] - watcher.times[i - 1], HandFedLoop::kStep, 1e-9) << "the robot does not notice";
}

TEST_F(ControlledRun, RunsSingleFramesOfAPause) {
  Texts seen;
  user.before = [&](int frame, FrameInputs&) {
    if (frame == 0) run->controls.change_pace("pause").pause();
  };
  user.paused = [&](int poll, FrameInputs&, const FrameRecord&) {
    seen.push_back(std::to_string(watcher.times.size()));
    if (poll == 0) run->controls.take_frames(1);
    if (poll == 1) run->controls.take_frames(3);
    if (poll == 2) is_stopped = true;
  };
  EXPECT_EQ(run_frames(100), RunEnd::stopped);
  EXPECT_EQ(seen, (Texts{"1", "2", "5"}));
}

TEST_F(ControlledRun, AppliesChangesOfAPauseInTheNextFrame) {
  user.before = [&](int frame, FrameInputs&) {
    if (frame == 0) run->controls.change_pace("pause").pause();
  };
  user.paused = [&](int poll, FrameInputs& inputs, const FrameRecord&) {
    if (poll == 0)
      inputs.parameter_changes.push_back({"field_features.pixel_deviation", "3", ParameterOrigin::live, ""});
    if (poll == 1) request("pick_up");
    if (poll == 2) {
      EXPECT_EQ(run->robot->done, Texts());
      run->controls.change_pace("resume").resume();
    }
  };
  run_frames(3);
  EXPECT_EQ(watcher.changes, (std::vector<std::size_t>{0, 1, 0}));
  EXPECT_EQ(watcher.notes(1), (Texts{"viewer: pick_up"}));
}

TEST_F(ControlledRun, EndsAlsoWhileItIsPaused) {
  user.before = [&](int, FrameInputs&) { run->controls.change_pace("pause").pause(); };
  user.paused = [&](int, FrameInputs&, const FrameRecord&) { is_stopped = true; };
  EXPECT_EQ(run_frames(100), RunEnd::stopped);
  EXPECT_EQ(watcher.times.size(), 1u);
}

TEST_F(ControlledRun, CarriesOutActionsJustBeforeTheNextFrame) {
  user.before = [&](int frame, FrameInputs&) {
    if (frame != 1) return;
    request("put_down", pose_values(1.0, -2.0, 90.0));
    request("penalize");
  };
  run_frames(4);
  EXPECT_EQ(run->robot->done, (Texts{"put_down", "penalize"}));
  expect_near(run->robot->pose, Pose2(1.0, -2.0, 0.5 * kPi), 1e-9);
  EXPECT_EQ(watcher.notes(1), Texts());
  EXPECT_EQ(watcher.notes(2), (Texts{"viewer: put_down at x 1.00 m, y -2.00 m, 90.0 degrees", "viewer: penalize on"}));
  EXPECT_EQ(watcher.notes(3), Texts()) << "an action is shown once";
  ASSERT_EQ(watcher.scenes[2].scenario.actions.size(), 2u);
  EXPECT_EQ(watcher.scenes[2].scenario.actions[0].kind, OperatorAction::Kind::put_down);
  expect_near(watcher.scenes[2].truth->pose, Pose2(1.0, -2.0, 0.5 * kPi), 1e-9);
}

TEST_F(ControlledRun, MirrorsTheTruePoseInOneAction) {
  const Pose2 before(-3.0, 1.0, 0.5);
  user.before = [&](int frame, FrameInputs&) {
    if (frame == 0) request("mirror");
  };
  run_frames(2);
  EXPECT_EQ(run->robot->done, (Texts{"pick_up", "put_down"}));
  expect_near(run->robot->pose, reflect(before), 1e-9);
  EXPECT_EQ(watcher.notes(1), (Texts{"viewer: mirror"}));
}

TEST_F(ControlledRun, UsesTheAxesOfTheTeamAfterHalfTime) {
  user.before = [&](int frame, FrameInputs& inputs) {
    if (frame == 0) inputs.external.half_time = true;
    if (frame == 1) request("put_down", pose_values(1.0, -2.0, 0.0));
  };
  run_frames(3);
  expect_near(run->robot->pose, reflect(Pose2(1.0, -2.0, 0.0)), 1e-9);
  expect_near(watcher.scenes[2].truth->pose, Pose2(1.0, -2.0, 0.0), 1e-9);
}

TEST_F(ControlledRun, SetsTheInitialPoseOfARobotWithoutAnOperator) {
  std::string problem;
  user.before = [&](int frame, FrameInputs&) {
    if (frame != 0) return;
    request("set_initial_pose", pose_values(2.0, 1.0, -45.0));
    problem = refusal([&] { request("pick_up"); });
  };
  run_frames(3, false);
  EXPECT_NE(problem.find("pick_up: expected a robot that this program can lift and place"), std::string::npos);
  ASSERT_TRUE(watcher.initial_poses[1]);
  expect_near(watcher.initial_poses[1]->pose, Pose2(2.0, 1.0, -0.25 * kPi), 1e-9);
  EXPECT_FALSE(watcher.initial_poses[2]);
  EXPECT_EQ(watcher.notes(1), (Texts{"viewer: set_initial_pose at x 2.00 m, y 1.00 m, -45.0 degrees"}));
  EXPECT_EQ(watcher.notes(2), Texts());
}

TEST(OperatorRequests, RefuseHostileValuesWithOneLine) {
  const auto problem = [](const std::string& name, const OperatorRequestValues& values) {
    return refusal([&] { operator_request(name, values); });
  };
  for (const std::string name : {"put_down", "set_initial_pose"}) {
    EXPECT_EQ(problem(name, pose_values(-100.0, 100.0, 36000.0)), "");
    for (const double bad : {kNan, kInfinite, -kInfinite, 1e308, -101.0}) {
      EXPECT_NE(problem(name, pose_values(bad, 0.0, 0.0)).find(name + ": expected a pose"), std::string::npos);
      EXPECT_NE(problem(name, pose_values(0.0, bad, 0.0)).find(name + ": expected a pose"), std::string::npos);
    }
    for (const double bad : {kNan, kInfinite, 1e308})
      EXPECT_NE(problem(name, pose_values(0.0, 0.0, bad)).find(name + ": expected a pose"), std::string::npos);
    EXPECT_EQ(problem(name, {}), name + ": x: expected a number, found none");
  }
  OperatorRequestValues light;
  for (const double bad : {kNan, kInfinite, 8.5, -1e9}) {
    light.stops = bad;
    EXPECT_NE(problem("set_exposure_compensation", light).find("expected -8 to 8 stops, found "), std::string::npos);
  }
  EXPECT_EQ(problem("mirrors", {}), "unknown action 'mirrors' (did you mean 'mirror'?)");
  EXPECT_NE(problem("half_time", {}).find("unknown action"), std::string::npos) << "the referee's, not the operator's";
  EXPECT_LT(problem(std::string(100'000, 'x'), {}).size(), 200u);
  EXPECT_EQ(problem("\n\x1B", {}).find('\n'), std::string::npos);
}

TEST(OperatorRequests, AreLimitedToTheFieldAndWhatIsAroundIt) {
  RunControls controls(true, true);
  const auto problem = [&](double x, double y) {
    return refusal([&] { controls.request(operator_request("put_down", pose_values(x, y, 0.0)), kViewerName); });
  };
  EXPECT_EQ(problem(60.0, 45.0), "");
  controls.set_field(FieldDimensions());
  const Eigen::Vector2d most = carpet_half_size(FieldDimensions()) + Eigen::Vector2d(1.0, 1.0);
  EXPECT_EQ(problem(most.x() - 0.01, 0.01 - most.y()), "");
  EXPECT_NE(problem(most.x() + 0.01, 0.0).find("put_down: expected a place within "), std::string::npos);
  EXPECT_NE(problem(0.0, -most.y() - 0.01).find("of the field's center, found 0.0 m, "), std::string::npos);
  EXPECT_EQ(refusal([&] { controls.request(operator_request("mirror", {}), kViewerName); }), "");
}

TEST(OperatorRequests, AreBounded) {
  RunControls controls(true, true);
  const auto add = [&] { controls.request(operator_request("change_light", {}), kViewerName); };
  for (int i = 0; i < 100; ++i) add();
  EXPECT_NE(refusal(add).find("at most 100 actions"), std::string::npos);
  EXPECT_EQ(controls.take().size(), 100u);
  EXPECT_EQ(refusal(add), "");
}

TEST(PaceOfARun, IsRefusedIfTheRobotSetsIt) {
  RunControls controls(true, false);
  EXPECT_NE(refusal([&] { controls.change_pace("pause").pause(); }).find("pause: expected the simulator or footage"),
            std::string::npos);
  EXPECT_NE(refusal([&] { controls.set_speed(1.0); }), "");
  EXPECT_NE(refusal([&] { controls.take_frames(1); }), "");
}

TEST(PaceOfARun, RefusesNumbersOutOfRange) {
  RunControls controls(true, true);
  for (const double bad : {kNan, kInfinite, 0.0, -1.0, 0.04, 20.1})
    EXPECT_NE(refusal([&] { controls.set_speed(bad); }).find("speed: expected 0.05 to 20 times real time, found "),
              std::string::npos);
  for (const int bad : {0, -1, 1001, std::numeric_limits<int>::max()})
    EXPECT_NE(refusal([&] { controls.take_frames(bad); }).find("frame: expected 1 to 1000 frames, found "),
              std::string::npos);
  EXPECT_EQ(controls.pace().speed(), 1.0);
  EXPECT_FALSE(controls.pace().is_paused());
}

TEST(PaceOfARun, DividesTheTimeBetweenFramesByTheSpeed) {
  using std::chrono::milliseconds;
  RunPace pace;
  pace.begin(10.0);
  EXPECT_EQ(pace.due(12.0) - pace.due(11.0), milliseconds(1000));
  pace.set_speed(4.0);
  const RunPace::Clock::time_point begin = pace.due(20.0);
  EXPECT_EQ(pace.due(21.0) - begin, milliseconds(250)) << "counted from the first frame after the change";
  pace.set_speed(0.5);
  const RunPace::Clock::time_point slow = pace.due(30.0);
  EXPECT_EQ(pace.due(31.0) - slow, milliseconds(2000));
}

}  // namespace
}  // namespace reorient
