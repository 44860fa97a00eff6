// SPDX-License-Identifier: MIT
// How much of the frames a viewer receives: measured on its connection, so that what arrives is never old. Pure
// functions; the time is an argument.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace reorient::live {

/// A message should be at most this old, in s, when the viewer's computer has it.
inline constexpr double kMostAge = 0.3;

/// The large messages of a frame. A slow connection carries them less often than frames. `upper`, `lower`: an image and
/// what is drawn on it.
enum class Bulk { upper, lower, particles, wall };
inline constexpr std::size_t kBulkCount = 4;

/// The connection at some moment.
struct LinkMeasurement {
  double time = 0.0;            ///< s
  std::uint64_t delivered = 0;  ///< bytes that the viewer has acknowledged
  std::size_t waiting = 0;      ///< bytes before a new message, those on their way among them
  double unanswered = 0.0;      ///< s that the oldest bytes wait for an acknowledgment; 0: all are acknowledged
  double round_trip = 0.0;      ///< s, the shortest so far
};

/// What is known about a connection; at first nothing. Bytes are counted only while answers are late, because only then
/// the connection limits them. Recent ones count more.
struct LinkState {
  LinkMeasurement last;
  double bytes = 0.0, seconds = 0.0;  ///< recent bytes, and the time that they took
  double known_until = 0.0;           ///< s; later the connection may have become faster, so nothing is left out
  double trust = 0.0;                 ///< s from a measurement to `known_until`
  double rate_before = 0.0;           ///< bytes/s, as last known
  bool is_full = false;               ///< a frame was left out since the last bulk
  double bulk_again = 0.0;            ///< s; when a full connection may carry bulk again
  std::array<double, kBulkCount> sent_bulk{};  ///< s; when each was sent
};

LinkState measure(const LinkState& state, const LinkMeasurement& link);

/// The newest frame, which waits for the connection.
struct WaitingFrame {
  std::size_t bytes = 0;                       ///< without bulk
  std::array<std::size_t, kBulkCount> bulk{};  ///< bytes; 0: none
  bool replaces = false;                       ///< a frame that was not sent
};

struct LinkDecision {
  LinkState state;
  bool sends = false;                   ///< the frame, now
  std::array<bool, kBulkCount> bulk{};  ///< what is sent with it
  double again = 0.0;                   ///< s; if the frame waits: when to decide again
};

/// Whether the frame is sent now. If it waits, a newer one may replace it.
LinkDecision decide(const LinkState& state, const LinkMeasurement& link, const WaitingFrame& frame);

}  // namespace reorient::live
