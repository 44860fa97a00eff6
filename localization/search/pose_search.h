// SPDX-License-Identifier: MIT
// Finds the pose of a lost robot and the errors of its camera's angles: matches the percepts of the last seconds with
// the field, for many poses and tilts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/bytes.h"
#include "geometry/camera_bias.h"
#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/measurement/field_line_map.h"
#include "localization/measurement/field_map.h"
#include "localization/measurement/landmark_poses.h"
#include "localization/search/sightings.h"

namespace reorient {

struct PoseSearchParameters {
  bool enabled = true;
  int candidates = 60;
  int fewest_points = 80;
  double least_time = 1.0;
  double least_fit = 0.8;
  double lead = 6.0;
};

template <typename Visit>
void describe(PoseSearchParameters& p, Visit&& visit) {
  visit("enabled", p.enabled, "whether a lost robot matches its percepts of the last seconds with the field");
  visit("candidates", p.candidates, 2, 1000, "", "number of poses and tilts tried in each frame");
  visit("fewest_points", p.fewest_points, 1, 200, "", "smallest number of line points and posts for a search");
  visit("least_time", p.least_time, 0.0, 6.0, "s", "shortest time from the first to the last percept of a search");
  visit("least_fit", p.least_fit, 0.1, 1.0, "",
        "smallest fraction of the line points on lines for a pose that counts as found");
  visit("lead", p.lead, 0.0, 100.0, "", "smallest lead of the best pose over any other, in log-likelihood");
}

/// One pose, with the bias of the angles that belongs to it.
struct PoseHypothesis {
  Pose2 field_from_odometry;
  CameraBias bias;    ///< without a deviation
  double cost = 0.0;  ///< -log of the likelihood, up to a constant
  double fit = 0.0;   ///< fraction of the line points on lines
};
template <typename Visit, ConstOr<PoseHypothesis> T>
void fields(Visit&& visit, T& one) {
  visit(one.field_from_odometry, one.bias.torso, one.bias.mounts, one.cost, one.fit);
}

class PoseSearch {
 public:
  PoseSearch(const PoseSearchParameters& parameters, const FieldDimensions& field, std::uint64_t seed);

  void set_parameters(const PoseSearchParameters& parameters) { parameters_ = parameters; }

  /// Stores the percept of one camera, see Sightings::add().
  void see(const FieldPercept& percept, std::size_t camera, const Isometry3& robot_from_camera, const TiltBias& used,
           const Pose2& odometry, double time) {
    sightings_.add(percept, camera, robot_from_camera, used, odometry, time);
  }
  /// The robot may have moved at `time`, s: deletes all earlier percepts.
  void forget_before(double time);

  /// Tries some more poses, and the believed one. Returns a pose if it is clear that the robot is there or at its
  /// reflection; then the next call starts a new search. `map`: of this field.
  std::optional<PoseHypothesis> search(const FieldMap& map, const BiasPrior& prior, const Pose2& odometry,
                                       const Pose2& believed);
  /// Ends the search, because the pose is known.
  void stop() {
    count_ = 0;
    searched_ = 0;
  }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.random_, self.sightings_, self.best_, self.count_, self.searched_, self.next_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  static constexpr std::size_t kMostHypotheses = 8;

  void complete() const;
  PoseHypothesis draw(const BiasPrior& prior, const Pose2& odometry);
  double rough_cost(const PoseHypothesis& one, const FieldMap& map) const;
  void refine(PoseHypothesis& one, const BiasPrior& prior, const Pose2& odometry) const;
  const Eigen::Vector2d& nearest_post(const Eigen::Vector2d& place) const;
  void evaluate(PoseHypothesis& one, const FieldMap& map, const BiasPrior& prior) const;
  void store(const PoseHypothesis& one, const Pose2& odometry);

  PoseSearchParameters parameters_;
  FieldLineMap lines_;
  std::array<Eigen::Vector2d, 4> posts_;
  IntersectionsByKind intersections_;
  Eigen::Vector2d carpet_;  ///< half of its size, m
  Random random_;
  Sightings sightings_;
  std::array<PoseHypothesis, kMostHypotheses> best_;  ///< the first `count_`, none of them near to another
  std::uint32_t count_ = 0;
  std::uint32_t searched_ = 0;  ///< frames
  std::uint32_t next_ = 0;      ///< the next one to be refined
};

}  // namespace reorient
