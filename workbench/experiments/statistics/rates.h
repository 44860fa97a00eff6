// SPDX-License-Identifier: MIT
// Intervals of rates: fractions of trials, and events per time.
#pragma once

#include "workbench/experiments/statistics/interval.h"

namespace reorient {

/// For the fraction of trials in which an event happens (Wilson 1927, without continuity correction). Without trials: 0
/// to 1.
Interval wilson_interval(int events, int trials);

/// For the expected number of events if `events` were observed: exact and conservative (Garwood 1936).
Interval poisson_interval(int events);

/// For the rate of events over an exposure, in events per unit of it. Without exposure: 0 to infinity.
Interval poisson_rate(int events, double exposure);

}  // namespace reorient
