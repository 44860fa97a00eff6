// SPDX-License-Identifier: MIT
// Bad input: exit code 2, one line that names the invalid value, and no file written.
#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

using Words = std::vector<std::string>;

/// Sets a limit of the process, as `ulimit` does.
std::function<void()> limited(int resource, rlim_t value) {
  return [resource, value] {
    rlimit limit{};
    getrlimit(static_cast<__rlimit_resource>(resource), &limit);
    limit.rlim_cur = value;
    setrlimit(static_cast<__rlimit_resource>(resource), &limit);
  };
}

class BadInput : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string file(const std::string& name, std::string_view text) const { return folder_.write(name, text).string(); }

  std::set<std::string> files() const {
    std::set<std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
      all.insert(entry.path().string());
    }
    return all;
  }

  /// Limits the run to a tenth of a second, in case that it is not refused.
  void expect_refused_run(Words words, const Words& parts) const {
    words.insert(words.begin(), "run");
    const auto unless_given = [&](const std::string& option, const std::string& value) {
      if (std::find(words.begin(), words.end(), option) == words.end()) words.insert(words.end(), {option, value});
    };
    unless_given("--seconds", "0.1");
    unless_given("--width", "160");
    unless_given("--out", path("out"));
    expect_refused(words, parts);
  }

  /// What was expected and what was found, an unknown name, what the system refuses, or an error of Lua or of the TOML
  /// parser, which word them.
  static bool has_form(const std::string& error) {
    const auto has = [&](const char* text) { return error.find(text) != std::string::npos; };
    return (has("expected ") && (has("found ") || has("invalid "))) || has("unknown ") || has("cannot ") ||
           has(".lua:") || has("Error while parsing");
  }

  void expect_refused(const Words& words, const Words& parts) const {
    const std::set<std::string> before = files();
    const ProgramRun run = run_reorient(words);
    std::string command;
    for (const std::string& word : words) command += word + ' ';
    SCOPED_TRACE("reorient " + command + "\n" + run.err);
    EXPECT_EQ(run.code, kBadInput);
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(run.err.starts_with("reorient: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    EXPECT_TRUE(run.err.ends_with('\n'));
    EXPECT_TRUE(has_form(run.err));
    for (const std::string& part : parts) EXPECT_NE(run.err.find(part), std::string::npos) << part;
    EXPECT_EQ(files(), before);
  }

  TemporaryFolder folder_;
};

/// A flat Radiance picture, with the same gray in every pixel.
std::string radiance(int width, int height) {
  std::string bytes =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
  for (int i = 0; i < width * height; ++i) bytes += "\x60\x60\x60\x80";
  return bytes;
}

TEST_F(BadInput, OfTheProcessLimitsIsReportedAsWhatIsShort) {
#if defined(REORIENT_EMULATOR) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "needs more memory here";
#endif
  for (const char* const command : {"params", "version"}) {
    ChildProgram small_stack(folder_.path(), {command}, limited(RLIMIT_STACK, 64 * 1024));
    EXPECT_EQ(small_stack.wait(), kBadInput) << small_stack.err();
    EXPECT_EQ(small_stack.err(),
              "reorient: expected a stack of at least 1024 KiB, found a limit of 64 KiB; raise it with 'ulimit -s "
              "8192'\n");
  }
  ChildProgram large_images(folder_.path(), {"run", "--seconds", "1", "--width", "640", "--no-pictures"},
                            limited(RLIMIT_AS, rlim_t{100'000} * 1024));
  EXPECT_EQ(large_images.wait(), kBadInput);
  EXPECT_EQ(large_images.err(),
            "reorient: expected more memory, found none left of 100000 KiB, the limit of this process; raise it with "
            "'ulimit -v'\n");
}

TEST_F(BadInput, ACommandLineWithoutASubcommandIsRefused) { expect_refused({}, {"expected a command"}); }

TEST_F(BadInput, AnUnknownSubcommandIsNamed) { expect_refused({"dance"}, {"unknown command 'dance'"}); }

TEST_F(BadInput, AnUnknownOptionIsNamed) {
  expect_refused_run({"--rooom", "hall.hdr"}, {"unknown option '--rooom' (did you mean '--room'?)"});
  expect_refused({"--loud"}, {"unknown option '--loud'"});
  expect_refused({"test", "--quickly"}, {"unknown option '--quickly'"});
  expect_refused({"version", "--long"}, {"unknown option '--long'"});
}

TEST_F(BadInput, AnOptionWithoutItsValueIsNamed) {
  expect_refused({"run", "--room"}, {"--room: expected a value (FILE), found none"});
}

TEST_F(BadInput, AnInvalidValueIsNamedWithItsOption) {
  for (const char* width : {"100", "0", "-320", "wide", "320.5", "99999999999999999999"}) {
    expect_refused_run({"--width", width},
                       {std::string("--width: expected 160, 320, 544 or 640, found '") + width + "'"});
  }
  for (const char* seconds : {"-1", "0", "long", "nan", "inf", "1e9"}) {
    expect_refused_run({"--seconds", seconds},
                       {"--seconds: expected a number from 0.1 to 86400, found '" + std::string(seconds) + "'"});
  }
  for (const char* seed : {"-1", "one", "1.5", "99999999999999999999999"}) {
    expect_refused_run({"--seed", seed},
                       {"--seed: expected a whole number from 0 to 2^64 - 1, found '" + std::string(seed) + "'"});
    expect_refused_run({"--hall-seed", seed}, {"--hall-seed: expected a whole number from 0 to 2^64 - 1, found"});
  }
  expect_refused_run({"--log", "loud"}, {"--log: expected debug, info, warning, error or off, found 'loud'"});
}

TEST_F(BadInput, ARoomThatIsMissingIsNamed) {
  expect_refused_run({"--room", path("gone.hdr")}, {"unknown room '" + path("gone.hdr") + "'"});
}

TEST_F(BadInput, ARoomThatIsAFolderIsNamed) {
  expect_refused_run({"--room", folder_.path().string()}, {"expected a file, found a folder"});
}

TEST_F(BadInput, ARoomThatIsEmptyIsNamed) { expect_refused_run({"--room", file("hall.hdr", "")}, {"hall.hdr"}); }

TEST_F(BadInput, ARoomThatIsNotAPictureIsNamed) {
  expect_refused_run({"--room", file("hall.hdr", "a hall with many windows")}, {"hall.hdr"});
}

TEST_F(BadInput, ARoomThatEndsTooEarlyIsNamed) {
  const std::string whole = radiance(64, 32);
  for (const std::size_t size :
       {std::size_t{8}, std::size_t{30}, std::size_t{60}, whole.size() / 2, whole.size() - 1}) {
    expect_refused_run({"--room", file("hall.hdr", whole.substr(0, size))}, {"hall.hdr"});
  }
}

TEST_F(BadInput, ARoomThatIsNotAPanoramaIsNamedWithItsSize) {
  expect_refused_run({"--room", file("hall.hdr", radiance(64, 64))}, {"hall.hdr", "64 x 64"});
}

TEST_F(BadInput, ABannerInAPanoramaIsRefused) {
  expect_refused_run({"--room", file("gym.hdr", radiance(64, 32)), "--set", "room_shape.mark=3"},
                     {"gym.hdr", "room_shape.mark: expected 0, found 3 m", "only the built-in hall"});
}

TEST_F(BadInput, ASymmetryOutOfItsRangeIsNamedWithItsRange) {
  for (const char* value : {"-0.1", "1.01", "nan", "inf", "half", ""})
    expect_refused_run({"--set", std::string("room_shape.symmetry_strength=") + value},
                       {"room_shape.symmetry_strength"});
  for (const char* value : {"-0.1", "10.01", "nan", "wide"})
    expect_refused_run({"--set", std::string("room_shape.mark=") + value}, {"room_shape.mark"});
}

TEST_F(BadInput, AnUnknownParameterIsNamedWithASuggestion) {
  expect_refused_run(
      {"--set", "orientation.lingring=0.3"},
      {"the command line: unknown parameter 'orientation.lingring' (did you mean 'orientation.lingering'?)"});
  expect_refused_run({"--set", "pose_filter.partciles=50"}, {"did you mean 'pose_filter.particles'"});
}

TEST_F(BadInput, AnInvalidAssignmentIsReportedWithAnExample) {
  for (const char* setting : {"orientation.lingering", "=0.3", "", "="})
    expect_refused_run({"--set", setting}, {"--set: expected NAME=VALUE", "found '" + std::string(setting) + "'"});
}

TEST_F(BadInput, AParameterOutOfItsRangeIsNamedWithItsRange) {
  expect_refused_run({"--set", "pose_filter.particles=1"}, {"pose_filter.particles", "10", "10000"});
  expect_refused_run({"--set", "orientation.lingering=7"}, {"orientation.lingering", "0", "1"});
}

TEST_F(BadInput, AParameterOfAWrongTypeIsNamed) {
  for (const char* value : {"many", "", "3.5", "true", "nan", "1e999", "50 particles"}) {
    expect_refused_run({"--set", std::string("pose_filter.particles=") + value}, {"pose_filter.particles"});
  }
  for (const char* value : {"nan", "inf", "-inf", "soon"}) {
    expect_refused_run({"--set", std::string("arbiter.flip_cooldown=") + value}, {"arbiter.flip_cooldown"});
    expect_refused_run({"--set", std::string("orientation.lingering=") + value}, {"orientation.lingering"});
  }
  expect_refused_run({"--set", "histogram_distance.measure=ssd4"},
                     {"histogram_distance.measure", "did you mean 'ssd3'"});
  expect_refused_run({"--set", "simulator.ball=perhaps"}, {"simulator.ball"});
  expect_refused_run({"--set", "light.wall_changed=0.9"}, {"light.wall_changed"});
  expect_refused_run({"--set", "sensor.exposure_time=-1"}, {"sensor.exposure_time"});
}

TEST_F(BadInput, AParameterFileThatIsMissingIsNamed) {
  expect_refused_run({"--params", path("gone.toml")}, {"gone.toml: expected a parameter file, found none"});
}

TEST_F(BadInput, ABrokenParameterFileIsNamedWithTheLine) {
  expect_refused_run({"--params", file("mine.toml", "[orientation]\nlingering = = 0.3\n")}, {"mine.toml:2"});
  expect_refused_run({"--params", file("mine.toml", std::string_view("\0\xff\xfe", 3))}, {"mine.toml:1"});
}

TEST_F(BadInput, AParameterFileWithAnUnknownNameOrAWrongValueIsRefused) {
  expect_refused_run({"--params", file("mine.toml", "[orientation]\nlingring = 0.3\n")},
                     {"did you mean 'orientation.lingering'"});
  expect_refused_run({"--params", file("mine.toml", "[pose_filter]\nparticles = 1\n")},
                     {"mine.toml:2", "pose_filter.particles"});
  expect_refused_run({"--params", file("mine.toml", "[pose_filter]\nparticles = [50]\n")}, {"mine.toml:2"});
}

TEST_F(BadInput, AParameterFileCannotWriteOnTheTerminal) {
  expect_refused_run({"--params", file("mine.toml", "\"\\u001b[2Jname\\nagain\" = 1\n")},
                     {"mine.toml:1", "'\\x1B[2Jname again'"});
}

TEST_F(BadInput, AFieldFileThatIsMissingIsNamed) {
  expect_refused_run({"--field", path("gone.toml")}, {"unknown field '" + path("gone.toml") + "'"});
}

TEST_F(BadInput, AScenarioThatIsMissingIsNamed) {
  expect_refused_run({"gone"},
                     {"unknown scenario 'gone'", "(expected ball, elsewhere, fallen, falls, half_time, kidnapped"});
  expect_refused_run({path("gone.lua")}, {"gone.lua"});
}

TEST_F(BadInput, TheMostSimilarScriptIsSuggested) {
  expect_refused_run({"kidnaped"}, {"did you mean 'kidnapped'?"});
  expect_refused_run({"scenarios/kidnapped"}, {"did you mean 'kidnapped'?"});
  expect_refused_run({"orientation"}, {"expected a scenario, found the behavior 'orientation'"});
  expect_refused_run({"behaviors/orientation.lua"},
                     {"expected a scenario, found the behavior 'behaviors/orientation.lua'"});
  expect_refused_run({"--with", "kidnapped"}, {"expected a behavior, found the scenario 'kidnapped'"});
  expect_refused_run({"--with", "oreintation"}, {"did you mean 'orientation'?"});
  expect_refused_run({"--with", "behaviors/head_scan.lua"}, {"expected a behavior that is not loaded yet"});
  expect_refused_run({file("mine.lua", "")}, {"expected a script below", "found one outside", "--scripts"});
  expect_refused_run({"--set", "kidnapped.learn=3"}, {"this run does not load 'kidnapped'"});
}

TEST_F(BadInput, TheMostSimilarFileIsSuggested) {
  file("hall_of_the_north.hdr", "");
  expect_refused_run({"--room", folder_.path().string()}, {"as in", "hall_of_the_north.hdr"});
  expect_refused_run({"--room", path("hall_of_the_nroth.hdr")}, {"did you mean 'hall_of_the_north.hdr'?"});
  expect_refused_run({"--field", "slp"}, {"unknown field 'slp' (did you mean 'spl'?)"});
  expect_refused_run({"--body", "unicorn"},
                     {"unknown body 'unicorn' (expected a file, or one of booster-k1, booster-t1, nao-v6"});
  expect_refused_run(
      {"--params", "papre"},
      {"--params papre: expected a file, or a name in assets/parameters, found neither (did you mean 'paper'?)"});
  expect_refused_run({"--params", "light/hrad"}, {"did you mean 'light/hard'?"});
  expect_refused_run({"--json", path("gone/run.json")}, {"No such file or directory"});
}

TEST_F(BadInput, TheMostSimilarWordIsSuggested) {
  expect_refused({"kidnapped"}, {"did you mean 'reorient run kidnapped'?"});
  expect_refused_run({"--hall-sed", "3"}, {"did you mean '--hall-seed'?"});
  expect_refused({"--colr=never"}, {"did you mean '--color'?"});
  expect_refused_run({"--room", "x.hdr", "--hall-seed", "2"}, {"--room and --hall-seed: expected one, found both"});
}

TEST_F(BadInput, AnEmptyValueDoesNotMeanTheDefault) {
  for (const char* option : {"--room", "--field", "--params", "--scripts", "--json", "--save-params", "--out"})
    expect_refused_run({option, ""}, {option, "expected a value, found an empty one"});
  expect_refused_run({""}, {"unknown scenario ''"});
}

TEST_F(BadInput, AFolderOfScriptsThatIsMissingIsNamed) {
  expect_refused_run({"--scripts", path("gone")}, {"gone: expected a folder of scripts, found none"});
  expect_refused({"test", "--scripts", path("gone")}, {"gone: expected a folder of scripts, found none"});
}

TEST_F(BadInput, AScriptWithASyntaxErrorIsNamedWithItsLine) {
  const std::filesystem::path scripts = copy_scripts(folder_.path());
  folder_.write("scripts/behaviors/head_scan.lua", "behavior \"head_scan\" {\n  initial = \n}\n");
  expect_refused_run({"--scripts", scripts.string()}, {"behaviors/head_scan.lua:3"});
}

TEST_F(BadInput, AScriptThatFailsWhenItIsReadIsNamedWithItsLine) {
  const std::filesystem::path scripts = copy_scripts(folder_.path());
  folder_.write("scripts/behaviors/head_scan.lua", "local x = nil\nlocal y = x.z\nbehavior \"head_scan\" {}\n");
  expect_refused_run({"--scripts", scripts.string()}, {"behaviors/head_scan.lua:2"});
}

TEST_F(BadInput, ATestThatIsMissingIsNamed) { expect_refused({"test", path("gone_test.lua")}, {"gone_test.lua"}); }

TEST_F(BadInput, AFolderForPicturesThatCannotBeCreatedIsNamed) {
  file("taken", "a file, no folder");
  expect_refused_run({"--out", path("taken")}, {"taken", "--out"});
  expect_refused_run({"--out", path("taken/out")}, {"taken/out", "--out"});
}

TEST_F(BadInput, OneFileForTwoOptionsIsRefused) {
  expect_refused_run({"--json", path("same"), "--record", path("same")},
                     {"--json and --record: expected two files, found the same one"});
  expect_refused_run({"--model", path("z"), "--record", path("./z")},
                     {"--model and --record: expected two files, found the same one"});
  expect_refused_run({"--json", path("z"), "--save-params", path("z")},
                     {"--save-params and --json: expected two files"});
  const std::string tuned = file("tuned.toml", "[orientation]\nlingering = 0.4\n");
  expect_refused_run({"--params", tuned, "--json", tuned},
                     {"--params and --json: expected two files, found the same one"});
  std::filesystem::create_symlink(tuned, path("link.toml"));
  expect_refused_run({"--params", tuned, "--record", path("link.toml")}, {"--params and --record: expected two files"});
  const std::filesystem::path field = kProjectFolder / "assets/fields/spl.toml";
  expect_refused_run({"--field", field.string(), "--json", field.string()},
                     {"--field and --json: expected two files, found the same one"});
  EXPECT_LE(run_shortly({"--params", tuned, "--save-params", tuned}).code, kWrong)
      << "the same parameter file may be read and written";
  EXPECT_LE(run_shortly({"--json", "/dev/null", "--save-params", "/dev/null"}).code, kWrong);
}

TEST_F(BadInput, AnOutputAmongTheScriptsIsRefused) {
  const std::string scripts = copy_scripts(folder_.path()).string(), script = scripts + "/behaviors/look_back.lua";
  expect_refused_run({"--scripts", scripts, "--record", script},
                     {"--record " + script + ": expected a file outside the folder of scripts, found one in it"});
  expect_refused_run({"--scripts", scripts, "--json", script}, {"--json " + script});
  expect_refused({"graph", "orientation", "--scripts", scripts, "--out", script}, {"--out " + script});
  expect_refused({"params", "--scripts", scripts, "--save-params", script}, {"--save-params " + script});
  expect_refused({"test", "--scripts", scripts, "--junit", scripts + "/tests/get_up_test.lua"}, {"--junit"});
  EXPECT_EQ(run_reorient({"reference", "--scripts", scripts, "--format", "annotations", "--out",
                          scripts + "/annotations/reorient.lua"})
                .code,
            kSuccess)
      << "annotations are not scripts";
}

TEST_F(BadInput, AFileThatIsNotARecordingIsNotOverwritten) {
  const std::string letters = file("letters.txt", "years of work");
  expect_refused_run({"--record", letters}, {letters, "expected a new file or a recording, found another file"});
  EXPECT_EQ(read_text(letters), "years of work");
}

TEST_F(BadInput, AnInvalidRootOfScriptsIsNamed) {
  const std::string empty = folder_.path().string(), gone = path("gone");
  for (const std::vector<std::string>& words :
       {Words{"check"}, {"run"}, {"test"}, {"params"}, {"reference"}, {"graph", "orientation"}}) {
    for (const std::string& root : {empty, gone}) {
      Words all = words;
      all.insert(all.end(), {"--scripts", root});
      expect_refused(all, {"--scripts " + root + ": "});
    }
  }
  expect_refused({"new", "behavior", "x", "--scripts", gone}, {"--scripts " + gone});
  std::filesystem::create_directories(folder_.path() / "none" / "behaviors");
  expect_refused({"check", "--scripts", path("none")}, {"expected scripts, found none"});
  expect_refused({"check", (kProjectFolder / "scripts/README.md").string()},
                 {"README.md: expected a folder or a file *.lua, found another file"});
  std::filesystem::create_directory(folder_.path() / "mine");
  EXPECT_EQ(run_reorient({"new", "behavior", "x", "--scripts", path("mine")}).code, kSuccess)
      << "a new root of scripts";
}

TEST_F(BadInput, AFolderInsteadOfAFileIsNamed) {
  const std::string folder = folder_.path().string();
  expect_refused({"graph", "orientation", "--out", folder},
                 {"expected a file, found a folder; name another file with --out"});
  expect_refused({"params", "--save-params", folder},
                 {"expected a file, found a folder; name another file with --save-params"});
  expect_refused_run({"--params", folder}, {"--params " + folder + ": expected a file, found a folder"});
}

TEST_F(BadInput, AFileThatIsNotAScriptIsNotCalledMissing) {
  expect_refused_run({file("empty", "")}, {"empty': expected a script (*.lua), found another file"});
  expect_refused({"graph", file("mine.lua", "")}, {"expected a script below", "found one outside", "--scripts"});
}

TEST_F(BadInput, TheHelpOfTheUsedCommandIsNamed) {
  expect_refused({}, {"calibrate", "replay", "recording", "record-test"});
  expect_refused(
      {"model", "compare", "a.model"},
      {"expected second (second model, with the same wall), found none (see reorient model compare --help)"});
  expect_refused_run({"--set", "nosuch=1"}, {"'reorient params' lists all"});
}

TEST_F(BadInput, ASummaryThatCannotBeWrittenIsNamedBeforeTheRun) {
  file("taken", "a file, no folder");
  std::filesystem::create_directory(folder_.path() / "folder");
  expect_refused_run({"--json", path("taken/summary.json")}, {"taken/summary.json"});
  expect_refused_run({"--json", path("gone/summary.json")}, {"gone/summary.json"});
  expect_refused_run({"--json", path("folder")}, {"folder"});
}

}  // namespace
}  // namespace reorient
