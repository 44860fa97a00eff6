// SPDX-License-Identifier: MIT
// Values for modules that are not loaded.
#include "program/parameter_modules.h"

#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include "program/former_names.h"

namespace reorient {
namespace {

class ParameterModulesTest : public ::testing::Test {
 protected:
  ParameterModulesTest() {
    Parameter lead;
    lead.name = "orientation.lingering";
    modules.parameters = {lead};
    modules.loaded = {"orientation", "silent"};
    modules.anywhere = {"orientation", "silent", "goal_search", "body"};
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log)));
    spdlog::set_pattern("%v");
  }
  ~ParameterModulesTest() override { spdlog::set_default_logger(before); }

  ParameterChange in_file(const std::string& name, const std::string& value = "1") const {
    return {name, value, ParameterOrigin::file, "team.toml:7"};
  }
  std::string refusal(const ParameterChange& change) const {
    try {
      kept_for_others({change}, modules);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }

  ParameterModules modules;
  std::ostringstream log;
  std::shared_ptr<spdlog::logger> before = spdlog::default_logger();
};

TEST_F(ParameterModulesTest, KeepsValuesForModulesOfOtherRuns) {
  const std::vector<ParameterChange> kept = kept_for_others(
      {in_file("orientation.lingering"), in_file("goal_search.speed", "2"), in_file("goal_search.speed", "3")},
      modules);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].name, "goal_search.speed");
  EXPECT_EQ(kept[0].value, "3") << "the last one of a name holds";
  EXPECT_EQ(log.str(), "");
}

TEST_F(ParameterModulesTest, WarnsOnceOfAnUnknownModule) {
  EXPECT_EQ(kept_for_others({in_file("goal_saerch.speed"), in_file("goal_saerch.time")}, modules).size(), 2u);
  EXPECT_EQ(
      log.str(),
      "team.toml:7: unknown module 'goal_saerch' (did you mean 'goal_search'?); its values are saved but not used\n");
}

TEST_F(ParameterModulesTest, WarnsOfAFormerNameAndLeavesItOut) {
  EXPECT_TRUE(kept_for_others({in_file("room_status.asymmetry", "0.6")}, modules).empty());
  EXPECT_EQ(log.str(),
            "team.toml:7: parameter 'room_status.asymmetry' is no longer used: 'room_status.separability', a "
            "probability, replaces it\n");
}

TEST_F(ParameterModulesTest, WarnsOnceOfAFormerFieldInAFileThatIsLoaded) {
  ScriptTexts scripts("team");
  const std::string behavior =
      "behavior \"mine\" { update = function() return confidence.asymmetry, confidence.asymmetry end }";
  scripts.apply({"behaviors/mine.lua", ScriptText{behavior, ""}});
  scripts.apply({"behaviors/other.lua", ScriptText{"-- confidence.asymmetry_of_mine", ""}});
  scripts.apply({"behaviors/unused.lua", ScriptText{"-- confidence.asymmetry", ""}});
  warn_of_former_fields(scripts, {"behaviors/mine.lua", "behaviors/other.lua", "behaviors/gone.lua"});
  EXPECT_EQ(log.str(), "team/behaviors/mine.lua: confidence.asymmetry is a former name: use confidence.separability\n");
}

TEST_F(ParameterModulesTest, RefusesUnknownParametersOfLoadedModules) {
  EXPECT_EQ(refusal(in_file("orientation.lingring")),
            "team.toml:7: unknown parameter 'orientation.lingring' (did you mean "
            "'orientation.lingering'?)");
  EXPECT_NE(refusal(in_file("silent.lead")), "accepted");
  EXPECT_NE(refusal(in_file("lead")), "accepted") << "a name without a module";
}

TEST_F(ParameterModulesTest, RefusesAssignmentsWithoutEffectOnTheCommandLine) {
  EXPECT_NE(refusal({"goal_search.speed", "1", ParameterOrigin::command_line, ""}), "accepted");
}

}  // namespace
}  // namespace reorient
