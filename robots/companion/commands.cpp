#include "robots/companion/commands.h"

namespace reorient {

void PendingCommand::grant(Reorientation reorientation) {
  if (waiting_ == reorientation) return;
  waiting_ = reorientation;
  ++number_;
}

void PendingCommand::acknowledge(std::uint64_t server, std::uint32_t number) {
  if (server == server_ && number == number_) waiting_.reset();
}

}  // namespace reorient
