// SPDX-License-Identifier: MIT
// Converts one packet of LoLA to a measurement. Keys may have any order, unknown keys are ignored, numbers may have any
// type.
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
  /// `packet`: one whole map. Its valid values (expected count of numbers, all of them finite) are written to
  /// `measurement` and marked as fresh; its other values are unchanged. Returns false if the packet is not a map.
  bool read(std::span<const std::byte> packet, Measurement& measurement);

  /// Identity from the last packet that contained it.
  const std::optional<RobotIdentity>& robot() const { return robot_; }

 private:
  /// The key at the same position in the previous packet. All packets of a robot have the same keys in the same order,
  /// so each key is looked up only once and not in every cycle.
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
