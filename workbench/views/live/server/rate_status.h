// SPDX-License-Identifier: MIT
// The status of a slow connection: how many frames and images the viewer receives.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace reorient::live {

inline constexpr const char* kSlowId = "slow";  ///< of the status

struct FrameCounts {
  std::uint64_t frames = 0, images = 0;
};

/// Counts what is sent and what is left out, and makes a status of it from time to time.
class RateStatus {
 public:
  void add_frame(std::uint64_t images) { offered_.frames += 1, offered_.images += images; }
  void send_frame() { ++sent_.frames; }
  void send_image() { ++sent_.images; }

  /// The text of a message to the viewer: a status, or its removal. Nothing: no news. `time`: s. `shows_rates`: the
  /// status has numbers of the last seconds. Foxglove and Lichtblick list each text as another problem, because they
  /// ignore the id.
  std::optional<std::string> take_news(double time, bool shows_rates);
  FrameCounts left_out() const;

 private:
  FrameCounts offered_, sent_, offered_before_, sent_before_;
  std::optional<double> begin_;  // s, of the interval
  int good_ = 0;                 // intervals since something was left out
  std::string shown_;            // the status that the viewer shows; empty: none
};

}  // namespace reorient::live
