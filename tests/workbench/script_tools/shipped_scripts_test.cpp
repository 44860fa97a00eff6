// SPDX-License-Identifier: MIT
// The scripted tests of the shipped behaviors, and the rules for the shipped files.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/behaviors.h"
#include "engine/script/script_host.h"
#include "tests/paths.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/reference/behavior_page.h"
#include "workbench/script_tools/reference/interface_reference.h"
#include "workbench/script_tools/reference/script_reference.h"

namespace reorient {
namespace {

const std::filesystem::path kScripts = std::filesystem::path(kSourceFolder) / "scripts";

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// If REORIENT_REGENERATE is set in the environment, writes the file instead of comparing it.
void expect_committed(const std::filesystem::path& file, const std::string& generated) {
  if (std::getenv("REORIENT_REGENERATE") != nullptr) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << generated;
  }
  EXPECT_EQ(read(file), generated) << file << " is stale: set REORIENT_REGENERATE=1 and run this test to regenerate it";
}

std::vector<LibraryModule> shipped_libraries() { return library_modules(read_scripts(kScripts)); }

TEST(GeneratedFiles, TheReferenceMatchesTheBindingsAndTheLibraries) {
  expect_committed(std::filesystem::path(kSourceFolder) / "docs" / "script-reference.md",
                   script_reference(shipped_libraries()));
}

TEST(GeneratedFiles, TheEditorAnnotationsMatchTheBindingsAndTheLibraries) {
  expect_committed(kScripts / "annotations" / "reorient.lua", script_annotations(shipped_libraries()));
}

TEST(GeneratedFiles, EachShippedInterfaceHasAPageAndEditorAnnotations) {
  const std::filesystem::path folder = std::filesystem::path(kSourceFolder) / "assets" / "interfaces";
  int interfaces = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const ApplicationInterface declared = load_interface(entry.path());
    expect_committed(folder / (declared.name + ".md"), interface_reference(declared));
    expect_committed(kScripts / "annotations" / (declared.name + ".lua"), interface_annotations(declared));
    ++interfaces;
  }
  EXPECT_GE(interfaces, 1);
}

TEST(EditorAnnotations, OfAnInterfaceHaveTheTypesOfItsDeclarations) {
  const std::string text = read(kScripts / "annotations" / "ball.lua");
  for (const char* const line :
       {"---@class reorient.Input\n---@field ball reorient.Input.ball\n",
        "---@field distance number m, 0 to 20: distance of the ball along the ground\n",
        "---@field position { x: number, y: number } ", "---@field teammates reorient.record.teammates[] ",
        "---@field foot \"left\"|\"right\" foot that kicks\n",
        "---@field direction? number rad, -1 to 1: ", "---@field kick reorient.Action.kick kicks the ball\n",
        "---@class reorient.Action.kick: reorient.Action\n---@operator call(reorient.arguments.kick): nil\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

TEST(InterfacePage, HasNoCellThatEndsItsTable) {
  ApplicationInterface odd;
  odd.name = "odd";
  DeclaredField field;
  field.type = FieldType::text;
  field.description = "a | b\nc";
  field.choices = {"x|y"};
  field.initial.texts = {"x|y"};
  odd.values = {{"v", "a | b\nc", {field}}};
  EXPECT_NE(interface_reference(odd).find("| `input.v` | text |  | `x\\|y` | \"x\\|y\" | a \\| b c |"),
            std::string::npos)
      << interface_reference(odd);
}

TEST(GeneratedFiles, TheLuacheckConfigurationMatchesTheBindings) {
  expect_committed(kScripts / ".luacheckrc", script_luacheck());
}

/// Without a class, an editor does not warn of a function that the table lacks, such as command.flip().
TEST(EditorAnnotations, GiveEachTableAClass) {
  std::istringstream lines(read(kScripts / "annotations" / "reorient.lua"));
  std::string before;
  int tables = 0;
  for (std::string line; std::getline(lines, line); before = line) {
    if (!line.ends_with(" = {}")) continue;
    ++tables;
    EXPECT_TRUE(before.starts_with("---@field") || before.starts_with("---@class") || before.starts_with("---@type"))
        << line;
  }
  EXPECT_GE(tables, 20);
}

TEST(EditorSettings, AtTheTopAreThoseOfTheScripts) {
  std::string top = read(std::filesystem::path(kSourceFolder) / ".luarc.json");
  const auto replace = [&top](const std::string& one, const std::string& other) {
    ASSERT_NE(top.find(one), std::string::npos) << one;
    top.replace(top.find(one), one.size(), other);
  };
  replace("\"scripts/annotations\"", "\"annotations\"");
  replace(",\n  \"workspace.ignoreDir\": [\"build\", \"out\"]", "");
  EXPECT_EQ(top, read(kScripts / ".luarc.json"));
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
    ASSERT_TRUE(std::filesystem::exists(page)) << page << " is missing (expected a page for every behavior)";
    expect_committed(page, with_generated_parts(read(page), *behaviors.host().definitions().front(), own,
                                                behaviors.host().arguments_of(file)));
    ++pages;
  }
  EXPECT_GE(pages, 9);
}

/// The members of each library at run time, by the name of the library.
std::map<std::string, std::set<std::string>> offered_by_libraries() {
  ScriptTexts texts = read_scripts(kScripts);
  std::string probe;
  for (const LibraryModule& module : shipped_libraries()) probe += "require \"" + module.name + "\"\n";
  texts.apply({"scenarios/probe.lua", ScriptText{probe + "scenario \"probe\" {}", ""}});
  ScenarioLanguage language;
  ParameterRegistry parameters;
  ScriptHost host(texts, language, parameters);
  host.load("probe");
  return host.module_fields();
}

void expect_documented(const LibraryMember& member) {
  EXPECT_FALSE(member.doc.description.empty());
  for (const std::string& parameter : member.parameters) {
    const DocTag* const tag = member.doc.parameter(parameter);
    EXPECT_TRUE(tag != nullptr && !tag->type.empty()) << "---@param " << parameter << " TYPE is missing";
  }
  for (const DocTag& tag : member.doc.parameters) {
    EXPECT_EQ(std::count(member.parameters.begin(), member.parameters.end(), tag.name), 1)
        << "---@param " << tag.name << " names an unknown parameter";
  }
  EXPECT_TRUE(member.is_function || !member.doc.type.empty()) << "---@type TYPE is missing";
}

TEST(ShippedScripts, DocumentAllMembersOfTheirLibraries) {
  const std::map<std::string, std::set<std::string>> offered = offered_by_libraries();
  const std::vector<LibraryModule> modules = shipped_libraries();
  ASSERT_GE(modules.size(), 3U);
  for (const LibraryModule& module : modules) {
    EXPECT_FALSE(module.description.empty()) << module.name;
    std::set<std::string> documented;
    for (const LibraryMember& member : module.members) {
      SCOPED_TRACE(module.name + "." + member.name);
      documented.insert(member.name);
      expect_documented(member);
    }
    EXPECT_EQ(documented, offered.at(module.name)) << module.name;
  }
}

TEST(ShippedScripts, PassLuacheck) {
  if (std::system("command -v luacheck >/dev/null") != 0)
    GTEST_SKIP() << "luacheck is not installed (Debian: lua-check)";
  const std::string command = "cd '" + kScripts.string() + "' && luacheck --no-color --quiet . >/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << "run luacheck scripts/ for details";
}

TEST(ShippedScripts, BeginWithADescription) {
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
