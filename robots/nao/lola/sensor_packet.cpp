// SPDX-License-Identifier: MIT
#include "robots/nao/lola/sensor_packet.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "robots/nao/lola/packed.h"

namespace reorient::nao {
namespace {

constexpr std::array<std::string_view, kSensorKeys> kNames{
    "Position", "Stiffness", "Current", "Temperature", "Status",  "Accelerometer", "Gyroscope",
    "Angles",   "Sonar",     "FSR",     "Touch",       "Battery", "RobotConfig"};

std::span<float> values_of(Measurement& measurement, SensorKey key) {
  switch (key) {
    case SensorKey::position:
      return measurement.position;
    case SensorKey::stiffness:
      return measurement.stiffness;
    case SensorKey::current:
      return measurement.current;
    case SensorKey::temperature:
      return measurement.temperature;
    case SensorKey::status:
      return measurement.status;
    case SensorKey::accelerometer:
      return measurement.accelerometer;
    case SensorKey::gyroscope:
      return measurement.gyroscope;
    case SensorKey::angles:
      return measurement.angles;
    case SensorKey::sonar:
      return measurement.sonar;
    case SensorKey::fsr:
      return measurement.fsr;
    case SensorKey::touch:
      return measurement.touch;
    case SensorKey::battery:
      return measurement.battery;
    case SensorKey::robot_config:
      break;
  }
  return {};
}

/// Returns false if the count is wrong or a value is not a number. Skips the array in any case, if it is complete.
bool read_numbers(PackedReader& reader, std::span<float> values) {
  PackedReader inside = reader;
  if (!reader.skip()) return false;
  std::array<float, kJoints> taken{};
  const std::optional<std::uint32_t> count = inside.array();
  if (count != values.size()) return false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<float> number = inside.number();
    if (!number || !std::isfinite(*number)) return false;
    taken[i] = *number;
  }
  std::copy_n(taken.begin(), values.size(), values.begin());
  return true;
}

bool read_texts(PackedReader& reader, std::optional<RobotIdentity>& robot) {
  PackedReader inside = reader;
  if (!reader.skip() || inside.array() != 4u) return false;
  RobotIdentity taken;
  for (std::array<char, 32>* const text : {&taken.body_id, &taken.body_version, &taken.head_id, &taken.head_version}) {
    const std::optional<std::string_view> read = inside.text();
    if (!read || read->size() >= text->size()) return false;
    std::copy(read->begin(), read->end(), text->begin());
  }
  robot = taken;
  return true;
}

}  // namespace

std::optional<SensorKey> SensorReader::key_at(std::size_t place, std::string_view name) {
  const auto look_up = [&]() -> std::optional<SensorKey> {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<SensorKey>(found - kNames.begin());
  };
  if (place >= keys_.size() || name.size() > keys_[place].name.size()) return look_up();
  Remembered& known = keys_[place];
  if (name != std::string_view(known.name.data(), known.length)) {
    known.length = name.size();
    std::copy(name.begin(), name.end(), known.name.begin());
    known.key = look_up();
  }
  return known.key;
}

bool SensorReader::read(std::span<const std::byte> packet, Measurement& measurement) {
  measurement.fresh = 0;
  PackedReader reader(packet);
  const std::optional<std::uint32_t> pairs = reader.map();
  if (!pairs) return false;
  for (std::uint32_t i = 0; i < *pairs; ++i) {
    const std::optional<std::string_view> name = reader.text();
    if (!name) return true;  // the values before it are valid
    const std::optional<SensorKey> key = key_at(i, *name);
    bool good = false;
    if (!key) {
      if (!reader.skip()) return true;
    } else if (*key == SensorKey::robot_config) {
      good = read_texts(reader, robot_);
    } else {
      good = read_numbers(reader, values_of(measurement, *key));
    }
    if (good) measurement.fresh |= 1u << static_cast<unsigned>(*key);
  }
  return true;
}

std::size_t write_sensor_packet(const Measurement& measurement, const RobotIdentity& robot,
                                std::span<std::byte> buffer) {
  PackedWriter writer(buffer);
  writer.map(kSensorKeys);
  Measurement copy = measurement;
  for (int i = 0; i < kSensorKeys; ++i) {
    const auto key = static_cast<SensorKey>(i);
    writer.text(kNames[static_cast<std::size_t>(i)]);
    if (key == SensorKey::robot_config) {
      writer.array(4);
      for (const std::array<char, 32>* const text :
           {&robot.body_id, &robot.body_version, &robot.head_id, &robot.head_version}) {
        const auto end = std::find(text->begin(), text->end(), '\0');
        writer.text({text->data(), static_cast<std::size_t>(end - text->begin())});
      }
      continue;
    }
    const std::span<const float> values = values_of(copy, key);
    writer.array(static_cast<std::uint32_t>(values.size()));
    for (const float value : values) {
      if (key == SensorKey::status) {
        writer.small(static_cast<std::uint8_t>(std::clamp(value, 0.0f, 127.0f)));
      } else {
        writer.number(value);
      }
    }
  }
  return writer.size();
}

}  // namespace reorient::nao
