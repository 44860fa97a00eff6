// SPDX-License-Identifier: MIT
// A simulated NAO with the interfaces of LoLA and of its camera, in cycles of 12 ms. Head, attitude and feet are those
// of the simulator, all other joints those of the twin body.
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

  /// One cycle: writes the packet of LoLA and returns its number of bytes.
  std::size_t feel(std::span<std::byte> packet);
  /// Receives a packet. Returns false if it is not a command.
  bool take(std::span<const std::byte> packet);
  void take(const Command& command);
  /// Ends the cycle of the measurement at `now` (s on the monotonic clock). Every third cycle has an image.
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
