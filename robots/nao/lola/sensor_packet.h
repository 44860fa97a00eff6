// SPDX-License-Identifier: MIT
// One packet of LoLA's as a measurement. Keys come in any order; unknown ones are left out; numbers may be of any kind.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "robots/nao/lola/measurement.h"

namespace reorient::nao {

class SensorReader {
 public:
  /// `packet`: one whole map. What it holds in good order (as many numbers as there have to be, all of them finite)
  /// goes into `measurement` and is marked as fresh; everything else stays as it is there. False: it is no map.
  bool read(std::span<const std::byte> packet, Measurement& measurement);

  /// Of the last packet that said it.
  const std::optional<RobotIdentity>& robot() const { return robot_; }

 private:
  /// What a key of the packet before meant, at the same place. A robot's packets all have the same keys in the same
  /// order, so that each is looked up once, not once a cycle.
  struct Remembered {
    std::array<char, 32> name{};
    std::size_t length = 0;
    std::optional<SensorKey> key;
  };
  static constexpr std::size_t kMostKeys = 32;

  std::optional<SensorKey> key_at(std::size_t place, std::string_view name);

  std::array<Remembered, kMostKeys> keys_{};
  std::optional<RobotIdentity> robot_;
};

/// The inverse, for a simulated robot: 896 bytes, as a robot sends them. Returns the number of bytes; more than the
/// buffer's size means that it did not fit.
std::size_t write_sensor_packet(const Measurement& measurement, const RobotIdentity& robot,
                                std::span<std::byte> buffer);

}  // namespace reorient::nao
