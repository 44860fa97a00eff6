#include "program/tuning.h"

#include <stdexcept>

#include "workbench/files/parameter_file.h"

namespace reorient {

Tuning::Tuning(int image_width) {
  simulator.image = image_width == 640   ? ImageSize::vga_640x480
                    : image_width == 320 ? ImageSize::qvga_320x240
                                         : ImageSize::qqvga_160x120;
  declare(core, registry);
  registry.bind("script", script);
  registry.bind("simulator", simulator);
  registry.bind("body", simulator.body);
  registry.bind("sensor", simulator.sensor);
  registry.bind("room_shape", room_shape);
}

void Tuning::override_by(const ParameterOptions& options) {
  for (const std::filesystem::path& file : options.files) load_parameters(registry, file);
  for (const std::string& assignment : options.assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw std::runtime_error("--set '" + assignment + "': write NAME=VALUE, as in --set orientation.lead=0.3");
    }
    registry.set_early(assignment.substr(0, equals), assignment.substr(equals + 1), ParameterOrigin::command_line);
  }
}

void Tuning::require_all_claimed() const {
  for (const std::string& line : registry.unclaimed()) throw std::runtime_error(line);
}

}  // namespace reorient
