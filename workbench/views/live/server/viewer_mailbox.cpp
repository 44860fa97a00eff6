// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/viewer_mailbox.h"

#include <algorithm>
#include <utility>

#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient::live {
namespace {

Outgoing text_message(std::string text) {
  return {WebSocketType::text, {}, std::make_shared<const std::string>(std::move(text))};
}

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

void ViewerMailbox::add_data(Outgoing message, Importance importance) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  const std::size_t size = message.size();
  make_room(size);
  if (size > limits_.data_bytes) {
    ++dropped_;
    has_news_of_drops_ = true;
  } else {
    data_bytes_ += size;
    data_.push_back({std::move(message), importance});
  }
  wake_.notify_one();
}

void ViewerMailbox::add_control(Outgoing message) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  control_bytes_ += message.size();
  control_.push_back(std::move(message));
  if (control_bytes_ > limits_.control_bytes || control_.size() > limits_.control_messages) {
    control_.clear();
    data_.clear();
    close_locked(kPolicyViolation, "the viewer does not read the answers to its requests");
  }
  wake_.notify_one();
}

void ViewerMailbox::add_control(std::string text) { add_control(text_message(std::move(text))); }

void ViewerMailbox::close_locked(std::uint16_t code, const std::string& reason) {
  closed_ = Clock::now();
  // A close frame is sent as it is, so it has no head of its own.
  control_.push_back({WebSocketType::close, websocket_close(code, reason), nullptr});
  wake_.notify_one();
}

void ViewerMailbox::close(std::uint16_t code, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  data_.clear();
  close_locked(code, reason);
}

void ViewerMailbox::close_now(std::uint16_t code, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  data_.clear();
  control_.clear();
  close_locked(code, reason);
}

std::optional<Outgoing> ViewerMailbox::wait() {
  constexpr std::chrono::seconds kNewsEvery{1};
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return !control_.empty() || !data_.empty() || closed_; });
  if (!control_.empty()) {
    Outgoing message = std::move(control_.front());
    control_.pop_front();
    control_bytes_ -= std::min(control_bytes_, message.size());
    return message;
  }
  if (data_.empty()) return std::nullopt;
  if (has_news_of_drops_ && Clock::now() - last_news_ >= kNewsEvery) {
    has_news_of_drops_ = false;
    last_news_ = Clock::now();
    return text_message(status(StatusLevel::warning, kDroppedText, kDroppedId));
  }
  Outgoing message = std::move(data_.front().message);
  data_.pop_front();
  data_bytes_ -= message.size();
  return message;
}

bool ViewerMailbox::is_given_up() const {
  const std::lock_guard lock(mutex_);
  return closed_ && Clock::now() - *closed_ > kPatience;
}

std::uint64_t ViewerMailbox::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace reorient::live
