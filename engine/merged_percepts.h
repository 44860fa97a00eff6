// SPDX-License-Identifier: MIT
// Adds the percepts of a detector outside of the engine to those of the field vision.
#pragma once

#include <array>

#include "engine/detector_views.h"
#include "geometry/field_dimensions.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/percepts.h"
#include "robots/external_percepts.h"

namespace reorient {

struct ExternalPerceptParameters {
  double least_confidence = 0.3;
};
template <typename Visit>
void describe(ExternalPerceptParameters& p, Visit&& visit) {
  visit("least_confidence", p.least_confidence, 0.0, 1.0, "",
        "smallest confidence at which a percept of an external detector is used");
}

/// Adds the valid percepts to those of the camera that shows them. Where both found the same thing, the external
/// percept replaces the engine's own. An intersection without a direction gets it from the same intersection of the
/// field vision, or from the lines around it, and is ignored without these. Ignores everything without a camera.
void add_external(const ExternalPercepts& external, const DetectorCameras& cameras, const FieldDimensions& field,
                  const ExternalPerceptParameters& parameters, const FieldFeatureParameters& features,
                  std::array<FieldPercept, 2>& percepts);

}  // namespace reorient
