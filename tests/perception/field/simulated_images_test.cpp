// SPDX-License-Identifier: MIT
// Quality of the field features in the simulator's images, with blur, noise, vignetting, people and other robots. The
// camera's pose is the true one, so the tests measure the vision and not the inertial unit.
#include <string>

#include <gtest/gtest.h>

#include "robots/simulator/simulator.h"
#include "workbench/simulated_images/look_around.h"

namespace reorient {
namespace {

struct Look {
  int width;
  int places;
};
class SimulatedImages : public testing::TestWithParam<Look> {
 protected:
  PerceptScore score() const {
    const FieldDimensions field;
    const FieldFeatureParameters vision;
    SimulatorParameters parameters;
    parameters.width = GetParam().width;
    parameters.labels = true;
    parameters.tilt_error = 0.0;
    parameters.other_robots = 8;
    const Room room = procedural_hall(2, {});
    Simulator simulator(parameters, RobotBody(), field, room, {-2.0, 0.0, 0.0}, 11);
    FieldFeatures features(vision, field);
    return look_around(simulator, features, field, vision, {GetParam().places, 0.0, 5});
  }
};

struct Bar {
  PerceptKind kind;
  double distance;  ///< m, largest distance that counts
  int least_in_view;
  double precision, recall;
};

TEST_P(SimulatedImages, ShowTheFieldAndWhatIsOnIt) {
  const bool is_large = GetParam().width >= 640;
  const Bar bars[] = {{PerceptKind::line_points, 4.5, 300, 0.98, 0.9},
                      {PerceptKind::goal_posts, 4.5, 3, 0.9, 0.6},
                      {PerceptKind::obstacles, 4.5, 4, 0.8, 0.7},
                      {PerceptKind::intersections, 4.5, 5, is_large ? 0.9 : 0.8, is_large ? 0.7 : 0.4},
                      {PerceptKind::ball, 4.5, 5, is_large ? 0.85 : 0.7, is_large ? 0.7 : 0.5}};
  const PerceptScore all = score();
  const PerceptCounts lines = all.between(PerceptKind::line_points, 0.0, PerceptScore::kBands.back());
  EXPECT_GE(lines.reported, 25 * all.images);
  EXPECT_LE(lines.twisted, 0.08 * lines.reported);
  for (const Bar& bar : bars) {
    const std::string name(kPerceptKinds[static_cast<std::size_t>(bar.kind)]);
    const PerceptCounts counts = all.between(bar.kind, 0.0, bar.distance);
    RecordProperty(name + ", in view", counts.in_view);
    RecordProperty(name + ", found", counts.found);
    RecordProperty(name + ", reported", counts.reported);
    RecordProperty(name + ", right", counts.right);
    EXPECT_GE(counts.in_view, bar.least_in_view) << name;
    EXPECT_GE(counts.precision(), bar.precision) << name << ": " << counts.right << " of " << counts.reported;
    EXPECT_GE(counts.recall(), bar.recall) << name << ": " << counts.found << " of " << counts.in_view;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SimulatedImages, testing::Values(Look{640, 16}, Look{320, 24}, Look{160, 32}));

}  // namespace
}  // namespace reorient
