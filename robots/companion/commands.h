// SPDX-License-Identifier: MIT
// Reorientations that somebody else has to carry out, at most once each: numbered, and repeated until they are done.
#pragma once

#include <cstdint>
#include <optional>

#include "robots/answer.h"

namespace reorient {

/// There is one at a time. What is granted while another one waits takes its place, unless it is the same: the belief
/// that it is about has not changed yet, and two flips would be none. A purge does not take a flip's place: behaviours
/// purge what a flip has left over, and without the flip they would purge the pose that is right.
class PendingCommand {
 public:
  /// `server`: drawn by lot, so that no number of an earlier process is taken for one of this.
  explicit PendingCommand(std::uint64_t server) : server_(server) {}

  std::uint64_t server() const { return server_; }
  void grant(Reorientation reorientation);
  /// All up to this number were carried out.
  void acknowledge(std::uint64_t server, std::uint32_t number);
  /// Nobody shall carry it out any more: the belief is another one.
  void withdraw() { waiting_.reset(); }

  std::optional<Reorientation> waiting() const { return waiting_; }
  std::uint32_t number() const { return number_; }

 private:
  std::uint64_t server_;
  std::uint32_t number_ = 0;  // of the last one
  std::optional<Reorientation> waiting_;
};

}  // namespace reorient
