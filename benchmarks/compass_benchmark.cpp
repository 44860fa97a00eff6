// SPDX-License-Identifier: MIT
// Time of one frame of room awareness and of each of its peers, with a learned room, on one core. Compare ratios within
// one run.
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "geometry/head.h"
#include "geometry/random.h"
#include "workbench/experiments/peers/compass_look.h"
#include "workbench/experiments/peers/compass_methods.h"

namespace reorient {
namespace {

/// Patches of color with grain, so that all directions have features.
Image patchwork(int width, int height) {
  Image image(width, height);
  Random random(3);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = image.row(y);
    for (int x = 0; x < width; x += 2) {
      const int patch = 7 * (24 * x / width) + 11 * (8 * y / height);
      row[2 * x] = static_cast<std::uint8_t>(40 + 29 * patch % 150 + static_cast<int>(random.below(9)));
      row[2 * x + 1] = static_cast<std::uint8_t>(100 + 53 * patch % 56 + static_cast<int>(random.below(5)));
      row[2 * x + 2] = row[2 * x];
      row[2 * x + 3] = static_cast<std::uint8_t>(100 + 31 * patch % 56 + static_cast<int>(random.below(5)));
    }
  }
  return image;
}

/// Arguments: method, width. Sets only the values of the paper's method that affect the time.
void Compare(benchmark::State& state) {
  const auto method = static_cast<std::size_t>(state.range(0));
  const auto width = static_cast<int>(state.range(1));
  CompassParameters parameters;
  parameters.room_paper.wall.rows = 2;
  parameters.room_paper.wall.top = 3.1;
  parameters.room_paper.light.enabled = false;
  parameters.room_paper.color.blur = 0.05;
  parameters.room_paper.distance.measure = Distance::ssd3;
  const std::unique_ptr<OrientationCompass> compass = std::move(make_compasses(parameters, 1)[method]);
  const Image image = patchwork(width, width * 3 / 4);
  const RobotDimensions dimensions;
  RoomObservation view;
  view.image = image.view();
  view.camera = CameraModel::from_fields_of_view(width, width * 3 / 4, from_degrees(56.3), from_degrees(43.7));
  view.camera.k1 = 0.03;
  int frame = 0;
  const auto move_on = [&] {
    ++frame;
    view.time += 1.0 / 30.0;
    view.belief = Pose2(-1.0, 0.5, 0.005 * frame);
    view.robot_from_camera =
        robot_from_camera(dimensions, {1.1 * std::sin(0.04 * frame), -0.1}, {}, dimensions.torso_height);
  };
  for (int i = 0; i < 1800; ++i) {
    move_on();
    compass->learn(view);
  }
  compass->begin();
  for ([[maybe_unused]] auto _ : state) {
    move_on();
    benchmark::DoNotOptimize(compass->compare(view));
  }
  state.SetLabel(std::string(kCompassMethods[method]));
}
BENCHMARK(Compare)->ArgsProduct({{0, 1, 2, 3, 4, 5, 6, 7}, {160, 320, 640}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace reorient
