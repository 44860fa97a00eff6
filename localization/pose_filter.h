// SPDX-License-Identifier: MIT
// Self-localization: a particle filter (Monte Carlo localization) over poses. The field looks the same from a pose and
// from its reflection, so the filter cannot distinguish them. Behaviors correct it with commands.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/measurement/goal_injection.h"
#include "localization/measurement/landmark_injection.h"
#include "localization/measurement/measurement_model.h"
#include "localization/measurement/recovery_estimator.h"
#include "localization/measurement/view_injection.h"
#include "localization/particles/motion_model.h"
#include "localization/particles/particle_set.h"
#include "localization/particles/pose_clusters.h"
#include "localization/pose_belief.h"
#include "perception/field/percepts.h"

namespace reorient {

struct PoseFilterParameters {
  int particles = 200;
  double resample_below = 0.5;
  MotionModelParameters motion;
  MeasurementModelParameters measurement;
  InjectionParameters injection;
  PoseClusterParameters clusters;
};

/// Describes the parameters of the filter itself; the nested structures have a describe() of their own.
template <typename Visit>
void describe(PoseFilterParameters& p, Visit&& visit) {
  visit("particles", p.particles, 10, 10000, "", "number of pose particles");
  visit("resample_below", p.resample_below, 0.0, 1.0, "",
        "fraction of the number of particles; resampling happens when the effective number is below it");
}

/// Deterministic: its results depend only on the arguments and the seed. In the steady state it allocates no memory.
class PoseFilter {
 public:
  /// Starts with particles on the whole carpet. Throws std::invalid_argument for impossible field dimensions.
  PoseFilter(const PoseFilterParameters& parameters, const FieldDimensions& field, std::uint64_t seed);

  /// Sets a pose that is known from outside. Standard deviations in m (along each axis) and rad.
  /// If a value is not finite, the same as initialize_globally().
  void set_initial_pose(const Pose2& pose, double position_deviation, double rotation_deviation);
  /// Distributes the particles over the whole carpet: the pose is unknown.
  void initialize_globally();
  /// The robot was lifted or fell: it may be away from the particles.
  void doubt() { recovery_.doubt(); }

  /// Follows the robot's motion since the last frame, `odometry_step` = last.inverse() * now, over `time_step` seconds.
  void predict(const Pose2& odometry_step, double time_step);
  /// Weighs and resamples the particles by the percept. Injects new ones from a goal in view and, while the robot is
  /// lost, from other landmarks and from the view. Ignores values of the percept that are not finite.
  /// `bias_deviation`: standard deviation of the camera's tilt, rad.
  void update(const FieldPercept& percept, SeenGoal seen_goal, const std::optional<SeenView>& view = std::nullopt,
              double bias_deviation = 0.0);
  /// The same with the percepts of two cameras, both in the robot's present frame.
  void update(const FieldPercept& upper, const FieldPercept& lower, SeenGoal seen_goal,
              const std::optional<SeenView>& view = std::nullopt, double bias_deviation = 0.0);
  /// The cameras worked, but nothing of the field was in view. `time_step`: s.
  void see_nothing(double time_step);

  /// Whether the pose was lost or has not been found yet.
  bool is_lost() const { return lost_probability() > 0.0; }
  /// The robot is at `found` or at its reflection: draws most particles around it. The view decides between the two.
  /// Without a view both sides keep their fractions of the particles.
  void take_found(const Pose2& found, const std::optional<SeenView>& view);

  // The commands. belief() is up to date when they return.
  void flip_pose();
  void purge_reflection();
  void reset_orientation();

  /// Applies from now on. If the number of particles changes, the new ones are drawn from the old ones.
  void set_parameters(const PoseFilterParameters& parameters);

  const PoseBelief& belief() const { return belief_; }
  const FieldMap& map() const { return measurement_.map(); }
  const ParticleSet& particles() const { return particles_; }
  const RecoveryEstimator& recovery() const { return recovery_; }

  /// Appends the poses of all particles, for drawing.
  void append_poses(std::vector<Pose2>& poses) const;
  /// How well the features of a percept of the last frame fit at a pose, for drawing.
  void feature_fits(const FieldPercept& percept, const Pose2& pose, FeatureFits& fits);

  /// Everything that future results depend on, except parameters and field. Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.random_, self.recovery_, self.particles_, self.elapsed_, self.searching_, self.belief_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  void complete();
  double lost_probability() const;
  void weigh();
  void resample();
  void inject(const FieldPercept& percept, SeenGoal seen_goal, const std::optional<SeenView>& view);
  Pose2 keep_sides(const Pose2& drawn);
  void find_belief() { belief_ = clusters_.find(particles_, belief_, parameters_.clusters); }

  PoseFilterParameters parameters_;
  Eigen::Vector2d half_size_;
  Random random_;
  MeasurementModel measurement_;
  GoalInjection injection_;
  LandmarkInjection landmark_injection_;
  ViewInjection view_injection_;
  RecoveryEstimator recovery_;
  PoseClusters clusters_;
  ParticleSet particles_;
  ParticleSet scratch_;
  std::vector<float> costs_;
  FieldPercept merged_;    ///< the percepts of both cameras
  ParticleSet one_{1};     ///< memory of feature_fits()
  double elapsed_ = 1.0;   ///< s, predicted since the last update
  bool searching_ = true;  ///< started globally, and not found yet
  PoseBelief belief_;
};

}  // namespace reorient
