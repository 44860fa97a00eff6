// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/corner_compass.h"

namespace reorient {

CornerCompass::CornerCompass(const CornerCompassParameters& parameters)
    : parameters_(parameters), map_(parameters.map), decision_(parameters.decision) {}

void CornerCompass::learn(const RoomObservation& view) {
  const auto seen = CornerView::of(view, parameters_.contrast, parameters_.corners);
  if (seen) map_.learn(*seen);
}

double CornerCompass::compare(const RoomObservation& view) {
  const auto seen = CornerView::of(view, parameters_.contrast, parameters_.corners);
  if (seen) decision_.update(map_.fit(*seen, false), map_.fit(*seen, true), map_.coverage());
  return 0.0 - decision_.ratio();  // not -0 without evidence
}

}  // namespace reorient
