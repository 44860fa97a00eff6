// SPDX-License-Identifier: MIT
#include "robots/nao/lola/joints.h"

#include <algorithm>
#include <cmath>

namespace reorient::nao {

PitchRange head_pitch_range(float yaw) {
  struct Row {
    float yaw;
    PitchRange pitch;
  };
  static constexpr std::array<Row, 7> kRows{{{0.0f, {-0.672f, 0.515f}},
                                             {0.486f, {-0.672f, 0.422f}},
                                             {0.756f, {-0.548f, 0.370f}},
                                             {0.903f, {-0.480f, 0.330f}},
                                             {1.090f, {-0.430f, 0.300f}},
                                             {1.527f, {-0.330f, 0.200f}},
                                             {2.086f, {-0.449f, 0.330f}}}};
  const float turned = std::fabs(yaw);
  for (std::size_t i = 1; i < kRows.size(); ++i) {
    const Row &from = kRows[i - 1], &to = kRows[i];
    if (turned > to.yaw) continue;
    const float share = (turned - from.yaw) / (to.yaw - from.yaw);
    return {std::lerp(from.pitch.least, to.pitch.least, share), std::lerp(from.pitch.most, to.pitch.most, share)};
  }
  return kRows.back().pitch;
}

}  // namespace reorient::nao
