// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/rate_status.h"

#include <cmath>

#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient::live {
namespace {

constexpr double kInterval = 2.0;     // s
constexpr double kMostMissing = 0.1;  // of the frames or images without a status
constexpr int kGoodIntervals = 2;     // after which nothing is left out any more
constexpr double kMostLate = 0.15;    // times the planned waits, on a computer that is not busy
constexpr const char* kAnyCause = "slow connection or busy computer: some frames or images are left out";

bool is_missing(std::uint64_t offered, std::uint64_t sent) {
  return static_cast<double>(sent) < (1.0 - kMostMissing) * static_cast<double>(offered);
}

/// A number a second, with a decimal if it is small.
std::string rate_text(std::uint64_t count, double seconds) {
  const double tenths = std::round(10.0 * static_cast<double>(count) / seconds);
  const auto whole = static_cast<int>(tenths >= 20.0 ? std::round(tenths / 10.0) : tenths / 10.0);
  const int rest = tenths >= 20.0 ? 0 : static_cast<int>(tenths) % 10;
  return std::to_string(whole) + (rest > 0 ? "." + std::to_string(rest) : "");
}

std::string slow_text(const char* cause, const FrameCounts& offered, const FrameCounts& sent, double seconds) {
  const auto rate = [&](std::uint64_t some, std::uint64_t all) {
    return rate_text(some, seconds) + " of " + rate_text(all, seconds);
  };
  std::string text = std::string(cause) + ": " + rate(sent.frames, offered.frames) + " frames";
  if (offered.images > 0) text += ", " + rate(sent.images, offered.images) + " images";
  return text + " a second";
}

FrameCounts difference(const FrameCounts& later, const FrameCounts& earlier) {
  return {later.frames - earlier.frames, later.images - earlier.images};
}

}  // namespace

std::optional<std::string> RateStatus::take_news(double time, bool shows_rates) {
  if (!begin_) begin_ = time;
  const double seconds = time - *begin_;
  if (seconds < kInterval) return std::nullopt;
  const FrameCounts offered = difference(offered_, offered_before_), sent = difference(sent_, sent_before_);
  const char* const cause = late_ > kMostLate * planned_ ? kBusyComputer : kSlowViewer;
  begin_ = time;
  planned_ = late_ = 0.0;
  offered_before_ = offered_;
  sent_before_ = sent_;
  if (offered.frames == 0) return std::nullopt;  // for example a pause
  if (is_missing(offered.frames, sent.frames) || is_missing(offered.images, sent.images)) {
    good_ = 0;
    std::string text = shows_rates ? slow_text(cause, offered, sent, seconds) : kAnyCause;
    if (text == shown_) return std::nullopt;
    shown_ = std::move(text);
    return status(StatusLevel::warning, shown_, kSlowId);
  }
  if (shown_.empty() || ++good_ < kGoodIntervals) return std::nullopt;
  shown_.clear();
  return remove_status(kSlowId);
}

FrameCounts RateStatus::left_out() const { return difference(offered_, sent_); }

}  // namespace reorient::live
