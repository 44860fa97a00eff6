// The scripted tests of the shipped behaviours, and what the shipped files must look like.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/behaviors.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/reference/behavior_page.h"
#include "workbench/script_tools/reference/script_reference.h"

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

void expect_documented_once(const ScriptLanguage& language) {
  std::set<std::string> names;
  for (const WorldField& field : language.world()) {
    EXPECT_TRUE(names.insert(field.full_name()).second) << field.full_name();
    EXPECT_FALSE(field.description.empty()) << field.full_name();
  }
  for (const ScriptFunction& function : language.functions()) {
    EXPECT_TRUE(names.insert(function.table + "." + function.name).second) << function.name;
    EXPECT_FALSE(function.description.empty()) << function.name;
    for (const ArgumentDoc& argument : function.arguments) EXPECT_FALSE(argument.type.empty()) << function.name;
  }
}

TEST(GeneratedFiles, EveryFieldAndFunctionIsDocumentedOnce) {
  expect_documented_once(BehaviorLanguage());
  expect_documented_once(ScenarioLanguage());
}

TEST(GeneratedFiles, ThePagesOfBehaviorsShowTheirStatesAndParameters) {
  const ScriptTexts texts = read_scripts(kScripts);
  int pages = 0;
  for (const std::string& file : texts.in_folder("behaviors")) {
    ParameterRegistry registry;
    Behaviors behaviors(texts, registry);
    behaviors.host().load(file);
    const std::string prefix = std::filesystem::path(file).stem().string() + ".";
    std::vector<ParameterDeclaration> own;
    for (const Parameter& parameter : registry.list()) {
      if (parameter.name.starts_with(prefix)) own.push_back(parameter);
    }
    const std::filesystem::path page = (kScripts / file).replace_extension(".md");
    ASSERT_TRUE(std::filesystem::exists(page)) << page << " is missing: every behaviour has a page beside it";
    expect_committed(page, with_generated_parts(read(page), *behaviors.host().definitions().front(), own));
    ++pages;
  }
  EXPECT_GE(pages, 9);
}

TEST(ShippedScripts, PassLuacheck) {
  if (std::system("command -v luacheck >/dev/null") != 0)
    GTEST_SKIP() << "luacheck is not installed (Debian: lua-check)";
  const std::string command = "cd '" + kScripts.string() + "' && luacheck --no-color --quiet . >/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << "luacheck scripts/ tells more";
}

TEST(ShippedScripts, BeginWithACommentThatSaysWhatTheyDo) {
  int files = 0;
  for (const char* folder : {"behaviors", "lib", "scenarios", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kScripts / folder)) {
      if (entry.path().extension() != ".lua") continue;
      EXPECT_TRUE(read(entry.path()).starts_with("--- ")) << entry.path();
      ++files;
    }
  }
  EXPECT_GE(files, 30);
}

}  // namespace
}  // namespace reorient
