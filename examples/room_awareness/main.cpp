// SPDX-License-Identifier: MIT
// Room awareness alone, in a program with its own localization: the inputs are images and the believed pose, the output
// is the evidence that the belief is mirrored. Here the images are generated, and the belief is mirrored on purpose.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>

#include <reorient/geometry/head.h>
#include <reorient/geometry/image.h>
#include <reorient/geometry/pinned_math.h>
#include <reorient/perception/room/room_awareness.h>

namespace {

using namespace reorient;

constexpr double kFrame = 1.0 / 15.0;  // s
const Pose2 kTruth(-2.0, -1.5, kPi / 2);

/// Replaces the robot's camera: a hall with 24 panels of different colors around the robot, above a green floor.
/// `direction`: direction of the camera on the field, rad.
void paint(Image& image, const CameraModel& camera, double direction) {
  const int horizon = camera.height / 2 + camera.height / 16;
  for (int x = 0; x < camera.width; x += 2) {
    const Eigen::Vector3d ray = camera.ray({x + 0.5, camera.center.y()});
    const double turns = (direction + pinned::atan2(ray.y(), ray.x())) / (2.0 * kPi);
    const int panel = static_cast<int>(24.0 * (turns - std::floor(turns)));
    for (int y = 0; y < camera.height; ++y) {
      const bool floor = y > horizon;
      std::uint8_t* const pair = image.row(y) + 2 * x;
      pair[0] = pair[2] = static_cast<std::uint8_t>(floor ? 90 : 60 + 37 * panel % 120);
      pair[1] = static_cast<std::uint8_t>(floor ? 110 : 100 + 29 * panel % 60);
      pair[3] = static_cast<std::uint8_t>(floor ? 100 : 100 + 47 * panel % 60);
    }
  }
}

/// A robot that stands, scans with its head and checks its belief with the room. A team replaces it with its own
/// program.
class Localization {
 public:
  Pose2 belief = kTruth;
  bool train = true;

  /// Runs frames for some seconds. Returns the time until the evidence required a flip, or nothing.
  std::optional<double> flipped_within(double seconds) {
    constexpr double kSure = 9.2;  // log-odds: one such flip in 10 000 is wrong
    for (double begin = time_; time_ < begin + seconds; time_ += kFrame) {
      if (look().evidence < kSure) continue;
      belief = reflect(belief);  // a pose filter mirrors all of its particles
      room_.on_flip();
      return time_ - begin;
    }
    return std::nullopt;
  }

  /// Call this after the belief was set, because the evidence so far belongs to the previous belief.
  void start_at(const Pose2& pose) {
    belief = pose;
    room_.restart();
  }

  const Confidences& confidences() const { return room_.confidences(); }

 private:
  const Confidences& look() {
    const double yaw = 1.8 * pinned::sin(time_);  // rad, of the head to the left
    paint(image_, camera_, kTruth.rotation + yaw);
    RoomObservation view;
    view.time = time_;
    view.image = image_.view();
    view.camera = camera_;
    view.robot_from_camera = robot_from_camera(RobotDimensions(), {yaw, 0.0}, {}, RobotDimensions().torso_height);
    view.belief = belief;
    view.odometry_rotation = 0.0;  // the robot stands
    view.train = train;
    return room_.update(view);
  }

  CameraModel camera_ = CameraModel::from_fields_of_view(160, 120, from_degrees(56.3), from_degrees(43.7));
  Image image_{160, 120};
  RoomAwareness room_{RoomParameters(), 1};  // the same seed and images: the same answers
  double time_ = 0.0;                        // s
};

/// Prints one line and returns whether the decision was the expected one.
bool report(const char* situation, std::optional<double> flipped, bool expected, const Confidences& room) {
  std::printf("%s: %s", situation, flipped ? "flip" : "keep");
  if (flipped) {
    std::printf(", after %.1f s\n", *flipped);
  } else {
    std::printf(" (evidence %.1f)\n", room.evidence);
  }
  return flipped.has_value() == expected;
}

}  // namespace

int main() {
  Localization robot;
  bool right = report("learning", robot.flipped_within(20.0), false, robot.confidences());
  robot.train = false;  // training with a mirrored belief would learn a mirrored room
  robot.start_at(kTruth);
  right &= report("correct belief", robot.flipped_within(8.0), false, robot.confidences());
  robot.start_at(reflect(kTruth));
  right &= report("mirrored belief", robot.flipped_within(8.0), true, robot.confidences());
  right &= report("after the flip", robot.flipped_within(8.0), false, robot.confidences());
  return right ? 0 : 1;
}
