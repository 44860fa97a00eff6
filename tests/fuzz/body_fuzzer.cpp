// SPDX-License-Identifier: MIT
// Arbitrary bytes as a robot's file: refused with one line that names the file, or read as a body with a valid neck and
// camera.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "tests/fuzz/promises.h"
#include "workbench/files/body_file.h"

namespace reorient {
namespace {

void try_body(std::string_view text) {
  const Haste haste(5.0);
  RobotBody body;
  try {
    body = parse_body(text, "robot.toml");
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("robot.toml:"), "a refusal names the file");
    return;
  }
  require(std::isfinite(standing_camera_height(body)), "the camera's height is finite");
  for (const double yaw : {-4.0, -0.3, 0.0, 1.1, 9.0}) {
    const HeadAngles reached = body.neck.clamp({yaw, 2.0 * yaw});
    require(std::abs(reached.yaw) <= body.neck.yaw, "the neck stays within its limits");
    const HeadAngles again = body.neck.clamp(reached);
    require(again.yaw == reached.yaw && again.pitch == reached.pitch, "clamping twice changes nothing");
  }
  require(!body.gait || body.gait->cruise >= 0.0, "the walking speed is non-negative");
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_body({reinterpret_cast<const char*>(data), size});
  return 0;
}
