// SPDX-License-Identifier: MIT
#include "robots/simulator/render/sensor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "geometry/pinned_math.h"
#include "geometry/random.h"
#include "geometry/wide.h"

namespace reorient {
namespace {

constexpr std::size_t kNoise = 16384;  // values in the noise table; rows start at scattered offsets
constexpr float kShoulder = 1.6f;      // softness of the tone curve near white
constexpr float kWhite = 255.0f;
constexpr std::size_t kRing = 3;

std::vector<float> make_vignette(const RayTable& rays, double loss) {
  std::vector<float> vignette(rays.length.size());
  if (!rays.is_perspective()) {  // the tangent ends at 90 degrees; 1 - cosine also grows with the square of the angle
    const float least = *std::min_element(rays.forward.begin(), rays.forward.end());
    for (std::size_t i = 0; i < vignette.size(); ++i) {
      const float fraction = (1.0f - rays.forward[i]) / std::max(1e-6f, 1.0f - least);
      vignette[i] = 1.0f - static_cast<float>(loss) * fraction * (1.4f - 0.4f * fraction);
    }
    return vignette;
  }
  float greatest = 1.0f;
  for (const float length : rays.length) greatest = std::max(greatest, length);
  const float corner = std::max(1e-6f, greatest * greatest - 1.0f);
  for (std::size_t i = 0; i < vignette.size(); ++i) {
    const float fraction =
        (rays.length[i] * rays.length[i] - 1.0f) / corner;  // squared distance from the axis, 1 at the corners
    vignette[i] = 1.0f - static_cast<float>(loss) * fraction * (1.4f - 0.4f * fraction);
  }
  return vignette;
}

std::vector<float> make_noise(std::uint64_t seed) {
  constexpr std::uint64_t kStream = 0x5e4504;
  Random random(seed, kStream);
  std::vector<float> noise(kNoise);
  for (float& value : noise) value = static_cast<float>(std::clamp(random.normal(), -4.0, 4.0));
  return noise;
}

inline float tone(float light) { return std::sqrt(light * (1.0f + kShoulder) / (light + kShoulder)); }

inline float limited(float value) {
  const float positive = value > 0.0f ? value : 0.0f;
  return positive < kWhite ? positive : kWhite;
}

}  // namespace

Sensor::Sensor(const SensorParameters& parameters, const RayTable& rays, std::uint64_t seed)
    : parameters_(parameters),
      exposure_(parameters.exposure),
      seed_(seed),
      vignette_(make_vignette(rays, parameters.vignetting)),
      noise_(make_noise(seed)),
      ring_(kRing, Channels(static_cast<std::size_t>(rays.camera.width))),
      mixed_(static_cast<std::size_t>(rays.camera.width)),
      optics_(parameters.blur_angle, parameters.exposure_time, rays),
      luma_(static_cast<std::size_t>(rays.camera.width)),
      blue_(static_cast<std::size_t>(rays.camera.width)),
      red_(static_cast<std::size_t>(rays.camera.width)),
      levels_(static_cast<std::size_t>(rays.camera.width)),
      pairs_(static_cast<std::size_t>(rays.camera.width) / 2) {}

REORIENT_WIDE void Sensor::expose(const Frame& scene, std::uint64_t number, double time_step, Image& image,
                                  const Eigen::Vector3d& angular_velocity) {
  if (parameters_.automatic_exposure) adapt(scene, time_step);
  const Frame& frame = optics_.image(scene, angular_velocity);
  const Amplifier amplified = amplifier();
  const auto width = static_cast<std::size_t>(frame.width);
  blur_row(frame, 0, ring_[0]);
  const auto side = static_cast<float>(parameters_.blur);
  const float middle = 1.0f - 2.0f * side;
  for (int row = 0; row < frame.height; ++row) {
    if (row + 1 < frame.height) blur_row(frame, row + 1, ring_[static_cast<std::size_t>(row + 1) % kRing]);
    const Channels& above = ring_[static_cast<std::size_t>(std::max(0, row - 1)) % kRing];
    const Channels& here = ring_[static_cast<std::size_t>(row) % kRing];
    const Channels& below = ring_[static_cast<std::size_t>(std::min(row + 1, frame.height - 1)) % kRing];
#pragma GCC ivdep
    for (std::size_t i = 0; i < width; ++i) {
      mixed_.red[i] = middle * here.red[i] + side * (above.red[i] + below.red[i]);
      mixed_.green[i] = middle * here.green[i] + side * (above.green[i] + below.green[i]);
      mixed_.blue[i] = middle * here.blue[i] + side * (above.blue[i] + below.blue[i]);
    }
    develop(mixed_, amplified, vignette_.data() + frame.row(row), frame.width);
    write_row(number, row, amplified, image.row(row));
  }
}

void Sensor::adapt(const Frame& frame, double time_step) {
  // Every fourth row and column is enough to measure the light. The brightness of a lamp is limited to white.
  double sum = 0.0;
  int count = 0;
  constexpr int kStep = 4;
  for (int row = kStep / 2; row < frame.height; row += kStep) {
    for (int i = kStep / 2; i < frame.width; i += kStep) {
      const std::size_t pixel = frame.row(row) + static_cast<std::size_t>(i);
      sum += std::min(1.0f, 0.299f * frame.red[pixel] + 0.587f * frame.green[pixel] + 0.114f * frame.blue[pixel]);
      ++count;
    }
  }
  const double mean = std::max(1e-4, sum / std::max(1, count));
  constexpr double kRange = 4.0;  // largest factor of the sensor's gain, up and down
  const double target =
      std::clamp(parameters_.brightness / mean, parameters_.exposure / kRange, parameters_.exposure * kRange);
  const double fraction = adapted_ ? 1.0 - pinned::exp(-time_step / parameters_.adaptation_time) : 1.0;
  adapted_ = true;
  exposure_ *= pinned::pow(target / exposure_, fraction);
}

REORIENT_WIDE void Sensor::blur_row(const Frame& frame, int row, Channels& blurred) const {
  const auto side = static_cast<float>(parameters_.blur);
  const float middle = 1.0f - 2.0f * side;
  const std::size_t first = frame.row(row);
  const int last = frame.width - 1;
  const auto pass = [&](const float* __restrict from, float* __restrict to) __attribute__((always_inline)) {
    to[0] = (middle + side) * from[0] + side * from[1];
    for (int i = 1; i < last; ++i) to[i] = middle * from[i] + side * (from[i - 1] + from[i + 1]);
    to[last] = (middle + side) * from[last] + side * from[last - 1];
  };
  pass(frame.red.data() + first, blurred.red.data());
  pass(frame.green.data() + first, blurred.green.data());
  pass(frame.blue.data() + first, blurred.blue.data());
}

Sensor::Amplifier Sensor::amplifier() const {
  const double gain = exposure_ * pinned::exp2(stops_);
  // A gain of 1 is that of the exposure at the start; a smaller gain adds no noise.
  const double amplified = std::max(1.0, exposure_ / parameters_.exposure);
  const double noise = parameters_.noise_gain > 0.0 ? pinned::pow(amplified, parameters_.noise_gain) : 1.0;
  return {static_cast<float>(gain * pinned::exp(parameters_.warmth) * gains_.x()),
          static_cast<float>(gain * pinned::exp(parameters_.tint) * gains_.y()),
          static_cast<float>(gain * pinned::exp(-parameters_.warmth) * gains_.z()),
          static_cast<float>(parameters_.luma_noise * noise), static_cast<float>(parameters_.chroma_noise * noise)};
}

REORIENT_WIDE void Sensor::develop(const Channels& light, const Amplifier& amplifier, const float* __restrict vignette,
                                   int width) {
  const float gain_red = amplifier.red;
  const float gain_green = amplifier.green;
  const float gain_blue = amplifier.blue;
  const auto veil = static_cast<float>(parameters_.black_level);
  const auto saturation = static_cast<float>(parameters_.saturation);
  const float* __restrict in_red = light.red.data();
  const float* __restrict in_green = light.green.data();
  const float* __restrict in_blue = light.blue.data();
  float* __restrict luma = luma_.data();
  float* __restrict cb = blue_.data();
  float* __restrict cr = red_.data();
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    const float red = kWhite * tone(gain_red * vignette[i] * in_red[i] + veil);
    const float green = kWhite * tone(gain_green * vignette[i] * in_green[i] + veil);
    const float blue = kWhite * tone(gain_blue * vignette[i] * in_blue[i] + veil);
    const float clipped_red = red < kWhite ? red : kWhite;
    const float clipped_green = green < kWhite ? green : kWhite;
    const float clipped_blue = blue < kWhite ? blue : kWhite;
    const float y = 0.299f * clipped_red + 0.587f * clipped_green + 0.114f * clipped_blue;
    luma[i] = y;
    cb[i] = 128.0f + saturation * 0.564f * (clipped_blue - y);
    cr[i] = 128.0f + saturation * 0.713f * (clipped_red - y);
  }
}

REORIENT_WIDE void Sensor::write_row(std::uint64_t number, int row, const Amplifier& amplifier,
                                     std::uint8_t* __restrict bytes) {
  const std::size_t width = luma_.size();
  const std::uint64_t offset =
      scatter(seed_ + number * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(row) * 0xD1B54A32D192ED03ull);
  const std::size_t range = kNoise - width;
  const float* __restrict luma_noise = noise_.data() + offset % range;
  const float* __restrict cb_noise = noise_.data() + (offset >> 20) % range;
  const float* __restrict cr_noise = noise_.data() + (offset >> 40) % range;
  const float* __restrict luma = luma_.data();
  const float* __restrict cb = blue_.data();
  const float* __restrict cr = red_.data();
  const float luma_sigma = amplifier.luma_sigma;
  const float chroma_sigma = amplifier.chroma_sigma;
  constexpr float kRounding = 0.5f;
  int* __restrict level = levels_.data();
  for (std::size_t i = 0; i < width; ++i) {
    level[i] = static_cast<int>(limited(luma[i] + luma_sigma * luma_noise[i] + kRounding));
  }
  // Two pixels are four bytes: Y, Cb, Y, Cr.
  static_assert(std::endian::native == std::endian::little, "the first byte is the lowest one");
  std::uint32_t* __restrict pairs = pairs_.data();
  for (std::size_t i = 0; i < width / 2; ++i) {
    const float b = 0.5f * (cb[2 * i] + cb[2 * i + 1]) + chroma_sigma * cb_noise[i] + kRounding;
    const float r = 0.5f * (cr[2 * i] + cr[2 * i + 1]) + chroma_sigma * cr_noise[i] + kRounding;
    const int pair = level[2 * i] | static_cast<int>(limited(b)) << 8 | level[2 * i + 1] << 16;
    pairs[i] = static_cast<std::uint32_t>(pair) | static_cast<std::uint32_t>(static_cast<int>(limited(r))) << 24;
  }
  std::memcpy(bytes, pairs, 2 * width);
}

}  // namespace reorient
