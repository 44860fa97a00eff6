// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/viewer_mailbox.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "workbench/views/live/protocol/foxglove_protocol.h"
#include "workbench/views/live/protocol/little_endian.h"

namespace reorient::live {
namespace {

Outgoing text_message(std::string text) {
  return {WebSocketType::text, {}, std::make_shared<const std::string>(std::move(text))};
}

double seconds_of(ViewerMailbox::Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }
double seconds_of(ViewerMailbox::Clock::time_point time) { return seconds_of(time.time_since_epoch()); }

}  // namespace

bool ViewerMailbox::drop_oldest(Importance importance) {
  const auto oldest = std::find_if(data_.begin(), data_.end(),
                                   [&](const Waiting& waiting) { return waiting.importance == importance; });
  if (oldest == data_.end()) return false;
  data_bytes_ -= oldest->message.size();
  data_.erase(oldest);
  ++dropped_;
  has_news_of_drops_ = true;
  return true;
}

void ViewerMailbox::make_room(std::size_t bytes) {
  const auto is_full = [&] {
    return data_bytes_ + bytes > limits_.data_bytes || data_.size() >= limits_.data_messages;
  };
  for (const Importance importance : {Importance::image, Importance::data, Importance::lasting}) {
    while (is_full() && drop_oldest(importance)) {
    }
  }
}

void ViewerMailbox::push_data(Outgoing message, Importance importance) {
  const std::size_t size = message.size();
  make_room(size);
  if (size > limits_.data_bytes) {
    ++dropped_;
    has_news_of_drops_ = true;
  } else {
    data_bytes_ += size;
    data_.push_back({std::move(message), importance});
  }
}

void ViewerMailbox::add_data(Outgoing message, Importance importance) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  push_data(std::move(message), importance);
  wake_.notify_one();
}

void ViewerMailbox::add_frame(std::uint64_t time, std::vector<FrameMessage> messages) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  rate_.add_frame(static_cast<std::uint64_t>(std::count_if(
      messages.begin(), messages.end(), [](const FrameMessage& one) { return one.importance == Importance::image; })));
  for (FrameMessage& before : frame_.messages) {
    const bool is_replaced = std::any_of(messages.begin(), messages.end(), [&](const FrameMessage& one) {
      return one.subscription == before.subscription;
    });
    if (before.waits && !is_replaced) messages.push_back(std::move(before));
  }
  const bool replaces = !frame_.messages.empty() && !frame_.is_sent;
  frame_ = {time, std::move(messages), replaces};
  send_frame(Clock::now());
  wake_.notify_one();
}

void ViewerMailbox::forget(std::uint32_t subscription) {
  const std::lock_guard lock(mutex_);
  std::erase_if(frame_.messages, [&](const FrameMessage& one) { return one.subscription == subscription; });
}

void ViewerMailbox::measure(bool shows_rates) {
  const std::lock_guard lock(mutex_);
  shows_rates_ = shows_rates;
  begins_to_measure_ = true;
  wake_.notify_one();
}

void ViewerMailbox::receive_pong(std::span<const std::byte> bytes) {
  std::uint64_t acknowledged = 0;
  if (bytes.size() != sizeof acknowledged) return;
  std::memcpy(&acknowledged, bytes.data(), sizeof acknowledged);
  const std::lock_guard lock(mutex_);
  const auto ping =
      std::find_if(pings_.begin(), pings_.end(), [&](const Ping& one) { return one.bytes == acknowledged; });
  if (ping == pings_.end()) return;  // not an answer
  const Clock::time_point now = Clock::now();
  const double round_trip = seconds_of(now) - seconds_of(ping->sent);
  round_trip_ = is_measured_ ? std::min(round_trip_, round_trip) : round_trip;
  is_measured_ = true;
  acknowledged_ = acknowledged;
  pings_.erase(pings_.begin(), ping + 1);
  waiting_since_ = pings_.empty() ? now : pings_.front().sent;
  link_ = live::measure(link_, measure_link(now));
  wake_.notify_one();
}

/// A ping, if one is due. Its answer shows that the viewer has what was sent before it.
std::optional<Outgoing> ViewerMailbox::take_ping(Clock::time_point now) {
  constexpr std::uint64_t kEvery = 16'384;  // bytes
  constexpr std::size_t kMostPings = 1000;
  const bool is_idle = control_.empty() && data_.empty();
  if (closed_) return std::nullopt;  // nothing may follow a close frame
  const bool is_due =
      is_measured_ && pings_.size() < kMostPings && (taken_ - pinged_ >= kEvery || (is_idle && taken_ > pinged_));
  if (!is_due && !begins_to_measure_) return std::nullopt;
  begins_to_measure_ = false;
  pinged_ = taken_;
  pings_.push_back({pinged_, now});
  std::vector<std::byte> number(sizeof pinged_);
  put_little_endian(pinged_, number.data());
  return Outgoing{WebSocketType::ping, std::move(number), nullptr};
}

LinkMeasurement ViewerMailbox::measure_link(Clock::time_point now) const {
  if (!is_measured_) return {.time = seconds_of(now)};
  return {.time = seconds_of(now),
          .delivered = acknowledged_,
          .waiting = control_bytes_ + data_bytes_ + static_cast<std::size_t>(taken_ - acknowledged_),
          .unanswered = taken_ > acknowledged_ ? seconds_of(now) - seconds_of(waiting_since_) : 0.0,
          .round_trip = round_trip_};
}

/// Sends the parts of the frame for which the connection has time. Returns when to try again.
ViewerMailbox::Clock::duration ViewerMailbox::send_frame(Clock::time_point now) {
  WaitingFrame waiting{.replaces = std::exchange(frame_.replaces, false)};
  for (const FrameMessage& one : frame_.messages)
    (one.bulk ? waiting.bulk[static_cast<std::size_t>(*one.bulk)] : waiting.bytes) += kDataHead + one.text->size();
  const LinkDecision decision = decide(link_, measure_link(now), waiting);
  link_ = decision.state;
  if (decision.sends) {
    if (!std::exchange(frame_.is_sent, true)) {
      rate_.send_frame();
      push_data({WebSocketType::binary, server_time(frame_.time), nullptr}, Importance::data);
    }
    const auto send = [&](FrameMessage& one) {
      const auto head = message_data_head(one.subscription, frame_.time);
      if (one.importance == Importance::image) rate_.send_image();
      push_data({WebSocketType::binary, {head.begin(), head.end()}, std::move(one.text)}, one.importance);
    };
    for (FrameMessage& one : frame_.messages)
      if (!one.bulk) send(one);
    for (FrameMessage& one : frame_.messages)
      if (one.bulk && decision.bulk[static_cast<std::size_t>(*one.bulk)]) send(one);
    std::erase_if(frame_.messages, [](const FrameMessage& one) { return !one.text; });
  }
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(decision.again));
}

void ViewerMailbox::add_control(Outgoing message) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  control_bytes_ += message.size();
  control_.push_back(std::move(message));
  if (control_bytes_ > limits_.control_bytes || control_.size() > limits_.control_messages) {
    control_.clear();
    clear_data();
    close_locked(kPolicyViolation, "the viewer does not read the answers to its requests");
  }
  wake_.notify_one();
}

void ViewerMailbox::add_control(std::string text) { add_control(text_message(std::move(text))); }

void ViewerMailbox::clear_data() {
  data_.clear();
  frame_ = {};
}

void ViewerMailbox::close_locked(std::uint16_t code, const std::string& reason) {
  closed_ = Clock::now();
  // A close frame is sent as it is, so it has no head of its own.
  control_.push_back({WebSocketType::close, websocket_close(code, reason), nullptr});
  wake_.notify_one();
}

void ViewerMailbox::close(std::uint16_t code, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  clear_data();
  close_locked(code, reason);
}

void ViewerMailbox::close_now(std::uint16_t code, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  clear_data();
  control_.clear();
  close_locked(code, reason);
}

/// The next message, if there is one.
std::optional<Outgoing> ViewerMailbox::take(Clock::time_point now) {
  constexpr std::chrono::seconds kNewsEvery{1};
  if (!control_.empty()) {
    Outgoing message = std::move(control_.front());
    control_.pop_front();
    control_bytes_ -= std::min(control_bytes_, message.size());
    return message;
  }
  if (closed_) return std::nullopt;
  if (std::optional<std::string> news = rate_.take_news(seconds_of(now), shows_rates_))
    return text_message(std::move(*news));
  if (data_.empty()) return std::nullopt;
  if (has_news_of_drops_ && now - last_news_ >= kNewsEvery) {
    has_news_of_drops_ = false;
    last_news_ = now;
    return text_message(status(StatusLevel::warning, kDroppedText, kDroppedId));
  }
  Outgoing message = std::move(data_.front().message);
  data_.pop_front();
  data_bytes_ -= message.size();
  return message;
}

std::optional<Outgoing> ViewerMailbox::wait() {
  std::unique_lock lock(mutex_);
  while (true) {
    const Clock::time_point now = Clock::now();
    const Clock::duration again = frame_.messages.empty() ? Clock::duration::zero() : send_frame(now);
    if (std::optional<Outgoing> ping = take_ping(now)) return ping;
    if (std::optional<Outgoing> message = take(now)) {
      if (taken_ == acknowledged_) waiting_since_ = now;
      taken_ += message->size();
      return message;
    }
    if (closed_) return std::nullopt;
    if (frame_.messages.empty()) {
      wake_.wait(lock);
    } else {
      const bool is_timeout = wake_.wait_for(lock, again) == std::cv_status::timeout;
      if (is_timeout) rate_.add_wait(seconds_of(again), seconds_of(Clock::now() - now));
    }
  }
}

bool ViewerMailbox::is_given_up() const {
  const std::lock_guard lock(mutex_);
  return closed_ && Clock::now() - *closed_ > kPatience;
}

FrameCounts ViewerMailbox::left_out() const {
  const std::lock_guard lock(mutex_);
  return rate_.left_out();
}

std::uint64_t ViewerMailbox::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace reorient::live
