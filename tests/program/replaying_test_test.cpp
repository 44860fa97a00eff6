// SPDX-License-Identifier: MIT
// Scripted tests that replay a recording, and their creation from a recording.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "program/recording/test_replay.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "workbench/files/input_file.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/recording_file.h"
#include "workbench/script_tools/testing/test_runner.h"

namespace reorient {
namespace {

/// A copy of the shipped scripts without their tests, but for the recording.
class ReplayingTest : public testing::Test {
 protected:
  ReplayingTest() {
    copy_scripts(folder_.path());
    for (const auto& entry : std::filesystem::directory_iterator(scripts() / "tests")) {
      if (entry.is_regular_file()) std::filesystem::remove(entry.path());
    }
  }

  std::filesystem::path scripts() const { return folder_.path() / "scripts"; }
  ProgramRun run_test(const std::string& text) {
    folder_.write("scripts/tests/a_test.lua", "test(\"it\", function()\n" + text + "\nend)\n");
    return run_reorient({"test", "--scripts", scripts().string()});
  }
  void edit(const std::string& script, const std::string& from, const std::string& to) {
    std::string edited = read_input(scripts() / script, "a file");
    const std::size_t at = edited.find(from);
    ASSERT_NE(at, std::string::npos) << script << " does not contain " << from;
    folder_.write("scripts/" + script, edited.replace(at, from.size(), to));
  }

  TemporaryFolder folder_;
};

TEST_F(ReplayingTest, RunsThePresentScripts) {
  const std::string test = R"(
    replay "recordings/recorded_flip.mcap"
    advance_to(43.43)
    expect.command("flip_pose", "granted")
    advance(0.1)
    expect.no_command("flip_pose")
    expect.as_recorded())";
  const ProgramRun same = run_test(test);
  EXPECT_EQ(same.code, 0) << same.out;
  edit("behaviors/orientation.lua", "command.flip_pose()", "command.purge_reflection()");
  const ProgramRun other = run_test(test);
  EXPECT_EQ(other.code, 1) << other.out;
  EXPECT_NE(other.out.find("expected command flip_pose"), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("expected the recorded actions of the robot"), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("at 43.40 s"), std::string::npos) << other.out;
}

TEST_F(ReplayingTest, ReachesTheNextFrameWithParametersEditsAndMessages) {
  const ProgramRun run = run_test(R"(
    replay "recordings/recorded_flip.mcap"
    set_param("orientation.hold_time", "2")
    hear(2, "hello")
    reload { file = "behaviors/get_up.lua", from = 'behavior "get_up" {',
             to = 'behavior "get_up" { update = function() log.note("heard " .. team.heard()) end,' }
    advance(0)
    expect.log("heard 1")
    advance_to(43.9)
    expect.no_command("flip_pose")
    expect.equal(world_value("robot.posture"), "upright")
    expect.equal(world_value("pose.known"), true)
    expect.near(world_value("clock.time"), 43.9, 1e-3))");
  EXPECT_EQ(run.code, 0) << run.out;
}

TEST_F(ReplayingTest, ReportsMistakesInATestAndContinues) {
  folder_.write("scripts/tests/recordings/text.mcap", "no recording");
  folder_.write("outside.mcap", "no recording");
  std::filesystem::create_symlink(folder_.path() / "outside.mcap", scripts() / "tests/recordings/link.mcap");
  const std::string flip = "replay \"recordings/recorded_flip.mcap\" ";
  const std::pair<std::string, const char*> mistakes[] = {
      {"replay \"recordings/nothing.mcap\"", "recordings/nothing.mcap: it cannot be read: No such file"},
      {"replay \"recordings/text.mcap\"", "expected the start mark of an MCAP file, found other bytes"},
      {"replay \"recordings\"", "expected a recording, found something that is not a file"},
      {"replay(nil)", "string expected"},
      {"replay \"/etc/passwd\"", "replay: expected a file below the root of the scripts, found '/etc/passwd'"},
      {"replay \"/etc/nothing\"", "replay: expected a file below the root of the scripts, found '/etc/nothing'"},
      {"replay \"../../nothing.mcap\"", "expected a file below the root of the scripts, found '../../nothing.mcap'"},
      {"replay \"recordings/link.mcap\"", "expected a file below the root of the scripts"},
      {"replay(\"recordings/recorded_flip.mcap\\0x\")", "expected a file name without zero bytes"},
      {flip + "advance_to(42)", "this replay is already at 42.9"},
      {flip + "advance_to(0/0)", "finite number expected"},
      {flip + "advance_to(1e300)", "the recording ends at 43.9"},
      {flip + "advance(10)", "the recording ends at 43.9"},
      {flip + "set_world { pose = { x = 1 } }", "expected a fake world, found a replay"},
      {flip + "load_behavior \"patrol\"", "expected a fake world, found a replay"},
      {flip + "set_param(\"orientation.hold_tme\", \"2\") advance(0)", "hold_tme"},
      {flip + "world_value(\"pose.z\")", "unknown world field 'pose.z'"},
      {flip + "expect.state(\"orientation\", \"watching/unconfrimed\")", "did you mean"},
      {"load_behavior \"get_up\" " + flip, "use a separate test"},
      {"advance_to(3)", "call replay \"FILE\" first"},
      {"expect.as_recorded()", "call replay \"FILE\" first"},
  };
  for (const auto& [text, why] : mistakes) {
    const ProgramRun run = run_test(text);
    EXPECT_EQ(run.code, 1) << text << run.err;
    EXPECT_NE(run.out.find(why), std::string::npos) << text << "\n" << run.out;
  }
  // An error in a script fails one test and does not end all tests.
  edit("behaviors/orientation.lua", "behavior \"orientation\"", "behavior \"orientation\" !");
  EXPECT_EQ(run_test(flip + "advance(0)").code, 1);
}

TEST_F(ReplayingTest, OfManyReplaysEndsAtItsTimeLimit) {
  const ProgramRun run = run_test("for i = 1, 100000 do replay \"recordings/recorded_flip.mcap\" end");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("instructions"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("passed, 0 failed"), std::string::npos) << run.out;
}

/// A recording without images has no frame at which a replay can begin, so opening it reads all of it.
TEST_F(ReplayingTest, OfALongRecordingEndsAtItsTimeLimitAlsoWhileItIsOpened) {
  const std::filesystem::path file = scripts() / "tests/recordings/long.mcap";
  const ProgramRun recorded = run_reorient({"run", "--seconds", "3", "--width", "160", "--no-pictures", "--log", "off",
                                            "--record", file.string(), "--record-images", "none"});
  ASSERT_NE(recorded.out.find("91 frames"), std::string::npos) << recorded.out << recorded.err;
  int asked = 0;
  const auto stop = [&] { return ++asked > 4; };
  const PlayRecording play = recordings_below(scripts());
  EXPECT_THROW(play("recordings/long.mcap", ScriptTexts(), stop), mcap::Stopped);
  EXPECT_EQ(asked, 5) << "nothing is read afterwards";
  folder_.write("scripts/tests/a_test.lua", "test(\"it\", function() replay \"recordings/long.mcap\" end)\n");
  TestRun run;
  run.scripts_root = scripts();
  run.timeout = 0.2;
  run.play_recording = [](const std::string&, const ScriptTexts&,
                          const std::function<bool()>& is_late) -> std::unique_ptr<PlayedRecording> {
    while (!is_late()) std::this_thread::yield();
    throw mcap::Stopped();
  };
  std::ostringstream out;
  CoverageTrace trace;
  EXPECT_EQ(run_script_tests(run, out, trace).failed, 1);
  EXPECT_NE(out.str().find("the test took more than 0.2 s; --timeout SECONDS gives each test more"), std::string::npos)
      << out.str();
}

TEST_F(ReplayingTest, IsMadeOfARecordingWhoseNameIsNoLineOfLua) {
  const std::filesystem::path named = folder_.path() / "a\nerror(\"executed\")\n--.mcap";
  std::filesystem::copy_file(kProjectFolder / "scripts/tests/recordings/recorded_flip.mcap", named);
  const ProgramRun made = run_reorient({"record-test", named.string(), "--from", "43.2", "--to", "43.4", "--name",
                                        "made_here", "--scripts", scripts().string()});
  ASSERT_EQ(made.code, 0) << made.err;
  const std::string text = read_input(scripts() / "tests/made_here_test.lua", "a file");
  EXPECT_EQ(text.find("\nerror("), std::string::npos) << text;
  const ProgramRun run = run_reorient({"test", "--scripts", scripts().string()});
  EXPECT_EQ(run.code, 0) << run.out;
}

TEST_F(ReplayingTest, IsMadeOfAPartOfARecording) {
  const std::string recording = (kProjectFolder / "scripts/tests/recordings/recorded_flip.mcap").string();
  const std::vector<std::string> make{"record-test", recording, "--from",    "43.2",      "--to",
                                      "43.8",        "--name",  "made_here", "--scripts", scripts().string()};
  const ProgramRun made = run_reorient(make);
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("made_here_test.lua"), std::string::npos) << made.out;
  Recording part(scripts() / "tests/recordings/made_here.mcap");
  EXPECT_TRUE(part.view_topics().empty()) << "only topics that affect decisions";
  const ProgramRun run = run_reorient({"test", "--scripts", scripts().string()});
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_NE(run.out.find("made_here continues as recorded"), std::string::npos) << run.out;
  edit("tests/made_here_test.lua", "-- expect.as_recorded()", "expect.as_recorded()");
  EXPECT_EQ(run_reorient({"test", "--scripts", scripts().string()}).code, 0);

  const ProgramRun again = run_reorient(make);
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.err.find("expected a new file, found an existing one; choose another name: --name NAME"),
            std::string::npos)
      << again.err;
  const ProgramRun badly = run_reorient({"record-test", recording, "--name", "../x", "--scripts", scripts().string()});
  EXPECT_EQ(badly.code, 2);
  EXPECT_NE(badly.err.find("invalid script name '"), std::string::npos) << badly.err;
  const ProgramRun empty =
      run_reorient({"record-test", recording, "--from", "50", "--name", "none", "--scripts", scripts().string()});
  EXPECT_EQ(empty.code, 2);
  EXPECT_NE(empty.err.find("--from 50: expected at most 43.9"), std::string::npos) << empty.err;
  EXPECT_FALSE(std::filesystem::exists(scripts() / "tests/none_test.lua"));
  EXPECT_FALSE(std::filesystem::exists(scripts() / "tests/recordings/none.mcap"));
}

// ---- files of released formats

/// One file of each released format. The files never change: a changed format gets another number and another file.
TEST(GoldenRecording, OfThisFormatIsMadeAgainFrameByFrame) {
  const std::filesystem::path file =
      kProjectFolder / "tests/workbench/recording/golden" / ("format_" + std::to_string(kRecordingFormat) + ".mcap");
  ASSERT_TRUE(std::filesystem::exists(file)) << "a format without a file";
  const ProgramRun run = run_reorient({"replay", file.string()});
  // Another build may decide differently on the same frames; that does not concern the format.
  EXPECT_LE(run.code, 1) << run.err << "\nif what the bytes mean has changed, kRecordingFormat has to change with it";
  EXPECT_NE(run.out.find("10 frames, up to 43.50 s"), std::string::npos) << run.out;
}

TEST(GoldenRecording, OfEachFormatIsReadByInfo) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kProjectFolder / "tests/workbench/recording/golden")) {
    const ProgramRun run = run_reorient({"recording", "info", entry.path().string()});
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_NE(run.out.find("/world                          10     33.3"), std::string::npos) << run.out;
    ++files;
  }
  EXPECT_EQ(files, kRecordingFormat);
}

TEST(Recording, OfAnotherFormatIsRefusedByNumberAndReadByInfo) {
  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "old.mcap";
  std::ofstream out(file, std::ios::binary);
  mcap::Writer writer(
      [&](std::span<const std::byte> bytes) {
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
      },
      "reorient 9.9");
  writer.add_metadata("reorient", {{"format", "99"}, {"version", "9.9"}});
  const std::uint16_t schema = writer.add_schema("reorient.World", "jsonschema", "{}");
  for (const std::string_view topic : {kFrameTopic, kStateTopic, kImageTopics[0], kImageTopics[1]})
    writer.add_channel(topic, "something new", 0);
  const std::uint16_t world = writer.add_channel("/world", "json", schema);
  const std::string message = "{}";
  for (int i = 0; i < 7; ++i)
    writer.add_message(world, 1000000000u + 100000000u * i, std::as_bytes(std::span(message)));
  writer.finish();
  out.close();
  const ProgramRun replayed = run_reorient({"replay", file.string()});
  EXPECT_EQ(replayed.code, 2);
  EXPECT_NE(replayed.err.find("old.mcap: expected format "), std::string::npos) << replayed.err;
  EXPECT_NE(replayed.err.find(", found format 99 of reorient 9.9 (replay it"), std::string::npos) << replayed.err;
  EXPECT_EQ(std::count(replayed.err.begin(), replayed.err.end(), '\n'), 1) << replayed.err;
  const ProgramRun info = run_reorient({"recording", "info", file.string()});
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_NE(info.out.find("/world                           7"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("it can be viewed but not replayed"), std::string::npos) << info.out;
  for (const char* const word : {"recover", "cut"}) {
    const ProgramRun run = run_reorient({"recording", word, file.string(), "--out", (folder.path() / "x").string()});
    EXPECT_EQ(run.code, 2) << word;
    EXPECT_NE(run.err.find("found format 99"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "x")) << word;
  }
}

}  // namespace
}  // namespace reorient
