// SPDX-License-Identifier: MIT
// How often something happens: of a number of trials, or in a span of time.
#pragma once

#include "workbench/experiments/statistics/interval.h"

namespace reorient {

/// Of the share of trials in which it happens (Wilson 1927, without continuity correction). Without trials: 0 to 1.
Interval wilson_interval(int events, int trials);

/// Of the number of events that are to be expected where so many were seen: exact, if wide (Garwood 1936).
Interval poisson_interval(int events);

/// Of the rate of events over an exposure, in events per unit of it. Without exposure: 0 to infinity.
Interval poisson_rate(int events, double exposure);

}  // namespace reorient
