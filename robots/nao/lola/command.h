// SPDX-License-Identifier: MIT
// The command that a NAO receives in one cycle of LoLA.
#pragma once

#include <array>

#include "robots/nao/lola/joints.h"

namespace reorient::nao {

/// Brightness from 0 to 1.
struct Lights {
  struct Color {
    float red = 0.0f, green = 0.0f, blue = 0.0f;
    bool operator==(const Color&) const = default;
  };
  static constexpr std::size_t kEye = 8;  ///< LEDs in a ring
  std::array<Color, kEye> left_eye{};     ///< at 45, 0, 315, 270, 225, 180, 135, 90 degrees
  std::array<Color, kEye> right_eye{};    ///< in ascending order of the angles from 0 degrees
  std::array<float, 10> left_ear{};       ///< at 0, 36, ..., 324 degrees
  std::array<float, 10> right_ear{};      ///< at 324, 288, ..., 0 degrees
  Color chest, left_foot, right_foot;
  std::array<float, 12> skull{};
};

struct Command {
  JointValues position{};   ///< rad; hands: 0 closed, 1 open
  JointValues stiffness{};  ///< 0 to 1; -1: off
  Lights lights;
};

}  // namespace reorient::nao
