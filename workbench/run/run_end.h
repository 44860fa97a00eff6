// SPDX-License-Identifier: MIT
// How a run ends.
#pragma once

namespace reorient {

enum class RunEnd { verdict, time_up, robot_gone, stopped };

}  // namespace reorient
