// SPDX-License-Identifier: MIT
// Arbitrary bytes as a field file: refused with one line that names the file, or read as a field with finite lines and
// valid maps.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "localization/measurement/field_map.h"
#include "robots/simulator/render/scene/field_lines.h"
#include "tests/fuzz/promises.h"
#include "workbench/files/field_file.h"

namespace reorient {
namespace {

constexpr double kLargestMap = 20.0;  // m^2; the map of a larger field takes long with sanitizers
constexpr float kRounding = 1e-4f;

void draw(const FieldDimensions& field) {
  for (const FieldLine& line : field_lines(field))
    require(line.from.allFinite() && line.to.allFinite(), "a line is finite");
  for (const Eigen::Vector2d& post : goal_posts(field)) require(post.allFinite(), "a post is finite");
  const FieldLines lines(field);
  for (const float x : {0.0f, 0.5f * static_cast<float>(field.length), 1.0f}) {
    for (const float y : {0.0f, 0.5f * static_cast<float>(field.width), 0.75f}) {
      const float share = lines.cover(x, y, 0.1f, 0.1f);
      require(share >= 0.0f && share <= 1.0f + kRounding, "the fraction of line is between 0 and 1");
    }
  }
}

void believe(const FieldDimensions& field) {
  const FieldMap map(field);
  for (double x = -0.5 * field.length - 2.0; x < 0.5 * field.length + 2.0; x += 0.37) {
    const auto steps = map.steps(static_cast<float>(x), static_cast<float>(0.3 * x), 0);
    require(steps == map.steps(static_cast<float>(-x), static_cast<float>(-0.3 * x), 0), "the field is symmetric");
  }
}

void try_file(std::string_view text) {
  const Haste haste(5.0);
  FieldDimensions field;
  try {
    field = parse_field(text, "field.toml");
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("field.toml:"), "a refusal names the file");
    return;
  }
  require(mistake_in(field).empty(), "a field that is read is valid");
  draw(field);
  if ((field.length + 2.0 * field.border) * (field.width + 2.0 * field.border) <= kLargestMap) believe(field);
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_file({reinterpret_cast<const char*>(data), size});
  return 0;
}
