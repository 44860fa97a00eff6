// SPDX-License-Identifier: MIT
#include "robots/simulator/render/optics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "geometry/pinned_math.h"
#include "geometry/wide.h"

namespace reorient {
namespace {

constexpr int kFarthest = 32;        // pixels, largest blur to either side
constexpr double kNegligible = 0.1;  // pixels

using ColorPlane = std::vector<float> Frame::*;
constexpr ColorPlane kPlanes[] = {&Frame::red, &Frame::green, &Frame::blue};

using Lanes = float __attribute__((vector_size(sizeof(float) * kLanes)));

[[gnu::always_inline]] inline void load(const float* from, Lanes& lanes) { std::memcpy(&lanes, from, sizeof lanes); }
[[gnu::always_inline]] inline void store(const Lanes& lanes, float* to) { std::memcpy(to, &lanes, sizeof lanes); }

/// Computes a sum of `terms` terms for each pixel of a row of at least kLanes pixels. `add`(term, pixel, sum) adds one
/// term to the sums of kLanes pixels. The sums stay in registers.
template <typename Add>
[[gnu::always_inline]] inline void sum_up(int width, int terms, const Add& add, float* out) {
  constexpr int kTogether = 4;
  int begin = 0;
  for (; begin + kTogether * kLanes <= width; begin += kTogether * kLanes) {
    Lanes a{}, b{}, c{}, d{};
    for (int term = 0; term < terms; ++term) {
      add(term, begin, a);
      add(term, begin + kLanes, b);
      add(term, begin + 2 * kLanes, c);
      add(term, begin + 3 * kLanes, d);
    }
    store(a, out + begin);
    store(b, out + begin + kLanes);
    store(c, out + begin + 2 * kLanes);
    store(d, out + begin + 3 * kLanes);
  }
  for (; begin < width; begin += kLanes) {
    const int start = std::min(begin, width - kLanes);  // some pixels twice
    Lanes sum{};
    for (int term = 0; term < terms; ++term) add(term, start, sum);
    store(sum, out + start);
  }
}

/// Extends a row by `margin` pixels at both ends.
void pad(const float* row, int width, int margin, float* to) {
  std::fill(to, to + margin, row[0]);
  std::copy(row, row + width, to + margin);
  std::fill(to + margin + width, to + 2 * margin + width, row[width - 1]);
}

/// Half of a normal distribution over pixels, from the center outwards; the whole distribution sums to 1.
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
      padded_(static_cast<std::size_t>(rays.camera.width + 2 * (kFarthest + 1)) *
              static_cast<std::size_t>(exposure_time > 0.0 ? rays.camera.height : 1)) {
  const CameraModel& camera = rays.camera;
  if (!kernel_.empty()) {
    lens_.emplace(camera.width, camera.height, false);
    across_.emplace(camera.width, camera.height, false);
  }
  if (exposure_time > 0.0) {
    motion_.emplace(camera.width, camera.height, false);
    taps_.reserve(2 * kFarthest);
  }
}

const Frame& Optics::image(const Frame& frame, const Eigen::Vector3d& angular_velocity) {
  const Frame* image = &frame;
  if (lens_) {
    blur_by_lens(*image, *lens_);
    image = &*lens_;
  }
  if (!motion_) return *image;
  // If the camera turns to the left, the image moves to the right. u points to the right, v down.
  Eigen::Vector2d motion(focal_.x() * angular_velocity.z() * exposure_time_,
                         -focal_.y() * angular_velocity.y() * exposure_time_);
  const double length = motion.cwiseAbs().maxCoeff();
  if (length < kNegligible) return *image;
  constexpr double kLongest = 2.0 * kFarthest - 2.0;
  if (length > kLongest) motion *= kLongest / length;
  blur_by_motion(*image, motion, *motion_);
  return *motion_;
}

REORIENT_WIDE void Optics::blur_by_lens(const Frame& from, Frame& to) {
  const auto terms = static_cast<int>(kernel_.size());
  const int width = from.width;
  const float* const kernel = kernel_.data();
  const auto weigh = [&](int term, const float* before, const float* after, Lanes& sum) __attribute__((always_inline)) {
    Lanes one, other;
    load(before, one);
    if (term > 0) {
      load(after, other);
      one += other;
    }
    sum += kernel[term] * one;
  };
  for (const ColorPlane plane : kPlanes) {
    for (int y = 0; y < from.height; ++y) {
      pad((from.*plane).data() + from.row(y), width, terms - 1, padded_.data());
      const float* const middle = padded_.data() + terms - 1;
      const auto add = [&](int term, int i, Lanes& sum) __attribute__((always_inline)) {
        weigh(term, middle + i - term, middle + i + term, sum);
      };
      sum_up(width, terms, add, ((*across_).*plane).data() + from.row(y));
    }
    const float* const across = ((*across_).*plane).data();
    for (int y = 0; y < from.height; ++y) {
      const auto add = [&](int term, int i, Lanes& sum) __attribute__((always_inline)) {
        weigh(term, across + from.row(std::max(0, y - term)) + i,
              across + from.row(std::min(from.height - 1, y + term)) + i, sum);
      };
      sum_up(width, terms, add, (to.*plane).data() + from.row(y));
    }
  }
}

REORIENT_WIDE void Optics::blur_by_motion(const Frame& from, const Eigen::Vector2d& motion, Frame& to) {
  // Points along the path, at most a pixel apart; between pixels, their weighted mean.
  const int taps = static_cast<int>(std::ceil(motion.cwiseAbs().maxCoeff())) + 1;
  const auto fraction = 1.0f / static_cast<float>(taps);
  taps_.clear();
  for (int tap = 0; tap < taps; ++tap) {
    const double along = taps > 1 ? static_cast<double>(tap) / (taps - 1) - 0.5 : 0.0;
    const double u = along * motion.x();
    const int column = static_cast<int>(std::floor(u));
    const auto right = static_cast<float>(u - column);
    taps_.push_back(
        {column, static_cast<int>(std::lround(along * motion.y())), fraction * (1.0f - right), fraction * right});
  }
  constexpr int kMargin = kFarthest + 1;
  const std::size_t stride = static_cast<std::size_t>(from.width) + 2 * kMargin;
  for (const ColorPlane plane : kPlanes) {
    for (int y = 0; y < from.height; ++y)
      pad((from.*plane).data() + from.row(y), from.width, kMargin,
          padded_.data() + stride * static_cast<std::size_t>(y));
    for (int y = 0; y < from.height; ++y) {
      const auto add = [&](int term, int i, Lanes& sum) __attribute__((always_inline)) {
        const Tap& tap = taps_[static_cast<std::size_t>(term)];
        const int row = std::clamp(y + tap.row, 0, from.height - 1);
        const float* const in = padded_.data() + stride * static_cast<std::size_t>(row) + kMargin + tap.column + i;
        Lanes here, next;
        load(in, here);
        load(in + 1, next);
        sum += tap.here * here + tap.next * next;
      };
      sum_up(from.width, taps, add, (to.*plane).data() + from.row(y));
    }
  }
}

}  // namespace reorient
