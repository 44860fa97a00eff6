#include "engine/core_parameters.h"

#include "engine/parameters/parameter_registry.h"

namespace reorient {

void declare(CoreParameters& parameters, ParameterRegistry& registry) {
  registry.bind("posture", parameters.posture);
  registry.bind("field_features", parameters.field_features);
  registry.bind("pose_filter", parameters.pose_filter);
  registry.bind("motion_model", parameters.pose_filter.motion);
  registry.bind("measurement_model", parameters.pose_filter.measurement);
  registry.bind("goal_injection", parameters.pose_filter.injection);
  registry.bind("pose_clusters", parameters.pose_filter.clusters);
  for_each_part(parameters.room, [&](const char* prefix, auto& part) { registry.bind(prefix, part); });
  registry.bind("room_status", parameters.room_status);
  registry.bind("goal_view", parameters.goal_view);
  registry.bind("arbiter", parameters.arbiter);
}

}  // namespace reorient
