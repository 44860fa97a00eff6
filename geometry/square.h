// SPDX-License-Identifier: MIT
// Numbers times themselves.
#pragma once

namespace reorient {

constexpr double square(double value) { return value * value; }

}  // namespace reorient
