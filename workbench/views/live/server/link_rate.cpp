// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/link_rate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace reorient::live {
namespace {

constexpr double kLongestWait = kMostAge / 4;  // s that a frame spends behind other messages
constexpr double kShortWait = kMostAge / 6;    // s, after which there is time for bulk, too

constexpr double kBulkShare = 0.4;  // of a busy connection
// The wall must arrive, even if that takes long. Times what it takes:
constexpr double kWallPause = 10.0;
constexpr double kMemory = 0.5;                         // s
constexpr double kShortest = 0.01;                      // s between two measurements; acknowledgments come in groups
constexpr double kEnough = 0.05;                        // s of a busy connection after which its rate is known
constexpr double kLeastTrust = 2.0, kMostTrust = 30.0;  // s
constexpr double kSoonest = 0.005, kLatest = 0.05;      // s to the next decision

constexpr auto kWall = static_cast<std::size_t>(Bulk::wall);

bool is_known(const LinkState& state) { return state.last.time < state.known_until; }

/// Whether messages queue.
bool is_busy(const LinkMeasurement& link) { return link.unanswered > link.round_trip + kShortWait; }

/// s that the connection takes for so many bytes. Of an unknown connection 0, of one without progress infinity.
double cost(const LinkState& state, std::size_t bytes) {
  if (bytes == 0 || !is_known(state)) return 0.0;
  return state.bytes > 0.0 ? static_cast<double>(bytes) * state.seconds / state.bytes
                           : std::numeric_limits<double>::infinity();
}

/// Counts the bytes of an interval.
void count(LinkState& state, double bytes, double seconds) {
  const double kept = std::exp(-seconds / kMemory);
  state.bytes = kept * state.bytes + bytes;
  state.seconds = kept * state.seconds + seconds;
}

/// The measured rate is known for some time: for longer if it is again the one that was known before.
void trust(LinkState& state, bool was_known) {
  const double rate = state.bytes / state.seconds;
  if (!was_known) {
    const bool is_as_before = state.trust > 0.0 && rate < 1.5 * state.rate_before;
    state.trust = is_as_before ? std::min(2.0 * state.trust, kMostTrust) : kLeastTrust;
  }
  state.rate_before = rate;
  state.known_until = state.last.time + state.trust;
}

/// s that a new message waits.
double waiting_time(const LinkState& state, const LinkMeasurement& link) {
  return std::max(0.0, cost(state, link.waiting) - link.round_trip);
}

/// Chooses the bulk that is sent with the frame.
void choose_bulk(LinkDecision& decision, const WaitingFrame& frame) {
  const LinkState& state = decision.state;
  const double now = state.last.time;
  const bool is_free = !state.is_full && waiting_time(state, state.last) <= kShortWait;
  if (!is_free && now < state.bulk_again) return;
  std::array<std::size_t, kBulkCount> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return state.sent_bulk[a] < state.sent_bulk[b]; });
  std::size_t chosen = 0;  // bytes
  for (const std::size_t which : order) {
    const std::size_t bytes = frame.bulk[which];
    if (bytes == 0) continue;
    const bool is_fast = cost(state, chosen + bytes) <= kMostAge;
    const bool is_due = which == kWall && chosen == 0 && now >= state.bulk_again &&
                        now >= state.sent_bulk[which] + kWallPause * cost(state, bytes);
    if (!is_due && (!is_fast || (which == kWall && !is_free))) continue;
    decision.bulk[which] = true;
    chosen += bytes;
    if (!is_free || !is_fast) return;
  }
}

}  // namespace

LinkState measure(const LinkState& state, const LinkMeasurement& link) {
  const double seconds = link.time - state.last.time;
  const bool was_busy = is_busy(state.last), ends = was_busy && !is_busy(link);
  LinkState next = state;
  next.last.waiting = link.waiting;
  if (seconds < kShortest && !(ends && seconds > 0.0)) return next;
  next.last = link;
  // What was measured long ago does not count.
  if (is_known(state) && !is_known(next)) next.bytes = next.seconds = 0.0;
  if (!was_busy && !is_busy(link)) return next;
  const auto bytes = static_cast<double>(link.delivered - state.last.delivered);
  count(next, bytes, was_busy ? seconds : std::min(seconds, link.unanswered));
  if (next.seconds >= kEnough) trust(next, is_known(next));
  return next;
}

LinkDecision decide(const LinkState& state, const LinkMeasurement& link, const WaitingFrame& frame) {
  LinkDecision decision{.state = measure(state, link)};
  LinkState& next = decision.state;
  next.is_full = is_known(next) && (next.is_full || frame.replaces);
  const double wait = waiting_time(next, link);
  decision.again = std::clamp(wait - kLongestWait, kSoonest, kLatest);
  if (wait > kLongestWait || (!is_known(next) && is_busy(next.last))) return decision;
  choose_bulk(decision, frame);
  std::size_t bulk = 0;
  for (std::size_t which = 0; which < kBulkCount; ++which) {
    if (!decision.bulk[which]) continue;
    bulk += frame.bulk[which];
    next.sent_bulk[which] = link.time;
  }
  decision.sends = frame.bytes + bulk > 0;
  if (!decision.sends) decision.again = kLatest;  // only bulk waits
  if (bulk > 0) {
    next.is_full = false;
    next.bulk_again = link.time + cost(next, bulk) / kBulkShare;
  }
  return decision;
}

}  // namespace reorient::live
