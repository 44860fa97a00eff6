// SPDX-License-Identifier: MIT
#include "perception/room/view/confidences.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"

namespace reorient {

double smoothing_share(const ConfidenceParameters& parameters, double step, double age) {
  if (parameters.time_constant <= 0.0) return 1.0;
  const double fraction = -pinned::expm1(-step / parameters.time_constant);
  return parameters.true_mean_start ? fraction / -pinned::expm1(-age / parameters.time_constant) : fraction;
}

void take_shares(Confidences& confidences, const ViewFilter& filter, double view_center,
                 const ConfidenceParameters& parameters) {
  confidences.raw_current = filter.share_near(view_center, parameters.half_width);
  confidences.raw_opposite = filter.share_near(view_center + kPi, parameters.half_width);
  confidences.goal_opponent = filter.share_near(0.0, parameters.goal_half_width);
  confidences.goal_own = filter.share_near(kPi, parameters.goal_half_width);
}

void smooth(Confidences& confidences, double fraction) {
  confidences.current += fraction * (confidences.raw_current - confidences.current);
  confidences.opposite += fraction * (confidences.raw_opposite - confidences.opposite);
}

void restart(Confidences& confidences) {
  confidences.current = confidences.opposite = 0.0;
  confidences.age = confidences.smoothed_for = 0.0;
}

void flip(Confidences& confidences) {
  restart(confidences);
  confidences.evidence = -confidences.evidence;
}

void reset(Confidences& confidences) {
  restart(confidences);
  confidences.evidence = 0.0;
}

void clear_views(Confidences& confidences) {
  reset(confidences);
  confidences.raw_current = confidences.raw_opposite = 0.0;
  confidences.goal_own = confidences.goal_opponent = 0.0;
}

}  // namespace reorient
