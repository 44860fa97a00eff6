// SPDX-License-Identifier: MIT
#include "perception/room/saved_model.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "geometry/bytes.h"
#include "geometry/checksum.h"

namespace reorient {
namespace {

constexpr std::uint64_t kModelMagic = 0x6C65646F4D6D5252ull;  // "RRmModel"
constexpr std::uint32_t kModelVersion = 2;                    // increases with each change of the content of a model
constexpr std::uint32_t kWithoutBias = 1;                     // an older version, which can be read, too
constexpr std::size_t kHead = sizeof(std::uint64_t) + 2 * sizeof(std::uint32_t);
constexpr std::size_t kChecksum = sizeof(std::uint64_t);

std::string text_of(bool value) { return value ? "true" : "false"; }
template <typename Number>
std::string text_of(Number value) {
  char digits[32];
  const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), value);
  return {digits, error == std::errc() ? end : digits};
}

struct Setting {
  std::string name;
  std::string value;
  bool operator==(const Setting&) const = default;
};

/// One part of a basis by its describe(): its settings, and whether each value is possible for its parameter.
struct Described {
  std::string part;
  std::vector<Setting> settings;
  bool is_sound = true;

  template <typename Number, typename... Words>
  void operator()(const char* name, Number& value, double least, double most, const Words&...) {
    is_sound &= static_cast<double>(value) >= least && static_cast<double>(value) <= most;
    settings.push_back({part + name, text_of(value)});
  }
};

Described described(ModelBasis basis) {
  Described all{"wall.", {}};
  describe(basis.wall, all);
  all.part = "color.";
  describe(basis.color, all);
  all.settings.push_back({"light_adaptation.enabled", text_of(basis.light_adaptation)});
  all.settings.push_back({"pose_light.enabled", text_of(basis.pose_light)});
  return all;
}

bool is_sound(const CameraBias& bias) {
  constexpr double kMost = 0.5;  // rad
  const auto is_angle = [](double angle) { return std::abs(angle) <= kMost; };
  for (const TiltBias& one : {bias.torso, bias.mounts[0], bias.mounts[1]}) {
    if (!is_angle(one.roll) || !is_angle(one.pitch)) return false;
  }
  return bias.deviation >= 0.0 && is_angle(bias.deviation);
}

}  // namespace

std::string differences(const ModelBasis& given, const ModelBasis& expected) {
  const std::vector<Setting> found = described(given).settings, needed = described(expected).settings;
  std::string different;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == needed[i]) continue;
    different += (different.empty() ? "" : " ") + needed[i].name + "=" + needed[i].value;
  }
  return different;
}

void write_model(const SavedModel& model, std::vector<std::byte>& bytes) {
  const std::size_t begin = bytes.size();
  ByteWriter writer(bytes);
  writer(kModelMagic, kModelVersion, std::uint32_t{0});
  writer(model.basis, model.learned, model.model, model.camera_bias);
  const auto size = static_cast<std::uint32_t>(bytes.size() - begin - kHead);
  std::memcpy(bytes.data() + begin + kHead - sizeof(size), &size, sizeof(size));
  writer(checksum(std::span<const std::byte>(bytes).subspan(begin)));
}

SavedModel read_model(std::span<const std::byte> bytes) {
  std::uint64_t magic = 0, sum = 0;
  std::uint32_t version = 0, size = 0;
  check_bytes(!bytes.empty(), "it is empty");
  check_bytes(bytes.size() >= sizeof(magic) && std::memcmp(bytes.data(), &kModelMagic, sizeof(magic)) == 0,
              "it is not a model of a room");
  check_bytes(bytes.size() >= kHead + kChecksum, "it is truncated");
  ByteReader head(bytes);
  head(magic, version, size);
  if (version > kModelVersion)
    throw BadBytes("it was written by a newer version of this program: format " + std::to_string(version) +
                   " (expected at most " + std::to_string(kModelVersion) + ")");
  check_bytes(version == kModelVersion || version == kWithoutBias, "it is damaged: unknown format (expected 1 or 2)");
  if (bytes.size() != kHead + size + kChecksum)
    throw BadBytes("it is truncated or too long: found " + std::to_string(bytes.size()) + " bytes (expected " +
                   std::to_string(kHead + size + kChecksum) + ")");
  std::memcpy(&sum, bytes.last(kChecksum).data(), sizeof(sum));
  check_bytes(sum == checksum(bytes.first(kHead + size)), "it is damaged: the checksum does not match");

  ByteReader content(bytes.subspan(kHead, size));
  SavedModel model;
  content(model.basis, model.learned);
  check_bytes(described(model.basis).is_sound, "it is damaged: a parameter is invalid");
  check_bytes(model.learned >= 0.0 && model.learned <= kLongestTraining, "it is damaged: the training time is invalid");
  const Wall wall(model.basis.wall);
  check_bytes(differences({wall.parameters(), {}}, {model.basis.wall, {}}).empty(),
              "it is damaged: the wall is invalid");
  model.model.forget(wall.tiles());
  content(model.model);
  if (version > kWithoutBias) content(model.camera_bias);
  if (model.camera_bias)
    check_bytes(is_sound(model.camera_bias->bias), "it is damaged: an angle of a camera is invalid");
  content.finish();
  return model;
}

}  // namespace reorient
