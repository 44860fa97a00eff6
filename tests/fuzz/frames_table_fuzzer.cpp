// SPDX-License-Identifier: MIT
// Arbitrary bytes as a table of footage: refused with one line that names the file, or read as rows with finite numbers
// whose times increase.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "robots/footage/frames_table.h"
#include "tests/fuzz/promises.h"

namespace reorient {
namespace {

void try_table(std::string_view text, const ColumnHeaders& headers) {
  const Haste haste(5.0);
  std::vector<FrameRow> rows;
  try {
    rows = parse_frames(text, "frames.csv", headers);
  } catch (const BadFootage& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("frames.csv:"), "a refusal names the file");
    return;
  }
  require(!rows.empty(), "a table that is read has rows");
  std::optional<double> last;
  for (const FrameRow& row : rows) {
    const std::optional<double> time = row.value(FrameColumn::time);
    require(time.has_value() == rows.front().value(FrameColumn::time).has_value(),
            "all rows have a time, or no row has one");
    require(!time || !last || *time > *last, "times increase");
    last = time;
    require(row.robot_from_camera(0.5).matrix().allFinite(), "the camera's pose is finite");
    for (const std::optional<Pose2>& pose : {row.pose(), row.odometry()})
      require(!pose || (pose->position.allFinite() && std::isfinite(pose->rotation)), "a pose is finite");
  }
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  reorient::try_table(text, {});
  reorient::try_table(text, {{"time", "t:ms"}, {"image", "f"}, {"rotation", "yaw:deg"}});
  return 0;
}
