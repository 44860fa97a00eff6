// SPDX-License-Identifier: MIT
#include "perception/room/view/view_filter.h"

#include <algorithm>
#include <cmath>

#include "perception/room/view/azimuth.h"

namespace reorient {

void ViewFilter::spread(const ViewFilterParameters& parameters) {
  method_ = parameters.method;
  particles_.spread(on_grid() ? 0 : parameters.particles);
  grid_.spread(on_grid() ? parameters.cells : 0);
  clusters_.clear();
  clusters_.reserve(particles().size() + grid_.cells());
}

bool ViewFilter::is_made_for(const ViewFilterParameters& parameters) const {
  const std::size_t parts = on_grid() ? grid_.cells() : particles().size();
  const int expected = on_grid() ? parameters.cells : parameters.particles;
  return method_ == parameters.method && parts == static_cast<std::size_t>(expected);
}

void ViewFilter::rotate_by_180_degrees() {
  particles_.rotate_by_180_degrees();
  grid_.rotate_by_180_degrees();
  for (ViewCluster& cluster : clusters_) cluster.azimuth = opposite(cluster.azimuth);
}

void ViewFilter::predict(double motion, double step, const ViewFilterParameters& parameters) {
  on_grid() ? grid_.predict(motion, step, parameters) : particles_.predict(motion, step, parameters);
}

void ViewFilter::correct(const ViewpointScores& scores, double view_center, double step,
                         const ViewFilterParameters& parameters) {
  on_grid() ? grid_.correct(scores, view_center, step, parameters)
            : particles_.correct(scores, view_center, step, parameters);
}

double ViewFilter::share_near(double azimuth, double half_width) const {
  return on_grid() ? grid_.share_near(azimuth, half_width) : particles_.share_near(azimuth, half_width);
}

void ViewFilter::find_clusters() {
  clusters_.clear();
  on_grid() ? grid_.find_clusters(clusters_) : particles_.find_clusters(clusters_);
  std::sort(clusters_.begin(), clusters_.end(),
            [](const ViewCluster& a, const ViewCluster& b) { return a.share > b.share; });
}

/// Checks values after reading.
void ViewFilter::check(ViewMethod method) const {
  check_bytes(method == method_, "view filter: expected the method of the parameters, found another one");
  check_bytes(clusters_.size() <= particles().size() + grid_.cells(),
              "view filter: more clusters than particles or cells");
  for (const ViewCluster& cluster : clusters_)
    check_bytes(std::abs(cluster.azimuth) <= kPi && cluster.spread >= 0.0 && cluster.share >= 0.0 &&
                    std::isfinite(cluster.spread) && std::isfinite(cluster.share),
                "view filter: a cluster has an invalid value");
}

}  // namespace reorient
