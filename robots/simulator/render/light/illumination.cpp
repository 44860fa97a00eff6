// SPDX-License-Identifier: MIT
#include "robots/simulator/render/light/illumination.h"

#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/wide.h"

namespace reorient {

REORIENT_WIDE void Illumination::gains(std::span<const float> x, std::span<const float> y,
                                       std::span<float> gains) const {
  constexpr float kMiddle = 3.0f;  // m around the field's center, within which daylight fades
  constexpr float kLogOfTwo = 0.693147181f;
  const auto count = static_cast<int>(gains.size());
  const float* __restrict east = x.data();
  const float* __restrict north = y.data();
  float* __restrict gain = gains.data();
  for (int i = 0; i < count; ++i) {
    const float along = daylight.x() * east[i] + daylight.y() * north[i];
    const float square = east[i] * east[i] + north[i] * north[i];
    const float distance2 = square > kMiddle * kMiddle ? square : kMiddle * kMiddle;
    const float toward = along > 0.0f ? along : repeated ? -along : 0.0f;
    gain[i] = kLogOfTwo * daylight_stops * toward * toward / distance2;
  }
  pinned::exp(gains);
  const float height2 = lamp_height * lamp_height;
  for (int i = 0; i < count; ++i) {
    const float beside = toward_dark.x() * east[i] + toward_dark.y() * north[i];
    const float side = repeated ? std::abs(beside) : beside;
    gain[i] *= 1.0f - 0.5f * fraction_off * (1.0f + side / std::sqrt(side * side + height2));
  }
}

float Illumination::gain(float x, float y) const {
  float gain = 1.0f;
  gains({&x, 1}, {&y, 1}, {&gain, 1});
  return gain;
}

}  // namespace reorient
