// SPDX-License-Identifier: MIT
#include "robots/companion/commands.h"

namespace reorient {

void PendingCommand::grant(Reorientation reorientation) {
  const bool keeps_flip = waiting_ == Reorientation::flip_pose && reorientation == Reorientation::purge_reflection;
  if (waiting_ == reorientation || keeps_flip) return;
  waiting_ = reorientation;
  ++number_;
  is_stored_ = !is_stored_first_;
}

void PendingCommand::acknowledge(std::uint64_t server, std::uint32_t number) {
  if (server == server_ && number == number_) waiting_.reset();
}

}  // namespace reorient
