// SPDX-License-Identifier: MIT
#include "tests/perception/room/painted_room.h"

#include <algorithm>
#include <cmath>

namespace reorient::test {
namespace {

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l)); }

}  // namespace

PaintedRoom PaintedRoom::colorful(std::uint64_t seed) {
  PaintedRoom room;
  Random random(seed);
  for (int i = 0; i < kColumns * kRows; ++i) {
    room.panels_.push_back(
        {byte(random.uniform(40, 200)), byte(random.uniform(95, 160)), byte(random.uniform(95, 160))});
  }
  return room;
}

PaintedRoom PaintedRoom::symmetric(std::uint64_t seed) {
  PaintedRoom room = colorful(seed);
  for (int row = 0; row < kRows; ++row) {
    const auto first = room.panels_.begin() + row * kColumns;
    std::copy(first, first + kColumns / 2, first + kColumns / 2);
  }
  return room;
}

PaintedRoom PaintedRoom::plain() {
  PaintedRoom room;
  room.panels_.assign(kColumns * kRows, Ycbcr{180, 128, 128});
  return room;
}

Ycbcr PaintedRoom::color(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const {
  const Eigen::Vector2d from = eye.head<2>();
  const Eigen::Vector2d along = direction.head<2>();
  const double a = along.squaredNorm();
  if (a < 1e-9) return {120, 128, 128};
  const double b = from.dot(along);
  const double steps = (-b + std::sqrt(b * b - a * (from.squaredNorm() - radius * radius))) / a;
  const Eigen::Vector3d point = eye + steps * direction;
  if (point.z() < 0.4) return {90, 110, 100};
  if (point.z() >= 3.4) return {120, 128, 128};
  const int row = static_cast<int>(point.z() - 0.4);
  const double turns = std::atan2(point.y(), point.x()) / (2.0 * kPi);
  const int column = static_cast<int>((turns < 0.0 ? turns + 1.0 : turns) * kColumns) % kColumns;
  return panels_[static_cast<std::size_t>(row * kColumns + column)];
}

Image PaintedRoom::render(const CameraModel& camera, const Isometry3& field_from_camera, const Exposure& exposure,
                          Random& noise) const {
  Image image(camera.width, camera.height);
  const Eigen::Vector3d eye = field_from_camera.translation();
  for (int y = 0; y < camera.height; ++y) {
    std::uint8_t* row = image.row(y);
    for (int x = 0; x < camera.width; x += 2) {
      const Eigen::Vector3d direction = field_from_camera.linear() * camera.ray({x + 0.5, static_cast<double>(y)});
      const Ycbcr painted = color(eye, direction);
      const auto grain = [&noise] { return noise.uniform(-3.0, 3.0); };
      row[2 * x] = byte(exposure.gain * painted.y + grain());
      row[2 * x + 1] = byte(128 + exposure.gain * (painted.cb - 128) + exposure.cb_shift + grain());
      row[2 * x + 2] = byte(exposure.gain * painted.y + grain());
      row[2 * x + 3] = byte(128 + exposure.gain * (painted.cr - 128) + exposure.cr_shift + grain());
    }
  }
  return image;
}

RoomObservation ScanningRobot::look() {
  constexpr double kPeriod = 5.0;  // s for a sweep to both sides and back
  const double phase = std::fmod(time, kPeriod) / kPeriod;
  const double yaw = from_degrees(110.0) * (std::abs(4.0 * phase - 2.0) - 1.0);
  RoomObservation view;
  view.time = time;
  view.camera = small_camera();
  view.robot_from_camera = standing_camera(yaw);
  view.belief = belief;
  view.train = train;
  view.evaluate = evaluate;
  image_ = room.render(view.camera, to_isometry(truth) * view.robot_from_camera, exposure, noise_);
  view.image = image_.view();
  return view;
}

void ScanningRobot::run(double seconds) {
  constexpr double kStep = 1.0 / 15.0;
  const auto frames = static_cast<int>(std::lround(seconds / kStep));
  for (int i = 0; i < frames; ++i) {
    awareness.update(look());
    time += kStep;
  }
}

}  // namespace reorient::test
