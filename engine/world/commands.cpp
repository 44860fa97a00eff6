// SPDX-License-Identifier: MIT
#include "engine/world/commands.h"

namespace reorient {

std::string_view to_string(Reorientation reorientation) {
  switch (reorientation) {
    case Reorientation::flip_pose:
      return "flip_pose";
    case Reorientation::purge_reflection:
      return "purge_reflection";
    case Reorientation::reset_orientation:
      return "reset_orientation";
  }
  return "";
}

std::string_view to_string(Pause pause) { return pause == Pause::training ? "pause_training" : "pause_evaluation"; }

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::granted:
      return "granted";
    case Verdict::outranked:
      return "outranked";
    case Verdict::too_soon:
      return "too_soon";
    case Verdict::not_allowed:
      return "not_allowed";
  }
  return "";
}

}  // namespace reorient
