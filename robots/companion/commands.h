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
  /// `is_stored_first`: a command waits for set_stored() before it may be sent.
  explicit PendingCommand(std::uint64_t server, bool is_stored_first = false)
      : server_(server), is_stored_first_(is_stored_first) {}

  std::uint64_t server() const { return server_; }
  void grant(Reorientation reorientation);
  /// The client carried out all commands up to this number.
  void acknowledge(std::uint64_t server, std::uint32_t number);
  /// Withdraws the waiting command, because the belief has changed.
  void withdraw() { waiting_.reset(); }

  /// The command to send.
  std::optional<Reorientation> waiting() const { return is_stored_ ? waiting_ : std::nullopt; }
  std::uint32_t number() const { return number_; }

  /// The number of a command whose decision is not stored yet.
  std::optional<std::uint32_t> unstored() const {
    return waiting_ && !is_stored_ ? std::optional(number_) : std::nullopt;
  }
  /// The decision for this command is stored, so that no later process decides it again.
  void set_stored(std::uint32_t number) { is_stored_ |= number == number_; }

 private:
  std::uint64_t server_;
  bool is_stored_first_;
  bool is_stored_ = true;
  std::uint32_t number_ = 0;  // of the last one
  std::optional<Reorientation> waiting_;
};

}  // namespace reorient
