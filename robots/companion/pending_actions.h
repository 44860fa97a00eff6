// SPDX-License-Identifier: MIT
// Actions that the client has to begin, at most once each: sent again after each connection until it reports about
// them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robots/application.h"
#include "robots/companion/message.h"

namespace reorient {

class PendingActions {
 public:
  /// `now`: s. Returns one line if the arguments are too long to be sent, else an empty text.
  std::string add(const StartedAction& started, const DeclaredAction& declared, double now);
  /// The client reported about this action.
  void acknowledge(std::uint32_t id);
  /// A new connection: everything is sent again.
  void begin_connection();
  void clear() { waiting_.clear(); }

  /// Calls `send` with each action that was not sent on this connection, until it returns false. Actions whose time is
  /// over are dropped.
  template <typename Send>
  void send(double now, const Send& send) {
    drop_late(now);
    for (Waiting& one : waiting_) {
      if (one.is_sent) continue;
      if (!send(one.message)) return;
      one.is_sent = true;
    }
    drop_unreported();
  }

 private:
  struct Waiting {
    reorient_action message{};
    double until = 0.0;    ///< s; afterwards the engine has given it up
    bool reports = false;  ///< else it is sent once
    bool is_sent = false;
  };
  void drop_late(double now);
  void drop_unreported();

  std::vector<Waiting> waiting_;
};

}  // namespace reorient
