// SPDX-License-Identifier: MIT
// A NAO that is the simulator behind LoLA and V4L2, with its guard, in simulated time: what the engine's robot sees are
// packets and buffers, and all that it can do is to wait and to ask.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "robots/nao/guard/session.h"
#include "robots/nao/nao.h"
#include "tests/robots/nao/twin/twin_nao.h"

namespace reorient::nao {

class NaoWorld {
 public:
  NaoWorld(SimulatorParameters parameters, const RobotBody& body, const FieldDimensions& field, const Room& room,
           const Pose2& start, std::uint64_t seed);

  /// What a Nao is given.
  NaoSurroundings surroundings(std::function<bool()> is_over = nullptr);

  double now() const { return now_; }
  Simulator& simulator() { return nao_.simulator(); }
  TwinBody& body() { return nao_.body(); }
  FakeVideo& camera() { return nao_.camera(); }
  SharedBody& shared() { return *shared_; }
  GuardReport report() const { return session_.report(now_); }

  /// For so many seconds the guard is not there to be asked, or the engine cannot reach it.
  void hide_guard(bool hidden) { guard_is_hidden_ = hidden; }
  /// One cycle of 12 ms.
  void step();

 private:
  TwinNao nao_;
  std::unique_ptr<SharedBody> shared_;
  Session session_;
  double now_ = 1000.0;  // s, of the monotonic clock
  bool guard_is_hidden_ = false;
};

}  // namespace reorient::nao
