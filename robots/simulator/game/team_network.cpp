// SPDX-License-Identifier: MIT
#include "robots/simulator/game/team_network.h"

#include <algorithm>
#include <utility>

namespace reorient {

void TeamNetwork::send(double time, std::size_t receiver, const Message& message) {
  const bool is_lost = random_.uniform() < parameters_.loss;
  const double due = time + parameters_.delay + parameters_.delay_spread * random_.uniform();
  ++sent_;
  if (is_lost) {
    ++lost_;
    return;
  }
  const auto later =
      std::find_if(underway_.begin(), underway_.end(), [&](const Underway& one) { return one.due > due; });
  underway_.insert(later, {due, receiver, message});
}

std::vector<Message> TeamNetwork::take(double time, std::size_t receiver) {
  std::vector<Message> arrived;
  std::erase_if(underway_, [&](Underway& one) {
    if (one.receiver != receiver || one.due > time) return false;
    arrived.push_back(std::move(one.message));
    return true;
  });
  return arrived;
}

}  // namespace reorient
