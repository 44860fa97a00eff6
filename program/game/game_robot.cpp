// SPDX-License-Identifier: MIT
#include "program/game/game_robot.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "geometry/pinned_math.h"
#include "workbench/run/run_summary.h"

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

double speed_of(const Body& body) { return pinned::hypot(body.velocity().forward, body.velocity().left); }

}  // namespace

GameRobot::GameRobot(int team, int number, std::unique_ptr<Simulator> simulator, FrameSetup setup)
    : team_(team),
      number_(number),
      simulator_(std::move(simulator)),
      engine_(std::make_unique<FrameLoop>(std::move(setup))) {}

void GameRobot::place(const Pose2& pose) {
  simulator_->put_down(pose);
  inputs_.external.initial_pose = InitialPose{in_axes_of(team_, pose)};
}

void GameRobot::play(const SharedWorld& world) {
  simulator_->share(world);
  const Clock::time_point begin = Clock::now();
  simulator_->observe(inputs_.observation);
  const Clock::time_point seen = Clock::now();
  Topics wanted{Topic::images};
  if (observer_ != nullptr) {
    observer_->before(inputs_, *engine_);
    wanted = wanted | observer_->wanted();
  }
  const FrameRecord& record = engine_->step(inputs_, wanted);
  const Clock::time_point end = Clock::now();
  simulator_->answer(record.answer);
  inputs_.external = {};
  if (observer_ != nullptr) {
    scene_.observing = seconds_between(begin, seen);
    scene_.stepping = seconds_between(seen, end);
    scene_.truth = simulator_->ground_truth();
    scene_.truth->pose = in_axes_of(team_, scene_.truth->pose);
    observer_->observe(record, scene_);
  }
  digest_.add(record);
  if (record.reorientation && record.reorientation->reorientation == Reorientation::flip_pose) ++flips_;
}

Player GameRobot::player() const {
  const Body& body = simulator_->robot();
  Player player;
  player.pose = body.pose();
  player.stride = speed_of(body) > 0.0 ? body.gait() : 0.0;
  player.team = team_;
  player.is_lying = body.posture() == Body::Posture::lying;
  return player;
}

MovingRobot GameRobot::moving() const {
  const Body& body = simulator_->robot();
  return {body.pose(), speed_of(body), body.posture() == Body::Posture::upright};
}

bool GameRobot::has_correct_belief() const {
  return is_correct(record().world.pose.pose, in_axes_of(team_, simulator_->ground_truth().pose));
}

}  // namespace reorient
