// SPDX-License-Identifier: MIT
// Reorientations that the client has to carry out, at most once each: numbered, and repeated until they are done.
#pragma once

#include <cstdint>
#include <optional>

#include "robots/answer.h"

namespace reorient {

/// One command waits at a time. A newer command replaces it, unless it is the same: the belief has not changed yet, and
/// two flips would cancel out. A purge does not replace a flip: behaviors purge what a flip leaves, and without the
/// flip they would purge the correct pose.
class PendingCommand {
 public:
  /// `server`: random, so that numbers of an earlier process are not taken for those of this process.
  explicit PendingCommand(std::uint64_t server) : server_(server) {}

  std::uint64_t server() const { return server_; }
  void grant(Reorientation reorientation);
  /// The client carried out all commands up to this number.
  void acknowledge(std::uint64_t server, std::uint32_t number);
  /// Withdraws the waiting command, because the belief has changed.
  void withdraw() { waiting_.reset(); }

  std::optional<Reorientation> waiting() const { return waiting_; }
  std::uint32_t number() const { return number_; }

 private:
  std::uint64_t server_;
  std::uint32_t number_ = 0;  // of the last one
  std::optional<Reorientation> waiting_;
};

}  // namespace reorient
