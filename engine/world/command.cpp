#include "engine/world/command.h"

namespace reorient {

std::string_view to_string(Command command) {
  switch (command) {
    case Command::flip_pose:
      return "flip_pose";
    case Command::purge_reflection:
      return "purge_reflection";
    case Command::reset_orientation:
      return "reset_orientation";
    case Command::pause_training:
      return "pause_training";
    case Command::pause_evaluation:
      return "pause_evaluation";
  }
  return "";
}

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
