// SPDX-License-Identifier: MIT
// The services that list, check and write scripts, with hostile requests.
#include "workbench/views/live/script_services.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/temporary_folder.h"
#include "workbench/files/input_file.h"

namespace reorient::live {
namespace {

using nlohmann::json;

constexpr const char* kGood = R"(behavior "walk" {
  initial = "on",
  on = { enter = function() end, transitions = {} },
})";
constexpr const char* kFile = "behaviors/walk.lua";

class ServedScripts : public ::testing::Test {
 protected:
  ServedScripts() {
    folder.write("scripts/behaviors/walk.lua", kGood);
    folder.write("scripts/lib/steps.lua", "return {}\n");
    folder.write("scripts/tests/walk_test.lua", "");
    folder.write("scripts/other/notes.lua", "");
    folder.write("scripts/behaviors/notes.txt", "text");
    folder.write("outside.lua", "outside");
  }
  json call(Service service, const json& request) const {
    return json::parse(services.answer(service, request.dump()).value());
  }
  /// The one line of a refusal.
  std::string refusal(Service service, const std::string& payload) const {
    try {
      services.answer(service, payload);
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_LT(std::string(error.what()).size(), 500u);
      return error.what();
    }
    ADD_FAILURE() << "expected a refusal of " << payload.substr(0, 200);
    return "";
  }
  json findings(const std::string& file, const std::string& text) const {
    return call(Service::check_script, {{"file", file}, {"text", text}})["findings"];
  }
  std::string on_disk(const std::string& file = kFile) const {
    return read_input(folder.path() / "scripts" / file, "a script");
  }

  TemporaryFolder folder;
  ScriptServices services{folder.path() / "scripts"};
};

TEST_F(ServedScripts, AreListedWithTheirTests) {
  EXPECT_EQ(call(Service::scripts, json::object())["files"],
            json({"behaviors/walk.lua", "lib/steps.lua", "other/notes.lua", "tests/walk_test.lua"}));
  EXPECT_EQ(call(Service::script, {{"file", "tests/walk_test.lua"}})["text"], "");
}

TEST_F(ServedScripts, AreCheckedWithTheTextOfTheEditor) {
  const json found = findings(kFile, "behavior \"walk\" {\n  initial = \"on\",\n  on = {{,\n}");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0]["file"], kFile);
  EXPECT_EQ(found[0]["line"], 3);
  EXPECT_GT(found[0]["column"], 0);
  EXPECT_EQ(found[0]["severity"], "error");
  EXPECT_FALSE(found[0]["message"].get<std::string>().empty());
  EXPECT_EQ(on_disk(), kGood) << "a check writes nothing";
}

TEST_F(ServedScripts, HaveNoFindingsOfOtherFiles) {
  folder.write("scripts/behaviors/broken.lua", "behavior {");
  for (const json& finding : findings(kFile, kGood)) EXPECT_EQ(finding["file"], kFile) << finding;
  EXPECT_EQ(findings("behaviors/broken.lua", "behavior {")[0]["file"], "behaviors/broken.lua");
}

TEST_F(ServedScripts, AreCheckedAsTestsBelowTests) {
  EXPECT_FALSE(findings("tests/walk_test.lua", "test(").empty());
  EXPECT_TRUE(findings("tests/walk_test.lua", "").empty());
}

TEST_F(ServedScripts, HaveABoundedNumberOfFindings) {
  std::string many;
  while (many.size() < 60'000) many += "unknown_name()\n";
  const json found = findings("tests/walk_test.lua", many);
  EXPECT_GT(found.size(), 10u);
  EXPECT_LE(found.size(), 200u);
}

TEST_F(ServedScripts, AreCheckedAlsoIfTheyAreDeepOrLong) {
  const auto repeated = [](const std::string& begin, const std::string& part, const std::string& end) {
    std::string text = begin;
    while (text.size() + part.size() + end.size() < 60'000) text += part;
    return text + end;
  };
  for (const std::string& hostile :
       {repeated("x = ", "(", "1"), repeated("x = ", "{", ""), repeated("x = ", "-", "1"),
        repeated("x = 1", " + 1", ""), repeated("x = 'a'", " .. 'a'", ""), repeated("x = y", ".y", ""),
        repeated("f", "()", ""), repeated("", "do ", ""), repeated("", "function f() ", ""),
        repeated("if a then", " elseif a then", " end"), repeated("x = [", "=", ""),
        repeated("while true do ", " ", "end"), std::string(60'000, '\0'), std::string("while true do end")}) {
    for (const char* file : {kFile, "tests/walk_test.lua"})
      EXPECT_TRUE(findings(file, hostile).is_array()) << file << ": " << hostile.substr(0, 20);
  }
}

TEST_F(ServedScripts, AreCheckedOneAtATime) {
  std::vector<std::thread> viewers;
  std::vector<std::string> answers(4);
  viewers.reserve(answers.size());
  for (std::string& answer : answers) {
    viewers.emplace_back([&] {
      try {
        answer = services.answer(Service::check_script, json{{"file", kFile}, {"text", kGood}}.dump()).value();
      } catch (const std::runtime_error& error) {
        answer = error.what();
      }
    });
  }
  for (std::thread& viewer : viewers) viewer.join();
  int checked = 0;
  for (const std::string& answer : answers) {
    checked += answer.starts_with("{\"findings\":");
    EXPECT_TRUE(answer.starts_with("{\"findings\":") || answer.ends_with("another check is running; try again"))
        << answer;
  }
  EXPECT_GE(checked, 1);
}

TEST_F(ServedScripts, AreSavedIfTheDiskHasTheExpectedText) {
  const json saved = call(Service::save_script, {{"file", kFile}, {"text", "-- \xc3\xa4\n"}, {"expected", kGood}});
  EXPECT_EQ(saved, json({{"file", kFile}, {"saved", true}, {"text", "-- \xc3\xa4\n"}}));
  EXPECT_EQ(on_disk(), "-- \xc3\xa4\n");
  call(Service::save_script, {{"file", "tests/walk_test.lua"}, {"text", "-- a test"}, {"expected", ""}});
  EXPECT_EQ(on_disk("tests/walk_test.lua"), "-- a test");
}

TEST_F(ServedScripts, AreNotSavedOverAnotherEdit) {
  folder.write("scripts/behaviors/walk.lua", "-- another editor");
  const json refused = call(Service::save_script, {{"file", kFile}, {"text", "-- mine"}, {"expected", kGood}});
  EXPECT_EQ(refused, json({{"file", kFile}, {"saved", false}, {"text", "-- another editor"}}));
  EXPECT_EQ(on_disk(), "-- another editor");
}

TEST_F(ServedScripts, AreSavedByOneOfTwoViewersThatBeganWithTheSameText) {
  std::vector<std::thread> viewers;
  std::vector<json> answers(2);
  for (std::size_t i = 0; i < 2; ++i) {
    viewers.emplace_back([&, i] {
      answers[i] =
          call(Service::save_script, {{"file", kFile}, {"text", "-- " + std::to_string(i)}, {"expected", kGood}});
    });
  }
  for (std::thread& viewer : viewers) viewer.join();
  EXPECT_NE(answers[0]["saved"], answers[1]["saved"]);
  EXPECT_EQ(answers[0]["text"], answers[1]["text"]);
}

TEST_F(ServedScripts, AreNeverWrittenOutsideOfTheirFolder) {
  namespace fs = std::filesystem;
  const fs::path scripts = folder.path() / "scripts";
  fs::create_directory(folder.path() / "elsewhere");
  folder.write("elsewhere/far.lua", "outside");
  fs::create_symlink(folder.path() / "outside.lua", scripts / "behaviors/linked.lua");
  fs::create_directory_symlink(folder.path() / "elsewhere", scripts / "behaviors/linked");
  for (const std::string file :
       {"../outside.lua", "behaviors/../../outside.lua", "behaviors/../behaviors/walk.lua", "./behaviors/walk.lua",
        "/etc/passwd", "behaviors/linked.lua", "behaviors/linked/far.lua", "behaviors//walk.lua", "behaviors",
        "behaviors/notes.txt", "behaviors/new.lua", "other/notes.lua", "tests/new_test.lua", "tests/../lib/steps.lua",
        ""}) {
    for (const char* expected : {"outside", "text", "", kGood}) {
      const std::string reason =
          refusal(Service::save_script, json{{"file", file}, {"text", "hostile"}, {"expected", expected}}.dump());
      EXPECT_TRUE(reason.starts_with("save_script: ") || reason.starts_with("unknown script ")) << reason;
    }
  }
  refusal(Service::save_script,
          json{{"file", std::string("behaviors/walk.lua\0.txt", 22)}, {"text", "x"}, {"expected", kGood}}.dump());
  EXPECT_EQ(read_input(folder.path() / "outside.lua", "a file"), "outside");
  EXPECT_EQ(read_input(folder.path() / "elsewhere/far.lua", "a file"), "outside");
  EXPECT_EQ(on_disk("other/notes.lua"), "");
  EXPECT_EQ(on_disk(), kGood);
  EXPECT_FALSE(fs::exists(scripts / "behaviors/new.lua"));
}

TEST_F(ServedScripts, ThatAreNoUtf8AreNotSaved) {
  folder.write("scripts/behaviors/walk.lua", "-- \xff");
  const json shown = call(Service::script, {{"file", kFile}})["text"];
  EXPECT_NE(refusal(Service::save_script, json{{"file", kFile}, {"text", "x"}, {"expected", shown}}.dump())
                .find("expected UTF-8"),
            std::string::npos);
  EXPECT_EQ(on_disk(), "-- \xff");
}

TEST_F(ServedScripts, RefuseHugeTextsAndWrongTypes) {
  const std::string huge(kLargestScript + 1, ' ');
  for (const Service service : {Service::check_script, Service::save_script}) {
    EXPECT_NE(refusal(service, json{{"file", kFile}, {"text", huge}, {"expected", kGood}}.dump()).find("at most 65536"),
              std::string::npos);
    EXPECT_NE(refusal(service, json{{"file", huge}, {"text", ""}, {"expected", ""}}.dump()).find("unknown script"),
              std::string::npos);
    for (const char* payload :
         {"", "{", "[]", "null", "{}", R"({"file":"behaviors/walk.lua"})", R"({"file":3,"text":"","expected":""})",
          R"({"file":"behaviors/walk.lua","text":[],"expected":""})",
          R"({"file":"behaviors/walk.lua","text":null,"expected":""})"})
      EXPECT_NE(refusal(service, payload), "") << payload;
  }
  EXPECT_NE(refusal(Service::save_script, json{{"file", kFile}, {"text", ""}, {"expected", 3}}.dump()), "");
  EXPECT_EQ(on_disk(), kGood);
}

}  // namespace
}  // namespace reorient::live
