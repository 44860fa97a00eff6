// SPDX-License-Identifier: MIT
#include "robots/companion/pending_actions.h"

#include <algorithm>
#include <limits>

#include "robots/companion/application_json.h"

namespace reorient {

std::string PendingActions::add(const StartedAction& started, const DeclaredAction& declared, double now) {
  Waiting one;
  one.message.id = started.id;
  set_text(one.message.name, declared.name);
  const std::string arguments = arguments_json(started, declared);
  if (arguments.size() >= sizeof(one.message.arguments))
    return "action " + declared.name + ": expected arguments of at most " +
           std::to_string(sizeof(one.message.arguments) - 1) + " bytes as JSON, found " +
           std::to_string(arguments.size()) + "; it was not sent";
  set_text(one.message.arguments, arguments);
  one.reports = declared.reports;
  one.until = declared.takes > 0.0 ? now + declared.takes : std::numeric_limits<double>::infinity();
  // Only the latest start of an action is under way.
  std::erase_if(waiting_, [&](const Waiting& other) { return text_of(other.message.name) == declared.name; });
  waiting_.push_back(one);
  return {};
}

void PendingActions::acknowledge(std::uint32_t id) {
  std::erase_if(waiting_, [id](const Waiting& one) { return one.message.id == id; });
}

void PendingActions::begin_connection() {
  for (Waiting& one : waiting_) one.is_sent = false;
}

void PendingActions::drop_late(double now) {
  std::erase_if(waiting_, [now](const Waiting& one) { return now > one.until; });
}

void PendingActions::drop_unreported() {
  std::erase_if(waiting_, [](const Waiting& one) { return one.is_sent && !one.reports; });
}

}  // namespace reorient
