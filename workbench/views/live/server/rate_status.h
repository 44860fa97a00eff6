// SPDX-License-Identifier: MIT
// The status of a viewer that receives fewer frames and images than there are: how many, and why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace reorient::live {

inline constexpr const char* kSlowId = "slow";  ///< of the status

// Causes, with which the text of the status begins. The page of the live view knows them.
inline constexpr const char* kBusyComputer = "busy computer";  ///< the one of the run
inline constexpr const char* kSlowViewer = "slow connection or busy viewer";

struct FrameCounts {
  std::uint64_t frames = 0, images = 0;
};

/// Counts what is sent and what is left out, and makes a status of it from time to time.
class RateStatus {
 public:
  void add_frame(std::uint64_t images) { offered_.frames += 1, offered_.images += images; }
  void send_frame() { ++sent_.frames; }
  void send_image() { ++sent_.images; }
  /// The thread that sends the frames waited, for `planned` s, but in fact for `taken` s. It is much later than planned
  /// only if the computer is busy.
  void add_wait(double planned, double taken) { planned_ += planned, late_ += taken - planned; }

  /// The text of a message to the viewer: a status, or its removal. Nothing: no news. `time`: s. `shows_rates`: the
  /// status has numbers of the last seconds. Foxglove and Lichtblick list each text as another problem, because they
  /// ignore the id.
  std::optional<std::string> take_news(double time, bool shows_rates);
  FrameCounts left_out() const;

 private:
  FrameCounts offered_, sent_, offered_before_, sent_before_;
  std::optional<double> begin_;        // s, of the interval
  double planned_ = 0.0, late_ = 0.0;  // s, of the waits of the interval
  int good_ = 0;                       // intervals since something was left out
  std::string shown_;                  // the status that the viewer shows; empty: none
};

}  // namespace reorient::live
