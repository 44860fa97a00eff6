// The scripted tests of the shipped behaviours, and what the shipped files must look like.
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/script/language/script_actions.h"
#include "engine/script/language/world_fields.h"
#include "engine/script/script_reference.h"
#include "engine/script/test_runner.h"

namespace reorient {
namespace {

const std::filesystem::path kScripts = std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts";

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// REORIENT_REGENERATE in the environment writes the file instead of comparing it.
void expect_committed(const std::filesystem::path& file, const std::string& generated) {
  if (std::getenv("REORIENT_REGENERATE") != nullptr) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << generated;
  }
  EXPECT_EQ(read(file), generated) << file << " is stale: set REORIENT_REGENERATE=1 and run this test to write it anew";
}

TEST(GeneratedFiles, TheReferenceIsThatOfTheBindings) {
  expect_committed(std::filesystem::path(REORIENT_SOURCE_DIR) / "docs" / "script-reference.md", script_reference());
}

TEST(GeneratedFiles, TheEditorAnnotationsAreThoseOfTheBindings) {
  expect_committed(kScripts / "annotations" / "reorient.lua", script_annotations());
}

TEST(GeneratedFiles, TheLuacheckConfigurationIsThatOfTheBindings) {
  expect_committed(kScripts / ".luacheckrc", script_luacheck());
}

TEST(GeneratedFiles, EveryFieldAndFunctionIsDocumentedOnce) {
  std::set<std::string> names;
  for (const WorldField& field : world_fields()) {
    EXPECT_TRUE(names.insert(field.full_name()).second) << field.full_name();
    EXPECT_FALSE(field.sentence.empty()) << field.full_name();
  }
  for (const ScriptFunction& function : script_functions()) {
    EXPECT_TRUE(names.insert(function.table + "." + function.name).second) << function.name;
    EXPECT_FALSE(function.sentence.empty()) << function.name;
    for (const ArgumentDoc& argument : function.arguments) EXPECT_FALSE(argument.type.empty()) << function.name;
  }
}

TEST(ShippedScripts, BeginWithACommentThatSaysWhatTheyDo) {
  int files = 0;
  for (const char* folder : {"behaviors", "lib", "scenarios", "tests"}) {
    for (const auto& entry : std::filesystem::directory_iterator(kScripts / folder)) {
      EXPECT_TRUE(read(entry.path()).starts_with("--- ")) << entry.path();
      ++files;
    }
  }
  EXPECT_GE(files, 10);
}

TEST(ShippedScripts, PassTheirOwnTests) {
  std::ostringstream out;
  const TestSummary summary = run_script_tests({}, kScripts, out);
  EXPECT_EQ(summary.failed, 0) << out.str();
  EXPECT_GE(summary.passed, 20);
}

}  // namespace
}  // namespace reorient
