// The scripted tests of the shipped behaviours, and what the shipped files must look like.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/script/language/script_actions.h"
#include "engine/script/language/world_fields.h"
#include "engine/script/script_host.h"
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

TEST(GeneratedFiles, EveryFieldAndFunctionIsDocumentedOnce) {
  std::set<std::string> names;
  for (const WorldField& field : world_fields()) {
    EXPECT_TRUE(names.insert(field.full_name()).second) << field.full_name();
    EXPECT_FALSE(field.description.empty()) << field.full_name();
  }
  for (const ScriptFunction& function : script_functions()) {
    EXPECT_TRUE(names.insert(function.table + "." + function.name).second) << function.name;
    EXPECT_FALSE(function.description.empty()) << function.name;
    for (const ArgumentDoc& argument : function.arguments) EXPECT_FALSE(argument.type.empty()) << function.name;
  }
}

TEST(GeneratedFiles, ThePagesOfBehaviorsShowTheirStatesAndParameters) {
  int pages = 0;
  for (const std::string& file : scripts_in(kScripts, "behaviors")) {
    ParameterRegistry registry;
    ScriptHost host(kScripts, registry);
    host.load_behavior((kScripts / file).string());
    const std::string prefix = std::filesystem::path(file).stem().string() + ".";
    std::vector<ParameterDeclaration> own;
    for (const Parameter& parameter : registry.list()) {
      if (parameter.name.starts_with(prefix)) own.push_back(parameter);
    }
    const std::filesystem::path page = (kScripts / file).replace_extension(".md");
    ASSERT_TRUE(std::filesystem::exists(page)) << page << " is missing: every behaviour has a page beside it";
    expect_committed(page, with_generated_parts(read(page), *host.definitions().front(), own));
    ++pages;
  }
  EXPECT_GE(pages, 8);
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
    for (const std::string& file : scripts_in(kScripts, folder)) {
      EXPECT_TRUE(read(kScripts / file).starts_with("--- ")) << file;
      ++files;
    }
  }
  EXPECT_GE(files, 29);
}

}  // namespace
}  // namespace reorient
