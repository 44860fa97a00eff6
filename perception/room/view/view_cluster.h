// SPDX-License-Identifier: MIT
// Where on the wall the belief of the view filter gathers.
#pragma once

#include "geometry/const_or.h"

namespace reorient {

/// Particles that lie together, or cells that stand out together.
struct ViewCluster {
  double azimuth = 0.0;  ///< circular mean, rad
  double spread = 0.0;   ///< standard deviation, rad
  double share = 0.0;    ///< of the whole belief
};
template <typename Visit, ConstOr<ViewCluster> T>
void fields(Visit&& visit, T& cluster) {
  visit(cluster.azimuth, cluster.spread, cluster.share);
}

}  // namespace reorient
