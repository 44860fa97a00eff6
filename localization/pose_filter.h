// SPDX-License-Identifier: MIT
// Self-localization: a particle filter (Monte Carlo localization) over poses on a field that looks the same from every
// pose and its reflection. It cannot tell the two apart, and does not pretend to: behaviours correct it by commands.
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

/// Of the filter itself; the nested structures are described one by one.
template <typename Visit>
void describe(PoseFilterParameters& p, Visit&& visit) {
  visit("particles", p.particles, 10, 10000, "", "how many pose particles");
  visit("resample_below", p.resample_below, 0.0, 1.0, "",
        "resample once the effective number of particles is below this share of all");
}

/// Everything that it does follows from its arguments and the seed. In the steady state it allocates no memory.
class PoseFilter {
 public:
  /// Starts anywhere. Throws std::invalid_argument for impossible field dimensions.
  PoseFilter(const PoseFilterParameters& parameters, const FieldDimensions& field, std::uint64_t seed);

  /// Somebody told where the robot stands. Standard deviations in m (along each axis) and rad.
  /// Where any of that is not finite, the same as initialize_globally().
  void set_initial_pose(const Pose2& pose, double position_deviation, double rotation_deviation);
  /// Nobody knows.
  void initialize_globally();
  /// The robot was carried or fell: it may stand elsewhere than where the particles are.
  void doubt() { recovery_.doubt(); }

  /// Follows the robot's motion since the last frame, `odometry_step` = last.inverse() * now, over `time_step` seconds.
  void predict(const Pose2& odometry_step, double time_step);
  /// Weighs and resamples the particles by what was seen, and injects new ones where a goal was seen; where the robot
  /// is lost, with the headings that the view gives, too. What is not finite in the percept is left out.
  /// `bias_deviation`: how well the camera's tilt is known, rad.
  void update(const FieldPercept& percept, SeenGoal seen_goal, const std::optional<SeenView>& view = std::nullopt,
              double bias_deviation = 0.0);
  /// The same with what two cameras saw; each in the robot's present frame.
  void update(const FieldPercept& upper, const FieldPercept& lower, SeenGoal seen_goal,
              const std::optional<SeenView>& view = std::nullopt, double bias_deviation = 0.0);
  /// The robot looked, and saw nothing of the field. `time_step`: s.
  void see_nothing(double time_step);

  /// Whether the particles have lost the robot, or have not found it yet.
  bool is_lost() const { return lost_probability() > 0.0; }
  /// The robot stands there, or at the reflection of that: most particles are drawn around it. The view says on which
  /// side; without one they stay on their sides.
  void take_found(const Pose2& found, const std::optional<SeenView>& view);

  /// The commands; belief() is up to date when they return.
  void flip_pose();
  void purge_reflection();
  void reset_orientation();

  /// From now on. A new number of particles is drawn from the old ones.
  void set_parameters(const PoseFilterParameters& parameters);

  const PoseBelief& belief() const { return belief_; }
  const FieldMap& map() const { return measurement_.map(); }
  const ParticleSet& particles() const { return particles_; }
  const RecoveryEstimator& recovery() const { return recovery_; }

  /// For drawing: the poses of all particles, appended.
  void append_poses(std::vector<Pose2>& poses) const;

  /// All that decides what comes next; parameters and field are as they are. Throws BadBytes.
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
  FieldPercept merged_;    ///< of both cameras
  double elapsed_ = 1.0;   ///< s, predicted since the last update
  bool searching_ = true;  ///< started anywhere, and not found yet
  PoseBelief belief_;
};

}  // namespace reorient
