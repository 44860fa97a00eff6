// SPDX-License-Identifier: MIT
// A simulated NAO behind LoLA and V4L2, with its guard, in simulated time. The robot of the engine receives packets and
// buffers, and can only wait and send requests.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "robots/nao/guard/session.h"
#include "robots/nao/nao.h"
#include "tests/robots/nao/twin/twin_nao.h"

namespace reorient::nao {

class NaoWorld {
 public:
  NaoWorld(SimulatorParameters parameters, const RobotBody& body, const FieldDimensions& field, const Room& room,
           const Pose2& start, std::uint64_t seed);

  /// The surroundings for a Nao.
  NaoSurroundings surroundings(std::function<bool()> is_over = nullptr);

  double now() const { return now_; }
  Simulator& simulator() { return nao_.simulator(); }
  TwinBody& body() { return nao_.body(); }
  FakeVideo& camera() { return nao_.camera(); }
  SharedBody& shared() { return *shared_; }
  GuardReport report() const { return session_->report(now_); }

  /// While hidden, the guard cannot be reached by the engine.
  void hide_guard(bool hidden) { guard_is_hidden_ = hidden; }
  /// The guard ends as after SIGTERM; LoLA keeps its last command.
  void stop_guard() { session_->finish(); }
  /// A new process of the guard, with empty shared memory.
  void restart_guard();
  /// One cycle of 12 ms.
  void step();

 private:
  TwinNao nao_;
  std::unique_ptr<SharedBody> shared_;
  std::optional<Session> session_;
  double now_ = 1000.0;  // s on the monotonic clock
  bool guard_is_hidden_ = false;
};

}  // namespace reorient::nao
