// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

enum class Metric { hellinger, ssd3 };

struct FilterParameters {
  int particles = 100;
  double noise = 0.05;
  bool paper = false;
  Metric distance = Metric::hellinger;
};

template <typename Visit>
void describe(FilterParameters& p, Visit&& visit) {
  visit("particles", p.particles, 10, 1000, "", "how many");
  visit("noise", p.noise, 0.0, 1.0, "rad", "how much");
  visit("paper", p.paper, "as in the paper");
  visit("distance", p.distance, {"hellinger", "ssd3"}, "which distance");
}

class Parameters : public ::testing::Test {
 protected:
  Parameters() { registry.bind("view", filter); }

  std::string refusal(const std::string& name, const std::string& text) {
    try {
      registry.set(name, text, ParameterOrigin::command_line);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }
  /// As a file or the command line sets it before it is declared, perhaps.
  void set_early(const std::string& name, const std::string& value, ParameterOrigin origin) {
    registry.set_early({name, value, origin, ""});
  }

  FilterParameters filter;
  ParameterRegistry registry;
};

TEST_F(Parameters, AChangeOfLowerPrecedenceIsRefused) {
  registry.set("view.noise", "0.5", ParameterOrigin::live);
  const ParameterOutcome outcome = registry.change({"view.noise", "0.1", ParameterOrigin::file, ""});
  EXPECT_EQ(outcome.refusal,
            "parameter view.noise is unchanged: a change from 'file' does not replace one from 'live'");
  EXPECT_EQ(filter.noise, 0.5);
}

TEST_F(Parameters, AValueIsWrittenIntoTheBoundStruct) {
  registry.set("view.particles", "30", ParameterOrigin::live);
  registry.set("view.noise", "0.5", ParameterOrigin::live);
  registry.set("view.paper", "true", ParameterOrigin::live);
  registry.set("view.distance", "ssd3", ParameterOrigin::live);
  EXPECT_EQ(filter.particles, 30);
  EXPECT_EQ(filter.noise, 0.5);
  EXPECT_TRUE(filter.paper);
  EXPECT_EQ(filter.distance, Metric::ssd3);
}

TEST_F(Parameters, AreListedWithValueDefaultAndOrigin) {
  registry.set("view.noise", "0.5", ParameterOrigin::command_line);
  const std::vector<Parameter> list = registry.list();
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[1].name, "view.noise");
  EXPECT_EQ(to_text(list[1].value), "0.5");
  EXPECT_EQ(to_text(list[1].default_value), "0.05");
  EXPECT_EQ(to_string(list[1].origin), "command line");
  EXPECT_EQ(range_text(list[1]), "0 to 1 rad");
  EXPECT_EQ(to_string(list[0].origin), "default");
}

TEST_F(Parameters, MistakesAreToldInOneLineWithARemedy) {
  EXPECT_EQ(refusal("view.nosie", "1"), "unknown parameter 'view.nosie' (did you mean 'view.noise'?)");
  EXPECT_EQ(refusal("noise", "1"), "unknown parameter 'noise' (did you mean 'view.noise'?)");
  EXPECT_EQ(refusal("view.noise", "2"), "parameter view.noise: invalid value '2' (expected 0 to 1 rad)");
  EXPECT_EQ(refusal("view.particles", "1.5"),
            "parameter view.particles: invalid value '1.5' (expected a whole number from 10 to 1000)");
  EXPECT_EQ(refusal("view.paper", "maybe"), "parameter view.paper: invalid value 'maybe' (expected true or false)");
  EXPECT_EQ(refusal("view.distance", "helinger"),
            "parameter view.distance: invalid value 'helinger' (expected one of hellinger, ssd3) (did you mean "
            "'hellinger'?)");
  EXPECT_EQ(refusal("view.paper", "\x1B[2J\nno"),
            "parameter view.paper: invalid value '\\x1B[2J no' (expected true or false)");
  EXPECT_EQ(refusal("\x1B[2J\nx", "1"), "unknown parameter '\\x1B[2J x'");
  for (const char* text : {"", "nan", "inf", "-inf", "1e999", "0x1", "1 ", " 1", "1,5", "--1", "1e"}) {
    EXPECT_NE(refusal("view.noise", text), "accepted") << text;
  }
  EXPECT_EQ(filter.noise, 0.05);
}

TEST_F(Parameters, AValueMayBeSetBeforeItsDeclaration) {
  set_early("late.x", "0.25", ParameterOrigin::command_line);
  double x = 0.0;
  registry.declare({"late.x", ParameterKind::real, 0.5, 0.0, 1.0, "", "x", {}},
                   [&](const ParameterValue& value) { x = std::get<double>(value); });
  EXPECT_EQ(x, 0.25);
}

TEST_F(Parameters, AChangeReturnsItsResult) {
  const ParameterOutcome taken = registry.change({"view.noise", "0.25", ParameterOrigin::live, ""});
  EXPECT_EQ(taken.value, "0.25");
  EXPECT_EQ(taken.refusal, "");
  const ParameterOutcome refused = registry.change({"view.noise", "25", ParameterOrigin::live, ""});
  EXPECT_EQ(refused.value, "0.25");
  EXPECT_NE(refused.refusal.find("expected 0 to 1 rad"), std::string::npos);
  const ParameterOutcome unknown = registry.change({"view.noize", "0.25", ParameterOrigin::live, ""});
  EXPECT_EQ(unknown.value, "");
  EXPECT_NE(unknown.refusal.find("did you mean 'view.noise'"), std::string::npos);
}

TEST_F(Parameters, AChangeToTheDefaultFollowsALaterDefault) {
  const auto declared = [&](double value) {
    registry.declare_for("a.lua", {{"a.x", ParameterKind::real, value, 0.0, 1.0, "", "x", {}}});
  };
  declared(0.5);
  EXPECT_EQ(registry.change({"a.x", "0.75", ParameterOrigin::live, ""}).value, "0.75");
  declared(0.25);
  EXPECT_EQ(registry.change({"a.x", "", ParameterOrigin::default_value, ""}).value, "0.25");
  EXPECT_EQ(registry.find("a.x")->origin, ParameterOrigin::default_value);
  EXPECT_TRUE(registry.overrides().empty());
  declared(0.125);
  EXPECT_EQ(std::get<double>(registry.value("a.x")), 0.125);
  EXPECT_NE(registry.change({"a.y", "", ParameterOrigin::default_value, ""}).refusal, "");
}

TEST_F(Parameters, ARefusalContainsThePositionOfTheValue) {
  try {
    registry.set_early({"view.noise", "25", ParameterOrigin::file, "team.toml:3"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("team.toml:3: parameter view.noise: invalid value '25'"));
  }
}

TEST_F(Parameters, AFileDoesNotReplaceAValueOfTheCommandLine) {
  registry.set("view.noise", "0.9", ParameterOrigin::command_line);
  registry.set("view.noise", "0.1", ParameterOrigin::file);
  EXPECT_EQ(filter.noise, 0.9);
  registry.set("view.noise", "0.2", ParameterOrigin::live);
  EXPECT_EQ(filter.noise, 0.2);
}

TEST_F(Parameters, ThereIsOneZero) {
  set_early("view.noise", "-0.0", ParameterOrigin::file);
  EXPECT_EQ(to_text(registry.value("view.noise")), "0");
}

TEST_F(Parameters, ANameCannotBeDeclaredTwice) { EXPECT_THROW(registry.bind("view", filter), std::runtime_error); }

RC_GTEST_PROP(ParameterText, ANumberIsReadBackAsItWasWritten, (double number)) {
  const ParameterDeclaration declaration{"x", ParameterKind::real, 0.0, -1e300, 1e300, "", "", {}};
  RC_PRE(std::abs(number) <= 1e300);
  RC_ASSERT(std::get<double>(parse_parameter(declaration, to_text(number))) == number);
}

RC_GTEST_PROP(EditDistance, IsSymmetricAndZeroForTheSame, (const std::string& left, const std::string& right)) {
  RC_ASSERT(edit_distance(left, right) == edit_distance(right, left));
  RC_ASSERT(edit_distance(left, left) == 0);
  RC_ASSERT((edit_distance(left, right) == 0) == (left == right));
}

TEST(NearestName, PrefersSwappedLettersAndAcceptsAnAbbreviation) {
  const std::vector<std::string> known{"set", "test", "flip_pose", "flip_posture"};
  EXPECT_EQ(nearest_name("tset", known), "test");
  EXPECT_EQ(nearest_name("flip", known), "flip_pose");
  EXPECT_EQ(nearest_name("fl", known), std::nullopt);
  EXPECT_EQ(nearest_name("purge", known), std::nullopt);
}

TEST(Utf8, TextKeepsItsLinesAndTabsOnly) {
  EXPECT_EQ(as_text("a\tb \n\x1B[2J\r\n\xFF"), "a\tb \n\\x1B[2J\\x0D\n\\xFF");
  EXPECT_EQ(as_text(""), "");
}

TEST(Utf8, AByteOrderMarkIsRemovedOnceAtTheBeginning) {
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBF\xEF\xBB\xBFx"), "\xEF\xBB\xBFx");
  EXPECT_EQ(without_byte_order_mark("x\xEF\xBB\xBF"), "x\xEF\xBB\xBF");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB"), "\xEF\xBB");
}

TEST(EditDistance, ASwapOfAdjacentLettersCountsOnce) { EXPECT_EQ(edit_distance("wathcing", "watching"), 1); }

}  // namespace
}  // namespace reorient
