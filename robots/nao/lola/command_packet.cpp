// SPDX-License-Identifier: MIT
#include "robots/nao/lola/command_packet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "robots/nao/lola/packed.h"

namespace reorient::nao {
namespace {

constexpr std::size_t kMostValues = 25;

/// The numbers of a key in the order of a packet. For the eyes: first all eight of red, then green, then blue.
struct Numbers {
  std::array<float, kMostValues> values{};
  std::size_t count = 0;
};

template <typename Values>
Numbers plain(const Values& values) {
  Numbers numbers;
  numbers.count = values.size();
  std::copy(values.begin(), values.end(), numbers.values.begin());
  return numbers;
}

Numbers ring(const std::array<Lights::Color, Lights::kEye>& eye) {
  Numbers numbers;
  numbers.count = 3 * eye.size();
  for (std::size_t i = 0; i < eye.size(); ++i) {
    numbers.values[i] = eye[i].red;
    numbers.values[eye.size() + i] = eye[i].green;
    numbers.values[2 * eye.size() + i] = eye[i].blue;
  }
  return numbers;
}

Numbers color(const Lights::Color& light) { return plain(std::array{light.red, light.green, light.blue}); }

std::optional<Numbers> read_numbers(PackedReader& reader) {
  const std::optional<std::uint32_t> count = reader.array();
  if (!count || *count > kMostValues) return std::nullopt;
  Numbers numbers;
  numbers.count = *count;
  for (std::size_t i = 0; i < numbers.count; ++i) {
    const std::optional<float> number = reader.number();
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.values[i] = *number;
  }
  return numbers;
}

template <typename Values>
bool take(const Numbers& numbers, Values& values) {
  if (numbers.count != values.size()) return false;
  std::copy_n(numbers.values.begin(), values.size(), values.begin());
  return true;
}

bool take(const Numbers& numbers, std::array<Lights::Color, Lights::kEye>& eye) {
  if (numbers.count != 3 * eye.size()) return false;
  for (std::size_t i = 0; i < eye.size(); ++i)
    eye[i] = {numbers.values[i], numbers.values[eye.size() + i], numbers.values[2 * eye.size() + i]};
  return true;
}

bool take(const Numbers& numbers, Lights::Color& light) {
  if (numbers.count != 3) return false;
  light = {numbers.values[0], numbers.values[1], numbers.values[2]};
  return true;
}

}  // namespace

std::array<std::byte, kCommandBytes> command_packet(const Command& command) {
  std::array<std::byte, kCommandBytes> bytes{};
  PackedWriter writer(bytes);
  const auto put = [&writer](std::string_view key, const Numbers& numbers) {
    writer.text(key);
    writer.array(static_cast<std::uint32_t>(numbers.count));
    for (std::size_t i = 0; i < numbers.count; ++i) writer.number(numbers.values[i]);
  };
  const Lights& lights = command.lights;
  writer.map(11);
  put("Position", plain(command.position));
  put("Stiffness", plain(command.stiffness));
  put("LEar", plain(lights.left_ear));
  put("REar", plain(lights.right_ear));
  put("Chest", color(lights.chest));
  put("LEye", ring(lights.left_eye));
  put("REye", ring(lights.right_eye));
  put("LFoot", color(lights.left_foot));
  put("RFoot", color(lights.right_foot));
  put("Skull", plain(lights.skull));
  writer.text("Sonar");
  writer.array(2);
  writer.boolean(false);
  writer.boolean(false);
  return bytes;
}

bool read_command_packet(std::span<const std::byte> packet, Command& command) {
  PackedReader reader(packet);
  const std::optional<std::uint32_t> pairs = reader.map();
  if (!pairs) return false;
  Lights& lights = command.lights;
  for (std::uint32_t i = 0; i < *pairs; ++i) {
    const std::optional<std::string_view> key = reader.text();
    if (!key) return false;
    const std::optional<Numbers> numbers = read_numbers(reader);
    if (!numbers) return false;
    bool good = true;
    if (key == "Position") good = take(*numbers, command.position);
    if (key == "Stiffness") good = take(*numbers, command.stiffness);
    if (key == "LEar") good = take(*numbers, lights.left_ear);
    if (key == "REar") good = take(*numbers, lights.right_ear);
    if (key == "Chest") good = take(*numbers, lights.chest);
    if (key == "LEye") good = take(*numbers, lights.left_eye);
    if (key == "REye") good = take(*numbers, lights.right_eye);
    if (key == "LFoot") good = take(*numbers, lights.left_foot);
    if (key == "RFoot") good = take(*numbers, lights.right_foot);
    if (key == "Skull") good = take(*numbers, lights.skull);
    if (!good) return false;
  }
  return true;
}

}  // namespace reorient::nao
