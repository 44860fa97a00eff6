// SPDX-License-Identifier: MIT
// Confidences (the paper's Section 3.4): how far the belief of the view supports the believed pose and its reflection.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "perception/room/view/view_filter.h"

namespace reorient {

/// All in [0, 1], except the evidence; `current` and `opposite` are smoothed, their raw values are this frame's.
struct Confidences {
  double current = 0.0;
  double opposite = 0.0;
  double raw_current = 0.0;
  double raw_opposite = 0.0;
  double goal_opponent = 0.0;    ///< share of the belief of the view on the wall behind the goal at +x
  double goal_own = 0.0;         ///< the same, behind the goal at -x
  double coverage = 0.0;         ///< share of the wall's tiles that are trained well enough to be compared with
  double paired = 0.0;           ///< the same, together with their reflections
  double distinctiveness = 0.0;  ///< how much the model differs from itself turned by 180 degrees: 0 is the same
  double separability = 1.0;     ///< probability that the room can tell a pose from its reflection (separability.h)
  double evidence = 0.0;         ///< log-odds for the opposite pose against the current one (evidence/evidence.h)
  double age = 0.0;              ///< s of views of known tiles since the confidences began anew
  double smoothed_for = 0.0;     ///< s of those of them that the smoothed ones are made of
  int visible_tiles = 0;         ///< tiles that counted in this frame
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

/// Weight of a frame of `step` seconds in the smoothing, when it ends the first `age` seconds.
double smoothing_share(const ConfidenceParameters& parameters, double step, double age);

/// This frame's own: the filter's shares around the current and the opposite view centre and behind the goals.
void take_shares(Confidences& confidences, const ViewFilter& filter, double view_center,
                 const ConfidenceParameters& parameters);
/// Takes them into the smoothed ones.
void smooth(Confidences& confidences, double share);

/// They restart: as if nothing had been seen. The evidence stays.
void restart(Confidences& confidences);
/// The believed pose was flipped: what spoke for its reflection speaks for it.
void flip(Confidences& confidences);
/// Nothing is known of the believed pose: what was seen before says nothing about it.
void reset(Confidences& confidences);
/// The robot may stand elsewhere: not even what was seen last says anything.
void clear_views(Confidences& confidences);

}  // namespace reorient
