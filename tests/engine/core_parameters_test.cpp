// SPDX-License-Identifier: MIT
#include "engine/core_parameters.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "engine/parameters/parameter_registry.h"
#include "tests/paths.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"

namespace reorient {
namespace {

TEST(CoreParameters, AreTheDefaultsForANaoOnItsField) {
  ParameterRegistry usual, fitted;
  CoreParameters defaults, of_nao = core_parameters_for(FieldDimensions(), RobotBody());
  declare(defaults, usual);
  declare(of_nao, fitted);
  const std::vector<Parameter> expected = usual.list(), got = fitted.list();
  ASSERT_EQ(expected.size(), got.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(got[i].value, expected[i].value) << expected[i].name;
}

TEST(CoreParameters, OfEachShippedRobotAreInTheirRanges) {
  const std::filesystem::path assets = std::filesystem::path(kSourceFolder) / "assets";
  for (const char* robot : {"nao-v6", "booster-k1", "booster-t1"}) {
    const RobotBody body = load_body(assets / "robots" / (std::string(robot) + ".toml"));
    const FieldDimensions field = load_field(assets / "fields" / (body.field + ".toml"));
    ParameterRegistry registry;
    CoreParameters parameters = core_parameters_for(field, body);
    declare(parameters, registry);
    for (const Parameter& one : registry.list()) {
      const double* const value = std::get_if<double>(&one.value);
      if (value == nullptr) continue;
      EXPECT_GE(*value, one.minimum) << robot << ": " << one.name;
      EXPECT_LE(*value, one.maximum) << robot << ": " << one.name;
    }
    const double corner = 0.5 * std::hypot(field.length, field.width);
    EXPECT_GT(parameters.room.wall.radius, 1.2 * corner) << "the wall must be beyond the field's corners";
    EXPECT_LE(parameters.room.views.reach, body.neck.yaw);
  }
}

}  // namespace
}  // namespace reorient
