// SPDX-License-Identifier: MIT
#include "robots/footage/camera_info.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include "robots/footage/messages/bad_message.h"

namespace reorient {
namespace {

/// Sets the lens from the name of its distortion model and its coefficients.
void set_distortion(const messages::CameraInfo& info, CameraModel& camera) {
  const std::vector<double>& d = info.d;
  const std::string& model = info.distortion_model;
  const bool is_fisheye = model == "equidistant" || model == "fisheye" || model == "kannala_brandt4";
  const bool is_zero = std::all_of(d.begin(), d.end(), [](double each) { return each == 0.0; });
  if (!is_fisheye && is_zero) return;
  if (!is_fisheye && model != "plumb_bob" && model != "rational_polynomial") {
    throw BadFootage(
        "distortion model: expected plumb_bob, rational_polynomial or equidistant, or coefficients that are 0, found " +
        messages::in_quotes(model));
  }
  if (is_fisheye) camera.projection = CameraProjection::fisheye;
  // Some drivers write more zeros than the model has coefficients.
  std::size_t count = d.size();
  const std::size_t most = is_fisheye ? 4 : 8;
  while (count > most && d[count - 1] == 0.0) --count;
  if (const std::string mistake = camera.set_coefficients(std::span(d).first(count)); !mistake.empty())
    throw BadFootage("distortion model " + messages::in_quotes(model) + ": " + mistake);
}

std::string number_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", number);
  return text.data();
}

std::string size_text(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

CameraModel camera_at(const CameraModel& camera, int width, int height) {
  if (camera.width == width && camera.height == height) return camera;
  if (camera.width == width + 1 && camera.width % 2 == 1 && camera.height == height) {
    CameraModel cropped = camera;
    cropped.width = width;
    return cropped;
  }
  const std::int64_t difference = std::int64_t{camera.width} * height - std::int64_t{camera.height} * width;
  if (width <= 0 || height <= 0 || std::abs(difference) > std::max({camera.width, camera.height, width, height})) {
    throw BadFootage("camera calibration: expected the aspect ratio of the image, " + size_text(width, height) +
                     ", found " + size_text(camera.width, camera.height));
  }
  return camera.scaled_to(width, height);
}

CameraModel camera_of(const messages::CameraInfo& info, int width, int height, bool rectified) {
  constexpr std::uint32_t kLargest = 65536;
  const auto& region = info.region;
  const bool has_region = region.width > 0 && region.height > 0;
  for (const std::uint32_t size : {info.width, info.height, region.width, region.height}) {
    if (size > kLargest)
      throw BadFootage("camera calibration: expected at most 65536 pixels, found " + std::to_string(size));
  }
  if (info.width == 0 || info.height == 0)
    throw BadFootage("camera calibration: expected a width and a height, found " + size_text(info.width, info.height));
  CameraModel camera;
  camera.width = static_cast<int>(has_region ? region.width : info.width);
  camera.height = static_cast<int>(has_region ? region.height : info.height);
  if (rectified && info.p[0] != 0.0) {
    camera.focal = {info.p[0], info.p[5]};
    camera.center = {info.p[2], info.p[6]};
  } else {
    camera.focal = {info.k[0], info.k[4]};
    camera.center = {info.k[2], info.k[5]};
  }
  constexpr double kLargestLength = 1e6;  // pixels
  const bool is_finite = camera.focal.allFinite() && camera.center.allFinite();
  if (!is_finite || camera.focal.minCoeff() <= 0.0 || camera.focal.maxCoeff() > kLargestLength ||
      camera.center.cwiseAbs().maxCoeff() > kLargestLength) {
    throw BadFootage("camera calibration: expected positive focal lengths and a center, found focal lengths " +
                     number_text(camera.focal.x()) + " and " + number_text(camera.focal.y()) + ", center " +
                     number_text(camera.center.x()) + " and " + number_text(camera.center.y()));
  }
  if (!rectified) set_distortion(info, camera);
  if (has_region) camera.center -= Eigen::Vector2d(region.x_offset, region.y_offset);
  CameraModel result = camera_at(camera, width, height);
  if (const std::string mistake = mistake_in(result); !mistake.empty())
    throw BadFootage("camera calibration: " + mistake);
  return result;
}

}  // namespace reorient
