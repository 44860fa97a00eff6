// SPDX-License-Identifier: MIT
// The percepts of the field from the last seconds, each image with the robot's pose in the odometry frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "geometry/bytes.h"
#include "geometry/camera_bias.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"
#include "perception/field/percepts.h"

namespace reorient {

/// The percepts of one image, m, in the robot's frame at the time of the image.
struct Sighting {
  struct Line {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double normal = 0.0;    ///< rad
    double variance = 1.0;  ///< m^2, across the line
  };
  template <typename Visit, ConstOr<Line> T>
  friend void fields(Visit&& visit, T& line) {
    visit(line.place, line.normal, line.variance);
  }
  /// A position and a direction, which determine a pose for each landmark of this type on the field.
  struct Landmark {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double direction = 0.0;                ///< rad
    std::optional<IntersectionKind> kind;  ///< empty: the center circle with the direction of the halfway line
  };
  template <typename Visit, ConstOr<Landmark> T>
  friend void fields(Visit&& visit, T& landmark) {
    visit(landmark.place, landmark.direction, landmark.kind);
  }
  static constexpr std::size_t kMostLines = 12, kMostPosts = 2, kMostLandmarks = 4;

  double time = 0.0;  ///< s
  Pose2 odometry;
  std::uint32_t camera = 0;                             ///< 0: the upper one
  Isometry3 robot_from_camera = Isometry3::Identity();  ///< from which the positions were computed
  TiltBias used;                                        ///< the bias that robot_from_camera is corrected by
  std::array<Line, kMostLines> lines;
  /// Posts with the base in view.
  std::array<Eigen::Vector2d, kMostPosts> posts{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  std::uint32_t line_count = 0;
  std::uint32_t post_count = 0;
  std::array<Landmark, kMostLandmarks> landmarks;
  std::uint32_t landmark_count = 0;
};
template <typename Visit, ConstOr<Sighting> T>
void fields(Visit&& visit, T& sighting) {
  visit(sighting.time, sighting.odometry, sighting.camera, sighting.robot_from_camera, sighting.used, sighting.lines,
        sighting.posts, sighting.line_count, sighting.post_count, sighting.landmarks, sighting.landmark_count);
}

/// The latest sightings. Allocates no memory.
class Sightings {
 public:
  static constexpr std::size_t kMost = 20;
  static constexpr double kBetween = 0.25;  ///< s, shortest time between two of one camera
  static constexpr double kOldest = 6.0;    ///< s

  /// Adds a percept if it shows enough and the last one of this camera is old enough. Deletes those that are too old.
  void add(const FieldPercept& percept, std::size_t camera, const Isometry3& robot_from_camera, const TiltBias& used,
           const Pose2& odometry, double time);
  /// Deletes sightings before `time` (s).
  void forget_before(double time);
  void clear() { count_ = 0; }

  std::size_t size() const { return count_; }
  const Sighting& operator[](std::size_t index) const { return all_[index]; }
  std::size_t points() const;
  std::size_t landmarks() const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.all_, self.count_, self.last_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  void complete() const;

  std::array<Sighting, kMost> all_;  ///< the first `count_` are valid, the oldest first
  std::uint32_t count_ = 0;
  std::array<double, 2> last_{-1e9, -1e9};  ///< s, of each camera
};

}  // namespace reorient
