// SPDX-License-Identifier: MIT
// Concentrations of the view filter's belief on the wall.
#pragma once

#include "geometry/const_or.h"

namespace reorient {

/// A group of nearby particles, or of neighboring cells with much weight.
struct ViewCluster {
  double azimuth = 0.0;  ///< circular mean, rad
  double spread = 0.0;   ///< standard deviation, rad
  double share = 0.0;    ///< fraction of the whole belief
};
template <typename Visit, ConstOr<ViewCluster> T>
void fields(Visit&& visit, T& cluster) {
  visit(cluster.azimuth, cluster.spread, cluster.share);
}

}  // namespace reorient
