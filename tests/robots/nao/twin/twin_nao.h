// SPDX-License-Identifier: MIT
// A NAO that is the simulator, as its service LoLA and its camera show it, cycle by cycle of 12 ms: head, attitude and
// feet are the simulator's, all other joints the twin body's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "robots/nao/lola/command.h"
#include "robots/simulator/simulator.h"
#include "tests/robots/nao/twin/fake_video.h"
#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {

class TwinNao {
 public:
  TwinNao(SimulatorParameters parameters, const RobotBody& body, const FieldDimensions& field, const Room& room,
          const Pose2& start, std::uint64_t seed);

  /// One cycle: writes what LoLA says in it, and returns how many bytes that is.
  std::size_t feel(std::span<std::byte> packet);
  /// What LoLA is told. False: it is no command.
  bool take(std::span<const std::byte> packet);
  void take(const Command& command);
  /// Ends the cycle that was felt at `now` (s, of the monotonic clock): every third one has an image.
  void show(double now);

  Simulator& simulator() { return simulator_; }
  TwinBody& body() { return body_; }
  FakeVideo& camera() { return camera_; }

 private:
  void look();

  Simulator simulator_;
  TwinBody body_;
  FakeVideo camera_;
  Command command_;
  std::deque<BodySample> samples_;
  std::vector<std::uint8_t> picture_;
  double picture_lead_ = 0.0;  // s from the last sample to the picture
};

}  // namespace reorient::nao
