// What a person types while the robot runs.
#include "program/run/live_console.h"

#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/engine/script/script_fixture.h"
#include "workbench/files/parameter_file.h"

namespace reorient {
namespace {

class LiveConsoleTest : public ScriptTest {
 protected:
  LiveConsoleTest() {
    load("lamp", R"(param { level = { 0.5, range = { 0, 1 }, unit = "m", doc = "how bright" } }
behavior "lamp" { initial = "off", state "off" {} })");
    tick();
    if (pipe(ends_) != 0) ADD_FAILURE() << "no pipe";
  }
  ~LiveConsoleTest() override {
    close(ends_[0]);
    close_writing();
  }

  void close_writing() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  void type(const std::string& text) const {
    ASSERT_EQ(write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  std::string answer(const std::string& line) { return obey_line(line, parameters, host()); }
  std::string poll(LiveConsole& console) {
    std::ostringstream out;
    console.poll(parameters, host(), out);
    return out.str();
  }

  int ends_[2] = {-1, -1};
};

TEST_F(LiveConsoleTest, SetsAParameter) {
  EXPECT_EQ(answer("set lamp.level 0.75"), "  lamp.level = 0.75\n");
  EXPECT_EQ(std::get<double>(parameters.value("lamp.level")), 0.75);
  EXPECT_EQ(parameters.find("lamp.level")->origin, ParameterOrigin::live);
}

TEST_F(LiveConsoleTest, TellsWhatIsWrongAndChangesNothing) {
  EXPECT_NE(answer("set lamp.level 7").find("0 to 1"), std::string::npos);
  EXPECT_NE(answer("set lamp.levle 0.7").find("lamp.level"), std::string::npos);
  EXPECT_NE(answer("set lamp.level").find("set NAME VALUE"), std::string::npos);
  EXPECT_NE(answer("sett lamp.level 1").find("did you mean 'set'"), std::string::npos);
  EXPECT_NE(answer("save /no/such/folder/file").find("cannot write"), std::string::npos);
  EXPECT_NE(answer("states now").find("there is no command"), std::string::npos);
  EXPECT_EQ(answer("   "), "");
  EXPECT_EQ(std::get<double>(parameters.value("lamp.level")), 0.5);
}

TEST_F(LiveConsoleTest, ListsParametersAndStates) {
  answer("set lamp.level 0.25");
  EXPECT_EQ(answer("params lamp"), "  lamp.level = 0.25  (0 to 1 m; live) how bright\n");
  EXPECT_NE(answer("params nothing").find("no parameter"), std::string::npos);
  EXPECT_NE(answer("states").find("lamp"), std::string::npos);
  EXPECT_NE(answer("help").find("save FILE"), std::string::npos);
}

TEST_F(LiveConsoleTest, SavesWhatWasTuned) {
  answer("set lamp.level 0.25");
  const std::filesystem::path file = folder.path() / "tuned.toml";
  EXPECT_NE(answer("save " + file.string()).find("written"), std::string::npos);
  ParameterRegistry later;
  load_parameters(later, file);
  ScriptHost again(folder.path(), later);
  again.load_behavior("lamp");
  EXPECT_EQ(std::get<double>(later.value("lamp.level")), 0.25);
}

TEST_F(LiveConsoleTest, NeverWaitsForALine) {
  LiveConsole console(ends_[0]);
  EXPECT_EQ(poll(console), "");
  type("set lamp.le");
  EXPECT_EQ(poll(console), "");
  type("vel 1\nset lamp");
  EXPECT_EQ(poll(console), "  lamp.level = 1\n");
  type(".level 0\n");
  EXPECT_EQ(poll(console), "  lamp.level = 0\n");
}

TEST_F(LiveConsoleTest, OpensAPromptOnAnEmptyLineAndClosesItOnTheNext) {
  LiveConsole console(ends_[0]);
  type("\n");
  EXPECT_EQ(poll(console), "> ");
  EXPECT_TRUE(console.is_open());
  type("set lamp.level 1\n");
  EXPECT_EQ(poll(console), "  lamp.level = 1\n> ");
  type("\n");
  poll(console);
  EXPECT_FALSE(console.is_open());
}

TEST_F(LiveConsoleTest, GoesOnWhenNobodyTypesAnyMore) {
  LiveConsole console(ends_[0]);
  type("set lamp.level 1\n");
  close_writing();
  EXPECT_EQ(poll(console), "  lamp.level = 1\n");
  EXPECT_EQ(poll(console), "");
  EXPECT_EQ(poll(console), "");
  EXPECT_FALSE(console.wants_to_quit());
}

TEST_F(LiveConsoleTest, EndsTheRunWhenAsked) {
  LiveConsole console(ends_[0]);
  type("quit\nset lamp.level 1\n");
  poll(console);
  EXPECT_TRUE(console.wants_to_quit());
}

TEST_F(LiveConsoleTest, DropsALineThatHasNoEnd) {
  LiveConsole console(ends_[0]);
  std::string said;
  for (int i = 0; i < 10; ++i) {
    type(std::string(3000, 'x'));
    said += poll(console);
  }
  EXPECT_EQ(said, "");
  type("\nset lamp.level 1\n");
  EXPECT_EQ(poll(console), "  that line is too long\n  lamp.level = 1\n");
}

TEST_F(LiveConsoleTest, SurvivesBytesThatAreNoText) {
  LiveConsole console(ends_[0]);
  type(std::string("set \0\x80\xFF 1\n", 11));
  EXPECT_NE(poll(console), "");
}

}  // namespace
}  // namespace reorient
