// SPDX-License-Identifier: MIT
#include "workbench/run/decision_threshold.h"

#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/engine/frame_fixture.h"
#include "tests/paths.h"

namespace reorient {
namespace {

constexpr const char* kDecides = R"(local decision = require "lib.decision"
behavior "tested" { initial = "waiting",
  state "waiting" { { "logging", after = 0.1, because = "it is time" } },
  state "logging" { enter = function()
    log.info(string.format("%.6f %.6f", decision.unconfirmed_threshold(), decision.confirmed_threshold()))
  end } })";

/// A behavior that logs the thresholds of the shipped library.
FrameSetup with_shipped_library() {
  std::ifstream in(std::string(kSourceFolder) + "/scripts/lib/decision.lua");
  FrameSetup setup;
  setup.scripts.apply({"lib/decision.lua", ScriptText{std::string((std::istreambuf_iterator<char>(in)), {}), ""}});
  return setup;
}

/// That of an unconfirmed pose, and that of a confirmed pose.
std::pair<double, double> logged_thresholds(HandFedLoop& loop) {
  for (int i = 0; i < 10; ++i) {
    const FrameRecord& frame = loop.step();
    if (frame.logs.empty()) continue;
    std::size_t end = 0;
    const double unconfirmed = std::stod(frame.logs[0].text, &end);
    return {unconfirmed, std::stod(frame.logs[0].text.substr(end))};
  }
  ADD_FAILURE() << "nothing is logged";
  return {};
}

TEST(DecisionThresholds, AreThoseOfTheShippedLibrary) {
  for (const auto& [name, value] : {std::pair{"decision.false_flips", "0.02"},
                                    {"decision.false_flips", "1"},
                                    {"decision.disturbances", "100"},
                                    {"decision.looks", "3"},
                                    {"decision.least", "7"}}) {
    FrameSetup setup = with_shipped_library();
    setup.parameters = {{name, value, ParameterOrigin::file, ""}};
    HandFedLoop loop(kDecides, std::move(setup));
    const auto [unconfirmed, confirmed] = logged_thresholds(loop);
    EXPECT_NEAR(unconfirmed_threshold(loop.engine->parameters()), unconfirmed, 1e-5) << name << " " << value;
    EXPECT_NEAR(confirmed_threshold(loop.engine->parameters()), confirmed, 1e-5) << name << " " << value;
  }
}

TEST(DecisionThresholds, AreUnknownWithoutTheLibrary) {
  EXPECT_EQ(unconfirmed_threshold({}), 0.0);
  EXPECT_EQ(confirmed_threshold({}), 0.0);
  const HandFedLoop loop(kIdle);
  EXPECT_EQ(unconfirmed_threshold(loop.engine->parameters()), 0.0);
}

TEST(DecisionThreshold, FollowsChangesDuringARun) {
  HandFedLoop loop(kDecides, with_shipped_library());
  loop.wanted = Topics{DecisionThreshold::kTopic};
  DecisionThreshold threshold;
  threshold.observe(loop.step());
  EXPECT_NEAR(threshold.value(), 5.52, 0.01);
  loop.inputs.parameter_changes = {{"decision.least", "7", ParameterOrigin::live, ""}};
  threshold.observe(loop.step());
  EXPECT_EQ(threshold.value(), 7.0);
  threshold.observe(loop.step());
  EXPECT_EQ(threshold.value(), 7.0);
}

TEST(DecisionThreshold, IsUnknownWithoutItsTopic) {
  HandFedLoop loop(kDecides, with_shipped_library());
  DecisionThreshold threshold;
  threshold.observe(loop.step());
  EXPECT_EQ(threshold.value(), 0.0);
}

}  // namespace
}  // namespace reorient
