// SPDX-License-Identifier: MIT
// Arbitrary bytes as a camera, its pose, and consecutive images: the observations of the field vision are valid.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "geometry/head.h"
#include "perception/field/field_features.h"
#include "perception/field/ground_projection.h"
#include "tests/fuzz/promises.h"
#include "tests/perception/field/filled_image.h"
#include "tests/perception/field/percept_in.h"
#include "tests/perception/field/sane_percept.h"

namespace reorient {
namespace {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool end() const { return bytes_.empty(); }
  int take() {
    if (bytes_.empty()) return 0;
    const int byte = bytes_[0];
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  /// A number from -1 to 1, or, rarely, any number of 8 bytes.
  double number() {
    const int high = take();
    if (high == 255) {
      std::uint64_t bits = 0;
      for (int i = 0; i < 8; ++i) bits = bits << 8 | static_cast<std::uint64_t>(take());
      double any = 0.0;
      std::memcpy(&any, &bits, sizeof(any));
      return any;
    }
    return (high * 256 + take()) / 32640.0 - 1.0;
  }
  Ycbcr color() {
    const int y = take(), cb = take(), cr = take();
    return {static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(cb), static_cast<std::uint8_t>(cr)};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

constexpr int kLargest = 160;   // pixels
constexpr double kReach = 6.0;  // m, within which shapes are drawn on the ground

CameraModel take_camera(Bytes& bytes) {
  const int width = 2 * (1 + bytes.take() % (kLargest / 2));
  const int height = 1 + bytes.take() % kLargest;
  Lens lens;
  lens.projection = static_cast<CameraProjection>(bytes.take() % enum_count(CameraProjection{}));
  if (lens.projection != CameraProjection::equirectangular) lens.k1 = 0.3 * bytes.number();
  return CameraModel::from_fields_of_view(width, height, 1.1 + bytes.number(), 0.9 + 0.8 * bytes.number(), lens);
}

Isometry3 take_pose(Bytes& bytes) {
  const HeadAngles head{2.0 * bytes.number(), 0.2 + 0.7 * bytes.number()};
  const TorsoAttitude torso{0.3 * bytes.number(), 0.3 * bytes.number()};
  return robot_from_camera({}, head, torso, 0.4 + 0.3 * bytes.number());
}

/// A shape on the ground: a line, a disc, or a ring, at least as wide as the lines of a field.
void draw_on_ground(Image& image, const GroundProjection& projection, Bytes& bytes) {
  const int kind = bytes.take() % 3;
  const Eigen::Vector2d from(kReach * bytes.number(), kReach * bytes.number());
  const Eigen::Vector2d to(kReach * bytes.number(), kReach * bytes.number());
  const double width = 0.06 + 0.05 * bytes.number();
  const Ycbcr color = bytes.color();
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); x += 2) {
      const auto point = projection.ground({x + 0.5, static_cast<double>(y)});
      if (!point) continue;
      const Eigen::Vector2d along = to - from;
      const double share = std::clamp((*point - from).dot(along) / std::max(along.squaredNorm(), 1e-9), 0.0, 1.0);
      const double distance = kind == 0   ? (*point - from - share * along).norm()
                              : kind == 1 ? (*point - from).norm()
                                          : std::abs((*point - from).norm() - 0.75);
      if (distance < width) fill(image, x, y, x + 2, y + 1, color);
    }
  }
}

void draw_noise(Image& image, Bytes& bytes) {
  std::uint32_t state = static_cast<std::uint32_t>(bytes.take()) + 1;
  const int strength = bytes.take();
  for (int y = 0; y < image.height(); ++y) {
    for (int i = 0; i < 2 * image.width(); ++i) {
      state = state * 1664525 + 1013904223;
      const int value = image.row(y)[i] + static_cast<int>(state >> 24) * strength / 255 - strength / 2;
      image.row(y)[i] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
    }
  }
}

void look(FieldFeatures& features, const Image& image, const CameraModel& camera, const Isometry3& pose) {
  const std::string mistake =
      mistake_in(percept_in(features, image.view(), camera, pose), image.width(), image.height());
  require(mistake.empty(), mistake.c_str());
}

void try_images(Bytes bytes) {
  constexpr int kMostLooks = 6;
  const CameraModel camera = take_camera(bytes);
  if (!mistake_in(camera).empty()) return;  // refused by every reader
  FieldFeatures features({}, {});
  Isometry3 pose = take_pose(bytes);
  Image image = filled(camera.width, camera.height, {75, 105, 108});
  int looks = 0;
  while (!bytes.end() && looks < kMostLooks) {
    const auto projection = GroundProjection::look(camera, pose);
    const int column = bytes.take() * image.width() / 255, row = bytes.take() * image.height() / 255;
    switch (bytes.take() % 6) {
      case 0:
        fill(image, column, row, bytes.take() * image.width() / 255, bytes.take() * image.height() / 255,
             bytes.color());
        break;
      case 1:
      case 2:
        if (projection) draw_on_ground(image, *projection, bytes);
        break;
      case 3:
        draw_noise(image, bytes);
        break;
      case 4:
        pose = take_pose(bytes);
        break;
      default:
        look(features, image, camera, pose);
        ++looks;
    }
  }
  look(features, image, camera, pose);
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const reorient::Haste haste(5.0);
  reorient::try_images(reorient::Bytes({data, size}));
  return 0;
}
