// SPDX-License-Identifier: MIT
// Time of one complete frame of room awareness with a trained model on one core, and the part of it without the
// counting of colors, because only the counting depends on the size of the image.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <vector>

#include <benchmark/benchmark.h>

#include "geometry/head.h"
#include "geometry/random.h"
#include "perception/room/room_awareness.h"

namespace reorient {
namespace {

/// Vertical stripes of color with grain; the positions do not affect the time.
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

/// A camera that turns from side to side.
class Scan {
 public:
  Scan(int width, int height) : image_(striped_image(width, height)) {
    view_.image = image_.view();
    view_.camera = CameraModel::from_fields_of_view(width, height, from_degrees(56.3), from_degrees(43.7));
    view_.camera.k1 = -0.05;
    view_.belief = Pose2(-1.0, 0.5, 0.3);
  }

  const RoomObservation& next() {
    ++frame_;
    view_.time += 1.0 / 30.0;
    const double yaw = 1.9 * std::sin(0.04 * frame_);
    view_.robot_from_camera = robot_from_camera(dimensions_, {yaw, 0.0}, {}, dimensions_.torso_height);
    return view_;
  }

 private:
  RobotDimensions dimensions_;
  Image image_;
  RoomObservation view_;
  int frame_ = 0;
};

/// Trained until the camera has seen all directions.
RoomAwareness trained(const RoomParameters& parameters, Scan& scan) {
  RoomAwareness awareness(parameters, 1);
  for (int i = 0; i < 600; ++i) awareness.update(scan.next());
  return awareness;
}

/// Arguments: width, height, 1 for the paper's method.
void RoomAwarenessUpdate(benchmark::State& state) {
  Scan scan(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  RoomParameters parameters;
  if (state.range(2) != 0) {  // the values of assets/parameters/paper.toml that affect the time
    parameters.light.enabled = false;
    parameters.color.blur = 0.05;
    parameters.distance.measure = Distance::ssd3;
  }
  RoomAwareness awareness = trained(parameters, scan);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(awareness.update(scan.next()));
  state.counters["visible_tiles"] = awareness.confidences().visible_tiles;
}
BENCHMARK(RoomAwarenessUpdate)
    ->Args({640, 480, 0})
    ->Args({640, 480, 1})
    ->Args({320, 240, 0})
    ->Args({160, 120, 0})
    ->Unit(benchmark::kMicrosecond);

/// Processor time of this thread, s.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The frames of a scan in groups: the updates, then only the counting for the same views in the same two lights.
/// Medians over the groups, us for each frame. Arguments: width, height.
void BesideTheCounting(benchmark::State& state) {
  constexpr int kGroup = 16;
  Scan scan(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const RoomParameters parameters;
  RoomAwareness awareness = trained(parameters, scan);
  std::vector<PerceivedTiles> tiles(kGroup);
  std::vector<RoomObservation> views(kGroup);
  std::vector<double> updates, counts, rests;
  for ([[maybe_unused]] auto _ : state) {
    for (RoomObservation& view : views) view = scan.next();
    const double start = processor_time();
    for (const RoomObservation& view : views) benchmark::DoNotOptimize(awareness.update(view));
    const double updated = processor_time();
    for (std::size_t i = 0; i < views.size(); ++i) tiles[i].find(views[i], awareness.wall(), parameters.perception);
    const ColorThresholds believed = color_thresholds(parameters.color, awareness.light());
    ColorThresholds reflected = believed;
    ++reflected.cb_neutral;  // different, as in nearly all frames
    const double found = processor_time();
    for (std::size_t i = 0; i < views.size(); ++i)
      tiles[i].count(views[i].image, believed, reflected, parameters.perception);
    const double counted = processor_time();
    updates.push_back(1e6 * (updated - start) / kGroup);
    counts.push_back(1e6 * (counted - found) / kGroup);
    rests.push_back(updates.back() - counts.back());
  }
  state.counters["update_us"] = median(updates);
  state.counters["counting_us"] = median(counts);
  state.counters["beside_us"] = median(rests);
}
BENCHMARK(BesideTheCounting)->Args({640, 480})->Args({320, 240})->Args({160, 120})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace reorient
