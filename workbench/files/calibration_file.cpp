#include "workbench/files/calibration_file.h"

#include <cstdio>

#include "geometry/angle.h"
#include "workbench/files/table_reader.h"

namespace reorient {

Calibration parse_calibration(std::string_view text, const std::string& name) {
  const toml::table table = parse_table(text, name);
  const TableReader in(table, name);
  Calibration calibration;
  const auto into = [&](CameraOffset& offset) {
    return [&in, &name, &offset](auto& key, auto& value) {
      constexpr double kMost = 15.0;  // degrees: what is farther off is broken
      const TableReader camera(in.table(key, value), name);
      double tilt = 0.0, pan = 0.0;
      camera.read(
          {{"tilt_degrees", camera.into(tilt, -kMost, kMost)}, {"pan_degrees", camera.into(pan, -kMost, kMost)}});
      offset = {from_degrees(tilt), from_degrees(pan)};
    };
  };
  in.read({{"upper", into(calibration[0])}, {"lower", into(calibration[1])}});
  return calibration;
}

Calibration load_calibration(const std::filesystem::path& file) {
  return parse_calibration(read_data_file(file, "calibration", "docs/on-a-robot.md"), file.string());
}

std::string to_toml(const Calibration& calibration) {
  std::string text;
  const char* const names[] = {"upper", "lower"};
  for (std::size_t i = 0; i < calibration.size(); ++i) {
    char lines[120];
    std::snprintf(lines, sizeof(lines), "[%s]\ntilt_degrees = %.2f\npan_degrees = %.2f\n", names[i],
                  to_degrees(calibration[i].tilt), to_degrees(calibration[i].pan));
    text += lines;
  }
  return text;
}

}  // namespace reorient
