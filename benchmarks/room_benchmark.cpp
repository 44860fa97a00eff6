// What one frame of room awareness costs, everything included, with a trained model. One core.
#include <cmath>
#include <cstdint>

#include <benchmark/benchmark.h>

#include "geometry/head.h"
#include "geometry/random.h"
#include "perception/room/room_awareness.h"

namespace reorient {
namespace {

/// Vertical stripes of colour with grain; what stands where does not matter for the time.
Image striped_image(int width, int height) {
  Image image(width, height);
  Random random(3);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = image.row(y);
    for (int x = 0; x < width; x += 2) {
      const int stripe = 24 * x / width;
      row[2 * x] = static_cast<std::uint8_t>(40 + 7 * stripe + static_cast<int>(random.below(9)));
      row[2 * x + 1] = static_cast<std::uint8_t>(100 + 53 * stripe % 56 + static_cast<int>(random.below(5)));
      row[2 * x + 2] = row[2 * x];
      row[2 * x + 3] = static_cast<std::uint8_t>(100 + 31 * stripe % 56 + static_cast<int>(random.below(5)));
    }
  }
  return image;
}

/// Arguments: width, height, whether as in the paper.
void RoomAwarenessUpdate(benchmark::State& state) {
  const auto width = static_cast<int>(state.range(0));
  const auto height = static_cast<int>(state.range(1));
  RoomParameters parameters;
  if (state.range(2) != 0) {  // as in assets/parameters/paper.toml, as far as it costs
    parameters.light.enabled = false;
    parameters.color.blur = 0.05;
    parameters.distance.measure = Distance::ssd3;
  }
  RoomAwareness awareness(parameters, 1);
  const RobotDimensions dimensions;
  const Image image = striped_image(width, height);
  RoomObservation view;
  view.image = image.view();
  view.camera = CameraModel::from_fields_of_view(width, height, from_degrees(56.3), from_degrees(43.7));
  view.camera.k1 = -0.05;
  view.belief = Pose2(-1.0, 0.5, 0.3);
  int frame = 0;
  const auto next = [&] {
    ++frame;
    view.time += 1.0 / 30.0;
    const double yaw = 1.9 * std::sin(0.04 * frame);
    view.robot_from_camera = robot_from_camera(dimensions, {yaw, 0.0}, {}, dimensions.hip_height);
    benchmark::DoNotOptimize(awareness.update(view));
  };
  for (int i = 0; i < 600; ++i) next();
  for ([[maybe_unused]] auto _ : state) next();
  state.counters["visible_tiles"] = awareness.confidences().visible_tiles;
}
BENCHMARK(RoomAwarenessUpdate)
    ->Args({640, 480, 0})
    ->Args({640, 480, 1})
    ->Args({320, 240, 0})
    ->Args({160, 120, 0})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace reorient
