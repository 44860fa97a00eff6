// SPDX-License-Identifier: MIT
#include "robots/nao/lights.h"

#include <algorithm>
#include <cmath>

namespace reorient::nao {

Lights lights_of(const Answer* answer, bool stands) {
  constexpr Lights::Color kGreen{0.0f, 1.0f, 0.0f}, kRed{1.0f, 0.0f, 0.0f}, kDimBlue{0.0f, 0.0f, 0.2f},
      kWhite{0.3f, 0.3f, 0.3f}, kLearning{0.0f, 0.5f, 0.0f};
  Lights lights;
  if (answer == nullptr) return lights;
  std::array<Lights::Color, Lights::kEye> ring;
  ring.fill(kDimBlue);
  if (answer->room.usable) {
    // Convert log-odds to a probability.
    const double reflected = 1.0 / (1.0 + std::exp(std::clamp(-answer->room.evidence, -30.0, 30.0)));
    const auto red = static_cast<std::size_t>(std::lround(reflected * static_cast<double>(ring.size())));
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i < red ? kRed : kGreen;
  }
  lights.left_eye = lights.right_eye = ring;
  lights.chest = answer->training_paused || !stands ? kWhite : kLearning;
  return lights;
}

}  // namespace reorient::nao
