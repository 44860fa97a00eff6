// A NAO that is the simulator behind LoLA and V4L2, with its guard, in simulated time: what the engine's robot sees are
// packets and buffers, and all that it can do is to wait and to ask.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "robots/nao/guard/session.h"
#include "robots/nao/nao.h"
#include "robots/simulator/simulator.h"
#include "tests/robots/nao/twin/fake_video.h"
#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {

class NaoWorld {
 public:
  NaoWorld(SimulatorParameters parameters, const RobotBody& body, const FieldDimensions& field, const Room& room,
           const Pose2& start, std::uint64_t seed);

  /// What a Nao is given.
  NaoSurroundings surroundings(std::function<bool()> is_over = nullptr);
  /// Three frames of a camera take ten cycles of LoLA, as near as whole cycles come to 30 images a second.
  static SimulatorParameters in_step(SimulatorParameters parameters);

  double now() const { return now_; }
  Simulator& simulator() { return simulator_; }
  TwinBody& body() { return body_; }
  FakeVideo& camera() { return camera_; }
  SharedBody& shared() { return *shared_; }
  GuardReport report() const { return session_.report(now_); }

  /// For so many seconds the guard is not there to be asked, or the engine cannot reach it.
  void hide_guard(bool hidden) { guard_is_hidden_ = hidden; }
  /// One cycle of 12 ms.
  void step();

 private:
  void look();

  Simulator simulator_;
  TwinBody body_;
  FakeVideo camera_;
  std::unique_ptr<SharedBody> shared_;
  Session session_;
  Command command_;
  std::deque<BodySample> samples_;
  std::vector<std::uint8_t> picture_;
  double picture_time_ = 0.0;
  double now_ = kStart;
  bool guard_is_hidden_ = false;

  static constexpr double kStart = 1000.0;  // s, of the monotonic clock
};

}  // namespace reorient::nao
