// SPDX-License-Identifier: MIT
// Arbitrary bytes as a saved model of a room: refused with one line, or read as a model that is written with the same
// bytes, can be rotated, compared and merged, and can be used by a robot.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "geometry/bytes.h"
#include "geometry/head.h"
#include "perception/room/model_comparison.h"
#include "perception/room/room_awareness.h"
#include "tests/fuzz/promises.h"

namespace reorient {
namespace {

std::vector<std::byte> written(const SavedModel& model) {
  std::vector<std::byte> bytes;
  write_model(model, bytes);
  return bytes;
}

void try_with_another(const SavedModel& model) {
  SavedModel turned = model;
  turned.rotate_by_180_degrees();
  for (const ModelComparison& comparison : {compare(model, model), compare(model, turned)}) {
    for (const TileDifference& tile : comparison.tiles)
      require(tile.distance >= 0.0 && tile.distance <= 1.0, "a distance is between 0 and 1");
  }
  require(!compare(model, model).is_turned(), "a model is not rotated against itself");
  const SavedModel both = merged(model, turned);
  require(written(both) == written(merged(turned, model)), "the order of two models does not matter");
  require(written(read_model(written(both))) == written(both), "two merged models are a valid model");
  turned.rotate_by_180_degrees();
  require(written(turned) == written(model), "two rotations by 180 degrees change nothing");
}

void try_in_a_robot(const SavedModel& model) {
  RoomParameters parameters;
  parameters.wall = model.basis.wall;
  parameters.color = model.basis.color;
  parameters.light.enabled = model.basis.light_adaptation;
  parameters.pose_light.enabled = model.basis.pose_light;
  RoomAwareness room(parameters, 1);
  room.take_model(model);
  Image image(80, 60);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < 2 * image.width(); ++x) image.row(y)[x] = static_cast<std::uint8_t>(31 * x + 7 * y);
  }
  RoomObservation view;
  view.image = image.view();
  view.camera = CameraModel().scaled_to(image.width(), image.height());
  for (int frame = 0; frame < 3; ++frame) {
    view.time = 0.1 * frame;
    view.robot_from_camera =
        robot_from_camera(RobotDimensions(), {0.5 * frame, 0.0}, {}, RobotDimensions().torso_height);
    const Confidences& confidences = room.update(view);
    for (const double value : {confidences.evidence, confidences.current, confidences.opposite, confidences.coverage,
                               confidences.distinctiveness, room.light().luma, room.light().cb})
      require(std::isfinite(value), "the results with a model are finite");
  }
  require(written({room.basis(), model.learned, room.model()}).size() == written(model).size(),
          "evaluation does not change the model");
}

void try_model(std::span<const std::byte> bytes) {
  const Haste haste(5.0);
  SavedModel model;
  try {
    model = read_model(bytes);
  } catch (const BadBytes& refused) {
    require_message(refused.what());
    return;
  }
  require(std::ranges::equal(written(model), bytes), "a model is written with the bytes that were read");
  try_with_another(model);
  try_in_a_robot(model);
}

/// Corrects the length of the content and the checksum, because mutations would never match them.
void correct_length_and_checksum(std::span<std::uint8_t> bytes) {
  constexpr std::size_t kSizeAt = 12, kHead = 16, kSum = 8;
  if (bytes.size() < kHead + kSum) return;
  const auto size = static_cast<std::uint32_t>(bytes.size() - kHead - kSum);
  std::memcpy(bytes.data() + kSizeAt, &size, sizeof(size));
  std::uint64_t sum = 0xCBF29CE484222325ull;
  for (const std::uint8_t byte : bytes.first(bytes.size() - kSum)) sum = (sum ^ byte) * 0x100000001B3ull;
  std::memcpy(bytes.data() + bytes.size() - kSum, &sum, kSum);
}

}  // namespace
}  // namespace reorient

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t longest);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t longest,
                                               unsigned int seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, longest);
  if (seed % 16 != 0) reorient::correct_length_and_checksum({data, mutated});
  return mutated;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_model(std::as_bytes(std::span(data, size)));
  return 0;
}
