// SPDX-License-Identifier: MIT
// Squares of numbers.
#pragma once

namespace reorient {

constexpr double square(double value) { return value * value; }

}  // namespace reorient
