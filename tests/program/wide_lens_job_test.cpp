// SPDX-License-Identifier: MIT
// The main job through wide lenses: the robot is placed at its mirrored pose, and corrects its belief.
#include <filesystem>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/program/program_run.h"

namespace reorient {
namespace {

class WideLensJob : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(WideLensJob, EndsRight) {
  const auto& [file, seed] = GetParam();
  const std::string body = (std::filesystem::path(kSourceFolder) / file).string();
  const ProgramRun run = run_reorient({"run", "mirrored_placement", "--body", body, "--seed", std::to_string(seed),
                                       "--width", "160", "--log", "off", "--no-pictures"});
  EXPECT_EQ(run.code, kSuccess) << run.out << run.err;
  EXPECT_NE(run.out.find("belief correct at the end"), std::string::npos) << run.out;
}

constexpr const char* kBodies[] = {"assets/robots/booster-k1.toml", "tests/robots/bodies/fisheye-160.toml"};

INSTANTIATE_TEST_SUITE_P(First, WideLensJob, testing::Combine(testing::ValuesIn(kBodies), testing::Values(1)));
INSTANTIATE_TEST_SUITE_P(NineMore, WideLensJob, testing::Combine(testing::ValuesIn(kBodies), testing::Range(2, 11)));

}  // namespace
}  // namespace reorient
