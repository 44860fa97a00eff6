// SPDX-License-Identifier: MIT
// The check has no findings in correct scripts: generated ones, the shipped ones, and those of the guide.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "engine/script/behaviors.h"
#include "engine/script/script_error.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/script_tools/script_generator.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/check/script_check.h"

namespace reorient {
namespace {

const std::filesystem::path kProject = kSourceFolder;

/// REORIENT_GENERATED_SCRIPTS in the environment sets their number.
std::uint64_t requested_scripts() {
  const char* const requested = std::getenv("REORIENT_GENERATED_SCRIPTS");
  return requested != nullptr ? std::strtoull(requested, nullptr, 10) : 300;
}

/// All errors of two seconds in which the robot stands, falls, and is penalized.
std::string errors_of(Behaviors& behaviors) {
  std::string errors;
  World world;
  for (int frame = 0; frame < 60; ++frame) {
    world.time_step = 1.0 / 30.0;
    world.time = frame / 30.0;
    world.frame = static_cast<std::uint64_t>(frame);
    world.posture = frame / 10 % 2 == 0 ? Posture::upright : Posture::lying;
    world.referee.penalized = frame / 15 % 2 == 1;
    world.confidence.current = frame % 7 / 7.0;
    behaviors.tick(world);
    for (const FaultRecord& fault : behaviors.said().faults) errors += fault.fault.text() + "\n";
  }
  return errors;
}

TEST(GeneratedScripts, AreValidAndGiveNoFinding) {
  constexpr std::uint64_t kTogether = 50;
  const std::uint64_t count = requested_scripts();
  for (std::uint64_t first = 0; first < count; first += kTogether) {
    const std::uint64_t end = std::min(first + kTogether, count);
    const TemporaryFolder folder;
    for (std::uint64_t i = first; i < end; ++i)
      folder.write("behaviors/" + generated_name(i) + ".lua", generated_script(i));
    folder.write("behaviors/flag.lua", "behavior \"flag\" { state \"a\" { publishes = \"generated_flag\" } }\n");
    for (const Finding& finding : check_scripts(folder.path(), {}).findings) ADD_FAILURE() << finding.text();
    const ScriptTexts texts = read_scripts(folder.path());
    for (std::uint64_t i = first; i < end; ++i) {
      ParameterRegistry parameters;
      Behaviors behaviors(texts, parameters);
      ASSERT_NO_THROW(behaviors.host().load(generated_name(i))) << generated_script(i);
      ASSERT_EQ(errors_of(behaviors), "") << generated_script(i);
    }
    if (HasFailure()) return;
  }
}

/// Writes the complete scripts of a page, which are in fences "```lua path/of/the/file.lua".
void write_scripts_of(const std::filesystem::path& page, const TemporaryFolder& folder) {
  std::ifstream in(page);
  std::string file;
  std::string text;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```lua scripts/")) {
      file = line.substr(std::string("```lua scripts/").size());
      text.clear();
    } else if (line == "```" && !file.empty()) {
      folder.write(file, text);
      file.clear();
    } else {
      text += line + "\n";
    }
  }
}

TEST(ShippedScripts, PassTheCheckWithoutAWarning) {
  const CheckResult result = check_scripts(kProject / "scripts", {});
  EXPECT_GE(result.files, 30);
  for (const Finding& finding : result.findings) ADD_FAILURE() << finding.text();
}

TEST(GuideScripts, PassTheCheckWithoutAWarning) {
  const TemporaryFolder folder;
  std::filesystem::copy(kProject / "scripts", folder.path(), std::filesystem::copy_options::recursive);
  const int shipped = check_scripts(folder.path(), {}).files;
  write_scripts_of(kProject / "docs" / "first-behavior.md", folder);
  const CheckResult result = check_scripts(folder.path(), {});
  EXPECT_GE(result.files, shipped + 4);
  for (const Finding& finding : result.findings) ADD_FAILURE() << finding.text();
}

}  // namespace
}  // namespace reorient
