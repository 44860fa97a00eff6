// SPDX-License-Identifier: MIT
// Confidences (the paper's Section 3.4): how far the view filter's belief supports the believed pose and its
// reflection.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "perception/room/view/view_filter.h"

namespace reorient {

/// All in [0, 1], except the evidence. `current` and `opposite` are smoothed; their raw values belong to this frame.
struct Confidences {
  double current = 0.0;
  double opposite = 0.0;
  double raw_current = 0.0;
  double raw_opposite = 0.0;
  double goal_opponent = 0.0;    ///< fraction of the view filter's belief on the wall behind the goal at +x
  double goal_own = 0.0;         ///< the same for the goal at -x
  double coverage = 0.0;         ///< fraction of the wall's tiles that are trained well enough for comparisons
  double paired = 0.0;           ///< the same for tiles together with their reflections
  double distinctiveness = 0.0;  ///< difference between the model and its rotation by 180 degrees; 0: no difference
  double separability =
      1.0;                ///< probability that the room distinguishes a pose from its mirrored pose (separability.h)
  double evidence = 0.0;  ///< log-odds for the opposite pose against the current one (evidence/evidence.h)
  double age = 0.0;       ///< s of views of known tiles since the confidences restarted
  double smoothed_for = 0.0;  ///< s of those views in the smoothed values
  int visible_tiles = 0;      ///< tiles that counted in this frame
};

template <typename Visit, ConstOr<Confidences> T>
void fields(Visit&& visit, T& c) {
  visit(c.current, c.opposite, c.raw_current, c.raw_opposite, c.goal_opponent, c.goal_own, c.coverage, c.paired,
        c.distinctiveness, c.separability, c.evidence, c.age, c.smoothed_for, c.visible_tiles);
}

struct ConfidenceParameters {
  double half_width = from_degrees(30.0);
  double goal_half_width = from_degrees(12.5);
  double time_constant = 3.0;
  bool true_mean_start = true;
  bool restart_on_purge = false;
};
template <typename Visit>
void describe(ConfidenceParameters& p, Visit&& visit) {
  visit("half_width", p.half_width, 0.01, 1.57, "rad",
        "half of the virtual field of view within which the view filter's weight counts");
  visit("goal_half_width", p.goal_half_width, 0.01, 1.57, "rad", "half of the angle of the wall behind each goal");
  visit("time_constant", p.time_constant, 0.0, 60.0, "s", "time constant of the smoothed confidences");
  visit("true_mean_start", p.true_mean_start,
        "whether confidences after a restart are the mean since the restart; otherwise they grow from zero");
  visit("restart_on_purge", p.restart_on_purge, "whether the confidences also restart after a purge");
}

/// Weight of a frame of `step` seconds in the smoothing, at the end of the first `age` seconds.
double smoothing_share(const ConfidenceParameters& parameters, double step, double age);

/// Sets the values of this frame: the filter's weight around the current and the opposite view center and behind the
/// goals.
void take_shares(Confidences& confidences, const ViewFilter& filter, double view_center,
                 const ConfidenceParameters& parameters);
/// Updates the smoothed values with those of this frame.
void smooth(Confidences& confidences, double fraction);

/// Restarts as if nothing had been observed. The evidence is unchanged.
void restart(Confidences& confidences);
/// After a flip: restarts, and changes the sign of the evidence.
void flip(Confidences& confidences);
/// Restarts and resets the evidence, since nothing is known about the believed pose.
void reset(Confidences& confidences);
/// Also resets the last frame's values, since the robot may be at another position.
void clear_views(Confidences& confidences);

}  // namespace reorient
