// SPDX-License-Identifier: MIT
// The points of an ROC curve that are drawn.
#pragma once

#include <vector>

#include "workbench/experiments/charts/plot.h"
#include "workbench/experiments/statistics/roc.h"

namespace reorient {

/// Without points that a picture cannot distinguish from their neighbors.
std::vector<PlotPoint> as_points(const std::vector<RocPoint>& curve);

}  // namespace reorient
