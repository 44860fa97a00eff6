// SPDX-License-Identifier: MIT
// A robot for clients of the companion: the simulator with two pipes (examples/companion/robot_pipe.h). It stands
// beside the field with a set initial pose. When it has had time to learn the room, it is placed at the reflection of
// its pose. At the end it evaluates the belief of the client.
//   test_robot BODY.toml FIELD.toml SEED WIDTH [LEARN] [AFTER] [PACE]
// PACE: largest speed relative to real time. $REORIENT_HEARTBEAT: a file that gets the number of answered frames.
// $REORIENT_LIFT_WHEN: a file; the robot learns until the file exists.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>

#include <robot_pipe.h>
#include <unistd.h>

#include "geometry/pinned_math.h"
#include "geometry/random.h"
#include "robots/simulator/simulator.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"

namespace reorient {
namespace {

void write_all(const void* bytes, std::size_t size) {
  const auto* at = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = write(STDOUT_FILENO, at, size);
    if (written <= 0) throw std::runtime_error("the client has closed the pipe");
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

bool read_all(void* bytes, std::size_t size) {
  auto* at = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = read(STDIN_FILENO, at, size);
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

template <std::size_t Size>
void set(double (&numbers)[Size], std::initializer_list<double> values) {
  std::copy(values.begin(), values.end(), numbers);
}

/// Adds goal posts in view, with errors like those of a team's own vision.
void see_posts(const Simulator& simulator, const FieldDimensions& field, const CameraModel& camera, Random& random,
               pipe_frame& frame) {
  constexpr double kFarthest = 20.0, kNoise = 0.03, kRough = 0.1, kMissed = 0.3;
  const GroundTruth truth = simulator.ground_truth();
  if (truth.carried || truth.fallen) return;
  const Isometry3 camera_from_field = simulator.field_from_camera().inverse();
  for (const double x : {-0.5 * field.length, 0.5 * field.length}) {
    for (const double y : {-field.goal_post_y, field.goal_post_y}) {
      const Eigen::Vector3d post(x, y, 0.3);
      const auto pixel = camera.project(camera_from_field * post);
      const Eigen::Vector2d place = truth.pose.inverse() * Eigen::Vector2d(x, y);
      if (!pixel || !camera.contains(*pixel) || place.norm() > kFarthest || random.uniform() < kMissed) continue;
      frame.distances[frame.posts] = place.norm() * (1.0 + kRough * random.normal());
      frame.bearings[frame.posts++] = pinned::atan2(place.y(), place.x()) + kNoise * random.normal();
    }
  }
}

int play(const RobotBody& body, const FieldDimensions& field, std::uint64_t seed, int width, double learn, double after,
         double pace) {
  constexpr double kCarry = 1.5, kNear = 0.5, kHold = 2.0;  // s, m and rad, s
  SimulatorParameters parameters = simulator_parameters_of(body);
  parameters.width = width;
  const Pose2 start(-field.penalty_mark_x, -0.5 * field.width - 0.5, 0.5 * kPi);
  Simulator simulator(parameters, body, field, procedural_hall(1, room_shape_for(field)), start, seed);
  Random random(seed, 0x9057);
  Observation observation;
  bool is_lifted = false, is_down = false, is_told = false;
  const char* const heartbeat = std::getenv("REORIENT_HEARTBEAT");
  const char* const lift_when = std::getenv("REORIENT_LIFT_WHEN");
  std::uint64_t answered = 0;
  const auto begin = std::chrono::steady_clock::now();
  double distance = 0.0, turn = 0.0;  // errors of the belief at the end
  double right_since = -1.0, corrected = -1.0, put_down_at = 0.0;
  while (simulator.observe(observation)) {
    const CameraFrame& upper = *observation.upper;
    if (!is_told) {
      pipe_robot robot{};
      std::strncpy(robot.name, body.name.c_str(), sizeof(robot.name) - 1);
      robot.width = static_cast<std::uint32_t>(upper.image.width);
      robot.height = static_cast<std::uint32_t>(upper.image.height);
      set(robot.focal, {upper.camera.focal.x(), upper.camera.focal.y()});
      set(robot.center, {upper.camera.center.x(), upper.camera.center.y()});
      set(robot.distortion, {upper.camera.k1, upper.camera.k2});
      const CameraMount& mount = body.dimensions.upper;
      set(robot.position, {mount.position.x(), mount.position.y(), mount.position.z()});
      robot.tilt = mount.tilt;
      set(robot.posts, {0.5 * field.length, field.goal_post_y});
      write_all(&robot, sizeof(robot));
    }
    const double time = observation.time;
    std::this_thread::sleep_until(begin + std::chrono::duration<double>(time / pace));
    if (!is_lifted && time >= learn && (lift_when == nullptr || access(lift_when, F_OK) == 0)) {
      if (lift_when != nullptr) learn = time;
      simulator.pick_up();
      is_lifted = true;
    } else if (is_lifted && !is_down && time >= learn + kCarry) {
      simulator.put_down(reflect(simulator.ground_truth().pose));
      is_down = true;
      put_down_at = time;
    }
    pipe_frame frame{};
    frame.time = time;
    frame.is_over = is_lifted && time > learn + kCarry + after ? 1 : 0;
    const BodySample& felt = observation.body;
    const Pose2& odometry = observation.odometry;
    set(frame.odometry, {odometry.position.x(), odometry.position.y(), odometry.rotation});
    set(frame.head, {felt.head.yaw, felt.head.pitch});
    set(frame.attitude, {felt.torso.roll, felt.torso.pitch});
    set(frame.rates, {felt.angular_velocity.x(), felt.angular_velocity.y(), felt.angular_velocity.z()});
    set(frame.acceleration, {felt.acceleration.x(), felt.acceleration.y(), felt.acceleration.z()});
    frame.foot_load = body.standing_load ? felt.foot_load : -1.0;
    set(frame.told_pose, {start.position.x(), start.position.y(), start.rotation});
    frame.is_told = is_told ? 0 : 1;
    is_told = true;
    see_posts(simulator, field, upper.camera, random, frame);
    write_all(&frame, sizeof(frame));
    if (frame.is_over != 0) break;
    for (int y = 0; y < upper.image.height; ++y)
      write_all(upper.image.row(y), 2 * static_cast<std::size_t>(upper.image.width));
    pipe_request request{};
    if (!read_all(&request, sizeof(request))) return 3;
    Answer answer;
    if (request.has_head != 0) answer.request.head = HeadRequest{{request.head[0], request.head[1]}, request.head[2]};
    if (request.has_walk != 0) answer.request.walk = {request.walk[0], request.walk[1], request.walk[2]};
    answer.request.get_up = request.get_up != 0;
    simulator.answer(answer);
    if (request.has_walk != 0) ++answered;
    if (heartbeat != nullptr) std::ofstream(heartbeat) << answered << '\n';
    const Pose2 belief(request.belief[0], request.belief[1], request.belief[2]);
    const Pose2 truth = simulator.ground_truth().pose;
    distance = (belief.position - truth.position).norm();
    turn = std::abs(angle_difference(belief.rotation, truth.rotation));
    const bool is_right = request.knows != 0 && distance < kNear && turn < kNear;
    if (!is_right) right_since = -1.0;
    if (is_right && right_since < 0.0) right_since = time;
    if (is_down && corrected < 0.0 && is_right) corrected = time - put_down_at;
  }
  const bool ends_right = right_since >= 0.0 && learn + kCarry + after - right_since > kHold && corrected > 0.0;
  std::cerr << (ends_right ? "right" : "wrong") << ", corrected after " << corrected << " s; in the end off by "
            << distance << " m, " << turn << " rad\n";
  return ends_right ? 0 : 1;
}

}  // namespace
}  // namespace reorient

int main(int argc, char** argv) try {
  if (argc < 5) throw std::runtime_error("expected BODY.toml FIELD.toml SEED WIDTH [LEARN] [AFTER] [PACE]");
  reorient::RobotBody body = reorient::load_body(argv[1]);
  // The companion names a body by its file.
  const std::string file = argv[1];
  body.name = file.substr(file.rfind('/') + 1, file.rfind('.') - file.rfind('/') - 1);
  return reorient::play(body, reorient::load_field(argv[2]), std::strtoull(argv[3], nullptr, 10), std::atoi(argv[4]),
                        argc > 5 ? std::atof(argv[5]) : 40.0, argc > 6 ? std::atof(argv[6]) : 40.0,
                        argc > 7 ? std::atof(argv[7]) : 1e6);
} catch (const std::exception& error) {
  std::cerr << "test_robot: " << error.what() << '\n';
  return 2;
}
