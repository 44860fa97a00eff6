#include "robots/simulator/render/optics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr int kFarthest = 32;        // pixels that light is blurred to either side
constexpr double kNegligible = 0.1;  // pixels

using ColorPlane = std::vector<float> Frame::*;
constexpr ColorPlane kPlanes[] = {&Frame::red, &Frame::green, &Frame::blue};

/// Half of a normal distribution over pixels, from the middle outwards; all of it sums to 1.
std::vector<float> half_kernel(double sigma) {
  if (sigma < kNegligible) return {};
  const int radius = std::clamp(static_cast<int>(std::ceil(3.0 * sigma)), 1, kFarthest);
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = 0; i <= radius; ++i) {
    weights.push_back(pinned::exp(-0.5 * i * i / (sigma * sigma)));
    sum += (i == 0 ? 1.0 : 2.0) * weights.back();
  }
  std::vector<float> kernel;
  kernel.reserve(weights.size());
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

}  // namespace

Optics::Optics(double blur, double exposure_time, const RayTable& rays)
    : kernel_(half_kernel(blur / rays.pixel_angle)),
      focal_(rays.camera.focal),
      exposure_time_(exposure_time),
      padded_(static_cast<std::size_t>(rays.camera.width) + 2 * kFarthest + 2) {
  const CameraModel& camera = rays.camera;
  if (!kernel_.empty()) {
    lens_.emplace(camera.width, camera.height, false);
    across_.emplace(camera.width, camera.height, false);
  }
  if (exposure_time > 0.0) motion_.emplace(camera.width, camera.height, false);
}

const Frame& Optics::image(const Frame& frame, const Eigen::Vector3d& angular_velocity) {
  const Frame* image = &frame;
  if (lens_) {
    blur_by_lens(*image, *lens_);
    image = &*lens_;
  }
  if (!motion_) return *image;
  // To the left turns the camera, to the right moves the image; u points to the right, v down.
  Eigen::Vector2d motion(focal_.x() * angular_velocity.z() * exposure_time_,
                         -focal_.y() * angular_velocity.y() * exposure_time_);
  const double length = motion.cwiseAbs().maxCoeff();
  if (length < kNegligible) return *image;
  constexpr double kLongest = 2.0 * kFarthest - 2.0;
  if (length > kLongest) motion *= kLongest / length;
  blur_by_motion(*image, motion, *motion_);
  return *motion_;
}

void Optics::pad(const float* row, int width, int margin) {
  float* to = padded_.data();
  std::fill(to, to + margin, row[0]);
  std::copy(row, row + width, to + margin);
  std::fill(to + margin + width, to + 2 * margin + width, row[width - 1]);
}

void Optics::blur_by_lens(const Frame& from, Frame& to) {
  const int radius = static_cast<int>(kernel_.size()) - 1;
  const int width = from.width;
  for (const ColorPlane plane : kPlanes) {
    for (int y = 0; y < from.height; ++y) {
      pad((from.*plane).data() + from.row(y), width, radius);
      float* __restrict out = ((*across_).*plane).data() + from.row(y);
      const float* __restrict middle = padded_.data() + radius;
      for (int i = 0; i < width; ++i) out[i] = kernel_[0] * middle[i];
      for (int k = 1; k <= radius; ++k) {
        const float weight = kernel_[static_cast<std::size_t>(k)];
        for (int i = 0; i < width; ++i) out[i] += weight * (middle[i - k] + middle[i + k]);
      }
    }
    const std::vector<float>& across = (*across_).*plane;
    for (int y = 0; y < from.height; ++y) {
      float* __restrict out = (to.*plane).data() + from.row(y);
      const float* __restrict here = across.data() + from.row(y);
      for (int i = 0; i < width; ++i) out[i] = kernel_[0] * here[i];
      for (int k = 1; k <= radius; ++k) {
        const float weight = kernel_[static_cast<std::size_t>(k)];
        const float* __restrict above = across.data() + from.row(std::max(0, y - k));
        const float* __restrict below = across.data() + from.row(std::min(from.height - 1, y + k));
        for (int i = 0; i < width; ++i) out[i] += weight * (above[i] + below[i]);
      }
    }
  }
}

void Optics::blur_by_motion(const Frame& from, const Eigen::Vector2d& motion, Frame& to) {
  // Places along the way, a pixel apart or less; between pixels, their mean.
  const int taps = static_cast<int>(std::ceil(motion.cwiseAbs().maxCoeff())) + 1;
  const auto share = 1.0f / static_cast<float>(taps);
  const int width = from.width;
  for (const ColorPlane plane : kPlanes) {
    std::vector<float>& out_plane = to.*plane;
    std::fill(out_plane.begin(), out_plane.end(), 0.0f);
    for (int y = 0; y < from.height; ++y) {
      float* __restrict out = out_plane.data() + from.row(y);
      int padded_row = -1;
      for (int tap = 0; tap < taps; ++tap) {
        const double along = taps > 1 ? static_cast<double>(tap) / (taps - 1) - 0.5 : 0.0;
        const double u = along * motion.x();
        const int column = static_cast<int>(std::floor(u));
        const auto right = static_cast<float>(u - column);
        const int row = std::clamp(y + static_cast<int>(std::lround(along * motion.y())), 0, from.height - 1);
        if (row != padded_row) pad((from.*plane).data() + from.row(row), width, kFarthest + 1);
        padded_row = row;
        const float* __restrict in = padded_.data() + kFarthest + 1 + column;
        const float here = share * (1.0f - right);
        const float next = share * right;
        for (int i = 0; i < width; ++i) out[i] += here * in[i] + next * in[i + 1];
      }
    }
  }
}

}  // namespace reorient
