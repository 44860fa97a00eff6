// SPDX-License-Identifier: MIT
#include "workbench/files/calibration_file.h"

#include <algorithm>
#include <cstdio>
#include <span>

#include "geometry/angle.h"
#include "geometry/checksum.h"
#include "workbench/files/table_reader.h"

namespace reorient {

Calibration parse_calibration(std::string_view text, const std::string& name) {
  const toml::table table = parse_table(text, name);
  const TableReader in(table, name);
  Calibration calibration;
  const auto into = [&](CameraOffset& offset) {
    return [&in, &name, &offset](auto& key, auto& value) {
      constexpr double kMost = 15.0;  // degrees: a larger offset is a defect
      const TableReader camera(in.table(key, value), name);
      constexpr double kMostHeight = 0.3;  // m
      double tilt = 0.0, pan = 0.0, roll = 0.0, height = 0.0;
      camera.read({{"tilt_degrees", camera.into(tilt, -kMost, kMost)},
                   {"pan_degrees", camera.into(pan, -kMost, kMost)},
                   {"roll_degrees", camera.into(roll, -kMost, kMost)},
                   {"height_m", camera.into(height, -kMostHeight, kMostHeight)}});
      offset = {from_degrees(tilt), from_degrees(pan), from_degrees(roll), height};
    };
  };
  in.read({{"upper", into(calibration.offsets[0])},
           {"lower", into(calibration.offsets[1])},
           {"footage", [&](auto& key, auto& value) {
              const TableReader footage(in.table(key, value), name);
              RecordedAttitude& recorded = calibration.recorded;
              footage.read({{"recorded_pitch", [&](auto& k, auto& v) { recorded.pitch = footage.yes(k, v); }},
                            {"recorded_roll", [&](auto& k, auto& v) { recorded.roll = footage.yes(k, v); }}});
            }}});
  return calibration;
}

Calibration load_calibration(const std::filesystem::path& file) {
  return parse_calibration(read_data_file(file, "calibration", "docs/on-a-robot.md"), file.string());
}

std::uint64_t mounting_of(const Calibration& calibration) {
  const std::string text = to_toml(calibration);
  return std::max<std::uint64_t>(checksum(std::as_bytes(std::span(text))), 1);
}

std::string to_toml(const Calibration& calibration) {
  std::string text;
  const char* const names[] = {"upper", "lower"};
  for (std::size_t i = 0; i < calibration.offsets.size(); ++i) {
    const CameraOffset& offset = calibration.offsets[i];
    char lines[120];
    std::snprintf(lines, sizeof(lines), "[%s]\ntilt_degrees = %.2f\npan_degrees = %.2f\n", names[i],
                  to_degrees(offset.tilt), to_degrees(offset.pan));
    text += lines;
    // The calibration at a known pose finds neither.
    std::snprintf(lines, sizeof(lines), "roll_degrees = %.2f\n", to_degrees(offset.roll));
    if (offset.roll != 0.0) text += lines;
    std::snprintf(lines, sizeof(lines), "height_m = %.4f\n", offset.height);
    if (offset.height != 0.0) text += lines;
  }
  const RecordedAttitude& recorded = calibration.recorded;
  if (recorded == RecordedAttitude()) return text;
  text += "[footage]\n";
  if (!recorded.pitch) text += "recorded_pitch = false\n";
  if (!recorded.roll) text += "recorded_roll = false\n";
  return text;
}

}  // namespace reorient
