// SPDX-License-Identifier: MIT
// A room from a panorama: each point of wall, ceiling and floor has the light that the panorama shows in its direction
// from the viewpoint. The projection is exact if the panorama was taken in a room of this shape, else plausible.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "geometry/transform.h"
#include "robots/simulator/room/panorama.h"
#include "robots/simulator/room/room.h"
#include "robots/simulator/room/room_images.h"

namespace reorient {
namespace {

constexpr double kTexelsPerMeter = 50.0;
constexpr double kLevelTexelsPerMeter = 32.0;
constexpr int kWidest = 4096;        // pixels; wider panoramas are averaged down first
constexpr float kBrightest = 12.0f;  // relative to the brightness of the surroundings

LinearImage halve(const LinearImage& fine) {
  LinearImage coarse(fine.width / 2, fine.height / 2);
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      // Scale each summand, because the sum of the four largest floats is infinite.
      coarse.at(x, y) = 0.25f * fine.at(2 * x, 2 * y) + 0.25f * fine.at(2 * x + 1, 2 * y) +
                        0.25f * fine.at(2 * x, 2 * y + 1) + 0.25f * fine.at(2 * x + 1, 2 * y + 1);
    }
  }
  return coarse;
}

float brightness(const LinearColor& color) { return 0.299f * color.x() + 0.587f * color.y() + 0.114f * color.z(); }

/// Scales the panorama so that the surroundings of the field have the brightness of an ordinary wall, and limits lamps
/// to the range of textures. The geometric mean prevents that windows and lamps dominate.
void normalize(LinearImage& panorama) {
  constexpr double kOrdinary = 0.16;
  const int top = panorama.height * 30 / 100;     // elevations from 36 degrees up
  const int bottom = panorama.height * 58 / 100;  // to 14 degrees down
  double sum = 0.0;
  int count = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = 0; x < panorama.width; ++x, ++count)
      sum += pinned::log(std::max(1e-5f, brightness(panorama.at(x, y))));
  }
  const auto scale = static_cast<float>(kOrdinary / pinned::exp(sum / count));
  for (LinearColor& color : panorama.pixels) color = (scale * color).max(0.0f).min(kBrightest);
}

/// The light that white paper on the field reflects: the mean light from above, weighted by the cosine, with the
/// brightness of a dim hall. It is moved half way to gray, because the camera's white balance compensates for the rest.
LinearColor light_of(const LinearImage& panorama) {
  LinearColor sum = LinearColor::Constant(1e-6f);
  for (int y = 0; y < panorama.height / 2; ++y) {
    const double elevation = kPi * (0.5 - (y + 0.5) / panorama.height);
    const auto weight = static_cast<float>(pinned::sin(elevation) * pinned::cos(elevation));
    for (int x = 0; x < panorama.width; ++x) sum += weight * panorama.at(x, y);
  }
  constexpr float kDim = 0.55f;
  return kDim * (0.5f + 0.5f * sum / brightness(sum));
}

/// Looks up the light in directions from the viewpoint.
class Viewpoint {
 public:
  Viewpoint(const LinearImage& panorama, const RoomShape& shape) : panorama_(panorama), shape_(shape) {}

  LinearColor toward(const Eigen::Vector3d& point) const {
    const double azimuth = direction_of(point.head<2>()) - shape_.turn;
    const double elevation = pinned::atan2(point.z() - shape_.viewpoint_height, point.head<2>().norm());
    const double u = (0.5 - azimuth / (2.0 * kPi)) * panorama_.width - 0.5;
    const double v = (0.5 - elevation / kPi) * panorama_.height - 0.5;
    const double left = std::floor(u);
    const double above = std::floor(v);
    const auto a = static_cast<float>(u - left);
    const auto b = static_cast<float>(v - above);
    const int x = static_cast<int>(left);
    const int y = static_cast<int>(above);
    return (1.0f - b) * ((1.0f - a) * pixel(x, y) + a * pixel(x + 1, y)) +
           b * ((1.0f - a) * pixel(x, y + 1) + a * pixel(x + 1, y + 1));
  }

 private:
  const LinearColor& pixel(int x, int y) const {
    const int column = ((x % panorama_.width) + panorama_.width) % panorama_.width;
    return panorama_.at(column, std::clamp(y, 0, panorama_.height - 1));
  }

  const LinearImage& panorama_;
  const RoomShape& shape_;
};

LinearImage bake_walls(const Viewpoint& viewpoint, const RoomShape& shape) {
  const double perimeter = wall_perimeter(shape);
  LinearImage image(texels_for(perimeter, kTexelsPerMeter), texels_for(shape.height, kTexelsPerMeter));
  for (int i = 0; i < image.width; ++i) {
    const Eigen::Vector2d ground = wall_point(shape, (i + 0.5) * perimeter / image.width);
    for (int j = 0; j < image.height; ++j) {
      image.at(i, j) = viewpoint.toward({ground.x(), ground.y(), (j + 0.5) * shape.height / image.height});
    }
  }
  return image;
}

LinearImage bake_level(const Viewpoint& viewpoint, const RoomShape& shape, double height) {
  const Eigen::Vector2d extent = floor_extent(shape);
  LinearImage image(texels_for(extent.x(), kLevelTexelsPerMeter), texels_for(extent.y(), kLevelTexelsPerMeter));
  for (int j = 0; j < image.height; ++j) {
    const double y = ((j + 0.5) / image.height - 0.5) * extent.y();
    for (int i = 0; i < image.width; ++i) {
      image.at(i, j) = viewpoint.toward({((i + 0.5) / image.width - 0.5) * extent.x(), y, height});
    }
  }
  return image;
}

/// Only the built-in hall has the banner. Reject a mark for a panorama, instead of ignoring it.
void check_panorama_shape(const std::string& name, const RoomShape& shape) {
  check(shape);
  if (shape.mark == 0.0) return;
  std::ostringstream message;
  message << "panorama '" << name << "': room_shape.mark: expected 0, found " << shape.mark
          << " m; only the built-in hall has a banner";
  throw std::runtime_error(message.str());
}

}  // namespace

Room load_room(const std::string& path, const RoomShape& shape) {
  check_panorama_shape(path, shape);  // before a large file is read without effect
  return room_from(read_panorama(path), path, shape);
}

Room room_from(LinearImage panorama, const std::string& name, const RoomShape& shape) {
  check_panorama_shape(name, shape);
  while (panorama.width > kWidest) panorama = halve(panorama);
  normalize(panorama);
  const Viewpoint viewpoint(panorama, shape);
  RoomImages images{bake_walls(viewpoint, shape), bake_level(viewpoint, shape, shape.height),
                    bake_level(viewpoint, shape, 0.0)};
  make_symmetric(images, shape);
  return room_of(std::move(images), name, shape, light_of(panorama));
}

}  // namespace reorient
