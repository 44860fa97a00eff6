// SPDX-License-Identifier: MIT
#include "robots/nao/guard/session.h"

#include <cmath>

namespace reorient::nao {

void Session::connected() {
  guard_.connected();
  stream_.clear();
  reader_ = {};
  measurement_ = {};
  answer_size_ = sent_ = 0;
  has_next_ = false;
  ++counts_.connections;
}

void Session::disconnected() {
  guard_.connected();
  answer_size_ = sent_ = 0;
  has_next_ = false;
}

bool Session::received(std::size_t size, double time) {
  stream_.written(size);
  std::span<const std::byte> packet;
  bool any = false;
  while (true) {
    const PacketStream::State state = stream_.next(packet);
    if (state == PacketStream::State::invalid) return false;
    if (state == PacketStream::State::waiting) break;
    measurement_.time = time;
    if (!reader_.read(packet, measurement_)) return false;
    ++counts_.cycles;
    if (!measurement_.has(SensorKey::position) || !measurement_.has(SensorKey::angles)) ++counts_.unusable;
    read_walk();
    body_.add(measurement_);
    if (any) ++counts_.late;  // the packet before this one will not be answered
    any = true;
  }
  if (any) answer();
  return true;
}

/// The walk's odometry is assigned to the measurement of the cycle in which it is read.
void Session::read_walk() {
  WalkTargets walk;
  if (body_.walk.read(walk)) walk_ = walk;  // otherwise the last one stays and becomes too old
  measurement_.is_walked = walk_ && std::fabs(measurement_.time - walk_->time) <= Guard::kHolds ? 1 : 0;
  if (measurement_.is_walked != 0) measurement_.walked = walk_->odometry;
}

void Session::answer() {
  BodyRequest request;
  if (body_.request.read(request)) request_ = request;  // otherwise the last one stays and becomes too old
  const bool none_is_waiting = answer_size_ == 0 || (sent_ > 0 && !has_next_);
  if (none_is_waiting) {
    before_ = guard_;
  } else {
    guard_ = before_;  // the body has not received this answer and has not moved
  }
  const std::optional<Command> command = guard_.step(measurement_, reader_.robot(), request_, walk_);
  body_.report.write(report(measurement_.time));
  if (!command) return;
  if (sent_ > 0) {
    next_ = command_packet(*command);
    next_time_ = measurement_.time;
    has_next_ = true;
    return;
  }
  answer_ = command_packet(*command);
  answered_time_ = measurement_.time;
  answer_size_ = answer_.size();
}

void Session::sent(std::size_t size, double time) {
  sent_ += size;
  if (sent_ < answer_size_) return;
  if (time - answered_time_ > kCycle) ++counts_.late;
  sent_ = answer_size_ = 0;
  if (!has_next_) return;
  answer_ = next_;
  answered_time_ = next_time_;
  answer_size_ = answer_.size();
  has_next_ = false;
}

void Session::finish() {
  guard_.finish();
  before_.finish();
}

GuardReport Session::report(double time) const {
  GuardReport report = counts_;
  report.time = time;
  report.state = guard_.state();
  report.warnings = guard_.warnings();
  report.joint = guard_.warning_joint();
  return report;
}

}  // namespace reorient::nao
