// SPDX-License-Identifier: MIT
// Interfaces of applications from TOML texts, and the line that a mistake gets.
#include "workbench/files/interface_file.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/paths.h"

namespace reorient {
namespace {

constexpr const char* kGood = R"([values.ball.x]
type = "number"
unit = "m"
range = [-10, 10.0]
default = 1
lasts = 0.5
description = "where the ball is"

[values.mode]
type = "text"
choices = ["fast", "safe"]
description = "how to play"

[values.goal]
type = "pose"
default = [1, 2, 0.5]
description = "where to go"

[values.mates]
type = "list"
most = 4
description = "the others"
[values.mates.record.player]
type = "integer"
range = [1, 20]
description = "number"

[actions.kick]
description = "kicks"
takes = 2
reports = true
[actions.kick.arguments.foot]
type = "text"
description = "which"
[actions.kick.arguments.hard]
type = "boolean"
default = true
description = "how"
)";

TEST(InterfaceFile, IsReadWithDefaults) {
  const ApplicationInterface declared = parse_interface(kGood, "folder/team.toml");
  EXPECT_EQ(declared.name, "team");
  ASSERT_EQ(declared.values.size(), 4u);
  const DeclaredValue& ball = declared.values[0];
  EXPECT_EQ(ball.name, "ball.x");
  EXPECT_EQ(ball.lasts, 0.5);
  EXPECT_EQ(ball.fields.at(0).initial.numbers, std::vector<double>{1.0});
  EXPECT_EQ(ball.fields[0].minimum, -10.0);
  EXPECT_EQ(declared.values[1].fields.at(0).initial.numbers, (std::vector<double>{1.0, 2.0, 0.5})) << "goal";
  EXPECT_EQ(declared.values[2].most, 4u) << "mates";
  EXPECT_EQ(declared.values[2].fields.at(0).initial.numbers, std::vector<double>{1.0}) << "nearest to 0 in the range";
  EXPECT_TRUE(std::isinf(declared.values[2].lasts));
  EXPECT_EQ(declared.values[3].fields.at(0).initial.texts, std::vector<std::string>{"fast"})
      << "mode: the first choice";
  ASSERT_EQ(declared.actions.size(), 1u);
  EXPECT_TRUE(declared.actions[0].reports);
  EXPECT_TRUE(declared.actions[0].arguments.at(0).is_required);
  EXPECT_FALSE(declared.actions[0].arguments.at(1).is_required);
}

std::string mistake_of(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  try {
    parse_interface(text, "team.toml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no mistake";
}

TEST(InterfaceFile, NamesLineAndMistake) {
  const struct {
    const char* from;
    const char* to;
    const char* message;
  } cases[] = {
      {"type = \"number\"", "type = \"nummer\"",
       "team.toml:2: type: expected number, integer, boolean, text, point, pose or list, found 'nummer'"},
      {"unit = \"m\"", "unti = \"m\"", "team.toml:3: unknown key 'unti' (did you mean 'unit'?)"},
      {"range = [-10, 10.0]", "range = [1]", "team.toml:4: range: expected a list of 2 numbers, found [1]"},
      {"range = [-10, 10.0]", "range = [5, 1]", "team.toml:1: value 'ball.x': expected a range from low to high"},
      {"default = 1", "default = 99", "value 'ball.x': default: expected a number from -10 to 10 m, found 99"},
      {"default = 1", "default = \"a\"", "team.toml:5: default: expected a number"},
      {"lasts = 0.5", "lasts = 0", "value 'ball.x': lasts: expected more than 0 s, found 0"},
      {"description = \"where the ball is\"", "", "team.toml:1: expected the key 'description', found none"},
      {"choices = [\"fast\", \"safe\"]", "choices = 3", "choices: expected a list of texts"},
      {"default = [1, 2, 0.5]", "default = [1, 2]", "default: expected a list of 3 numbers, found [1, 2]"},
      {"most = 4", "most = 400", "most: expected a whole number from 1 to 64, found 400"},
      {"[values.mates.record.player]", "[values.mates.records.player]",
       "unknown key 'records' (did you mean 'record'?)"},
      {"[values.goal]", "[values.a.b.c]", "values.a.b: expected the key 'type'"},
      {"[values.goal]", "[values.age.x]", "age is a name of the program"},
      {"takes = 2", "takes = -1", "takes: expected a number from 0 to 3600, found -1"},
      {"reports = true", "reports = 1", "reports: expected true or false, found 1"},
      {"[values.mode]", "[valeus.mode]", "unknown key 'valeus' (did you mean 'values'?)"},
      {"default = true", "default = 1", "default: expected true or false, found 1"},
      {"[values.mode]", "values.mode = 3\n[values.mode]", "team.toml:"},
      {"[values.mode]", "[values.mode", "team.toml:"},
  };
  for (const auto& [from, to, message] : cases) {
    const std::string found = mistake_of(kGood, from, to);
    EXPECT_NE(found.find(message), std::string::npos) << to << "\n" << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
}

TEST(InterfaceFile, ShippedOnesAreReadAndMerged) {
  const std::vector<ApplicationInterface> shipped = known_interfaces(std::filesystem::path(kSourceFolder) / "scripts");
  ASSERT_FALSE(shipped.empty());
  std::vector<ApplicationInterface> with_conflict = shipped;
  with_conflict.push_back(parse_interface("[values.ball]\ntype = \"number\"\ndescription = \"a conflict\"\n", "other"));
  with_conflict.push_back(shipped.front());
  const ApplicationInterface all = merged(with_conflict);
  EXPECT_EQ(mistake_in(all), "");
  EXPECT_EQ(all.values.size(), merged(shipped).values.size());
}

}  // namespace
}  // namespace reorient
