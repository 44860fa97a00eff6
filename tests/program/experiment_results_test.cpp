// SPDX-License-Identifier: MIT
// Results on a disk: damaged ones, results of other experiments, and concurrent runs.
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program/experiment/session.h"
#include "program/experiment/task_results.h"
#include "tests/paths.h"
#include "tests/program/less_of_a_user.h"
#include "tests/program/short_experiment.h"

namespace reorient {
namespace {

using ResultsTest = ShortExperiment;

/// A flat gray panorama.
std::string gray_room(char gray) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
  for (int i = 0; i < 32 * 64; ++i) bytes += std::string(3, gray) + "\x80";
  return bytes;
}

TrialResult some_result() {
  TrialResult result;
  result.seed = 3;
  result.started = true;
  result.seconds = 61.25;
  result.right_after = 8.5;
  result.corrected_by = Reorientation::flip_pose;
  result.flips = 1;
  result.confidences.push_back({0.5, 0.25, 0.75, 3.5, RoomStatus::usable, false, true});
  return result;
}

/// A value that differs from the default.
struct Unusual {
  void operator()(const char*, bool& value) const { value = !value; }
  void operator()(const char*, int& value) const { value = 7; }
  void operator()(const char*, double& value) const { value = 0.1; }
  void operator()(const char*, std::int64_t& value) const { value = -8; }
  void operator()(const char*, std::uint64_t& value) const { value = ~std::uint64_t{0}; }
  void operator()(const char*, std::optional<double>& value) const { value = 1.0 / 3.0; }
  void operator()(const char*, std::optional<Reorientation>& value) const { value = Reorientation::purge_reflection; }
};

TEST(TaskResultsTest, AreReadAsWrittenInEachValue) {
  const TemporaryFolder folder;
  const TaskResults results(folder.path());
  TrialResult written;
  visit_named_values(Unusual(), written);
  written.confidences.push_back({0.5, 0.25, 0.75, -3.5, RoomStatus::usable, true, false});
  visit_named_errors(Unusual(), written.pose_errors.emplace());
  written.pose_errors->recoveries.push_back({std::nullopt, 2.5});
  const Origin origin{{"seed", "3"}};
  results.write(1, origin, written);
  const TrialResult read = results.read(1, origin).value();
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.started, written.started);
  EXPECT_EQ(read.seconds, written.seconds);
  EXPECT_EQ(read.correct_at_start, written.correct_at_start);
  EXPECT_EQ(read.right_after, written.right_after);
  EXPECT_EQ(read.corrected_after, written.corrected_after);
  EXPECT_EQ(read.corrected_by, written.corrected_by);
  EXPECT_EQ(read.usable_after, written.usable_after);
  EXPECT_EQ(read.displaced, written.displaced);
  EXPECT_EQ(read.flips, written.flips);
  EXPECT_EQ(read.purges, written.purges);
  EXPECT_EQ(read.resets, written.resets);
  EXPECT_EQ(read.false_flips, written.false_flips);
  EXPECT_EQ(read.false_purges, written.false_purges);
  EXPECT_EQ(read.right_seconds, written.right_seconds);
  EXPECT_EQ(read.wrong_seconds, written.wrong_seconds);
  EXPECT_EQ(read.uninformative_seconds, written.uninformative_seconds);
  EXPECT_EQ(read.ended_uninformative, written.ended_uninformative);
  EXPECT_EQ(read.symmetric_room, written.symmetric_room);
  ASSERT_TRUE(read.pose_errors);
  EXPECT_EQ(read.pose_errors->frames, written.pose_errors->frames);
  EXPECT_EQ(read.pose_errors->mirrored_frames, written.pose_errors->mirrored_frames);
  EXPECT_EQ(read.pose_errors->square_position, written.pose_errors->square_position);
  EXPECT_EQ(read.pose_errors->square_rotation, written.pose_errors->square_rotation);
  EXPECT_EQ(read.pose_errors->normalized_square, written.pose_errors->normalized_square);
  EXPECT_EQ(read.pose_errors->frames_within, written.pose_errors->frames_within);
  EXPECT_EQ(read.pose_errors->located_after, written.pose_errors->located_after);
  ASSERT_EQ(read.pose_errors->recoveries.size(), 1U);
  EXPECT_FALSE(read.pose_errors->recoveries[0].right_after);
  EXPECT_EQ(read.pose_errors->recoveries[0].located_after, 2.5);
  ASSERT_EQ(read.confidences.size(), 1U);
  EXPECT_EQ(read.confidences[0].opposite, 0.75);
  EXPECT_EQ(read.confidences[0].status, RoomStatus::usable);
  EXPECT_TRUE(read.confidences[0].correct);
}

TEST_F(ResultsTest, ContainWhatOnlySomeExperimentsMeasure) {
  folder.write("short.toml", R"(title = "Carried"
trials = 1
[condition]
scenario = "trial"
conditions = ["head"]
width = 160
seconds = 30
parameters.trial.learn = 2.0
measured_from = "measured"
limit = 1
hold = 0.5
)");
  const std::string rows = table("out");
  EXPECT_NE(rows.find("\"displaced_trials\": 1,"), std::string::npos) << rows;
}

TEST(TaskResultsTest, WithAFlippedBitOrWithoutTheEndAreRefused) {
  const Origin origin{{"seed", "3"}, {"script lib/walk.lua", "0123456789abcdef"}};
  const TemporaryFolder folder;
  const TaskResults results(folder.path());
  results.write(1, origin, some_result());
  ASSERT_EQ(results.read(1, origin)->seconds, 61.25);
  const std::string whole = read_text(results.file_of(1));
  const auto expect_refused = [&](const std::string& damaged, std::size_t where) {
    std::ofstream(results.file_of(1), std::ios::binary) << damaged;
    try {
      results.read(1, origin);
      ADD_FAILURE() << "accepted at byte " << where << ": " << damaged;
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(results.file_of(1).string() + ": ")) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    expect_refused(damaged, i);
    if (i + 1 < whole.size()) expect_refused(whole.substr(0, i), i);
  }
}

TEST_F(ResultsTest, OfAnotherTaskAreRefusedAndNotChanged) {
  ASSERT_EQ(run({"--out", path("out"), "--tasks", "1-2"}).code, kSuccess);
  std::filesystem::copy_file(result("out", 2), result("out", 3));
  expect_refused({"--out", path("out"), "--resume"},
                 "000003.json: expected the result of this trial, found that of another");
  EXPECT_EQ(read_text(result("out", 3)), read_text(result("out", 2)));
  std::filesystem::remove(result("out", 3));
  std::filesystem::create_directory(result("out", 3));
  expect_refused({"--out", path("out"), "--resume"}, "000003.json: expected the result of a trial, found a folder");
  std::filesystem::remove(result("out", 3));
  std::filesystem::resize_file(folder.write("out/tasks/000003.json", "{"), std::uintmax_t{20} << 30);
  expect_refused({"--out", path("out"), "--resume"},
                 "000003.json: expected the result of a trial of at most 64 MiB, found a larger one (20480 MiB)");
}

TEST(TaskResultsTest, OfAnotherTrialAreRefusedWithTheDifferences) {
  const TemporaryFolder folder;
  const TaskResults results(folder.path());
  const Origin origin{{"seed", "3"}, {"width", "160"}, {"a", "1"}, {"b", "1"}, {"c", "1"}};
  results.write(1, origin, some_result());
  const auto refusal = [&](const Origin& expected) {
    try {
      results.read(1, expected);
      return std::string("accepted");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  const std::string begin =
      results.file_of(1).string() + ": expected the result of this trial, found that of another: ";
  const std::string end = "; choose another --out, or remove the folder";
  Origin other = origin;
  other["seed"] = "4";
  other.erase("width");
  other["room\n\x1b"] = "hall";
  EXPECT_EQ(refusal(other), begin +
                                "room \\x1B (none instead of hall), seed (3 instead of 4), width (160 instead "
                                "of none)" +
                                end);
  for (const char* name : {"a", "b", "c"}) other[name] = "2";
  EXPECT_EQ(refusal(other), begin + "a (1 instead of 2), b (1 instead of 2), c (1 instead of 2) and 3 more" + end);
  EXPECT_EQ(refusal(origin), "accepted");
}

TEST_F(ResultsTest, OfOtherScriptsAreRefused) {
  const std::string scripts = copy_scripts(folder.path()).string();
  const std::vector<std::string> one_task{"--scripts", scripts, "--out", path("out"), "--task", "1"};
  ASSERT_EQ(run(one_task).code, kSuccess);
  EXPECT_EQ(run(one_task).code, kSuccess);
  // Files that the trial does not load.
  for (const char* unused : {"lib/of_our_own.lua", "scenarios/of_our_own.lua", "behaviors/of_our_own.lua"})
    folder.write(std::string("scripts/") + unused, "return {}");
  EXPECT_EQ(run(one_task).code, kSuccess);
  // The scenario, a behavior, and a library that they require.
  for (const char* used : {"scenarios/mirrored_placement.lua", "behaviors/orientation.lua", "lib/decision.lua"}) {
    const std::string script = std::string("scripts/") + used, before = read_text(path(script));
    folder.write(script, before + "\n-- edited");
    expect_refused(one_task, "000001.json: expected the result of this trial, found that of another: script " +
                                 std::string(used) + " (");
    folder.write(script, before);
  }
  EXPECT_EQ(run(one_task).code, kSuccess);
}

TEST_F(ResultsTest, OfAnotherRoomOrFieldOfTheSameNameAreRefused) {
  const std::string field = read_text(kProjectFolder / "assets/fields/spl.toml");
  folder.write("own.toml", field);
  folder.write("hall.hdr", gray_room('\x60'));
  folder.write("short.toml", std::string(kShort) + "field = \"" + path("own.toml") + "\"\n");
  // The second choice is the one with the field.
  const auto in_hall = [&](const std::string& task) {
    return std::vector<std::string>{"--room", path("hall.hdr"), "--out", path("out"), "--task", task};
  };
  ASSERT_EQ(run(in_hall("1")).code, kSuccess);
  ASSERT_EQ(run(in_hall("3")).code, kSuccess);
  folder.write("own.toml", field + "\n# another one\n");
  EXPECT_EQ(run(in_hall("1")).code, kSuccess);
  expect_refused(in_hall("3"), "000003.json: expected the result of this trial, found that of another");
  folder.write("hall.hdr", gray_room('\x61'));
  expect_refused(in_hall("1"), "000001.json: expected the result of this trial, found that of another");
}

TEST_F(ResultsTest, AreNotMixedFromScriptsThatChanged) {
  SessionOptions options;
  options.experiment = file.string();
  options.scripts = copy_scripts(folder.path());
  options.out = path("out");
  Session session(options);
  session.run(1);
  folder.write("scripts/lib/of_our_own.lua", "return {}");
  session.run(3);
  const std::string script = "scripts/behaviors/orientation.lua";
  folder.write(script, read_text(path(script)) + "\n-- edited");
  try {
    session.run(2);
    ADD_FAILURE() << "mixed";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), path(script) + ": expected an unchanged script during the experiment, found changes");
  }
  EXPECT_TRUE(session.result(1));
  EXPECT_FALSE(session.result(2));
}

TEST_F(ResultsTest, ThatDisappearAreReported) {
  SessionOptions options;
  options.experiment = file.string();
  options.out = path("out");
  Session session(options);
  for (const int task : {1, 2, 3, 4}) session.run(task);
  EXPECT_EQ(session.cell_results().size(), 2U);
  std::filesystem::remove(result("out", 2));
  try {
    static_cast<void>(session.cell_results());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), result("out", 2).string() +
                                ": expected the result of a trial, found no file; --resume runs that trial again");
  }
}

TEST_F(ResultsTest, AreSharedByTwoRunsAtOnce) {
  const std::string all = table("alone");
  const TemporaryFolder other;
  const auto at_once = [&](const std::string& json) {
    return words({"--resume", "--jobs", "2", "--out", path("out"), "--json", path(json)});
  };
  ChildProgram first(folder.path(), at_once("first.json"));
  ChildProgram second(other.path(), at_once("second.json"));
  EXPECT_EQ(first.wait(), kSuccess) << first.err();
  EXPECT_EQ(second.wait(), kSuccess) << second.err();
  EXPECT_EQ(read_text(path("first.json")), all);
  EXPECT_EQ(read_text(path("second.json")), all);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path("out")))
    EXPECT_FALSE(entry.path().string().ends_with(".partial")) << entry.path();
}

/// A child of the process; 0: it has none.
pid_t child_of(pid_t process) {
  const std::string id = std::to_string(process);
  const std::string children = read_text("/proc/" + id + "/task/" + id + "/children");
  return children.empty() ? 0 : static_cast<pid_t>(std::stol(children));
}

/// As in /proc: 'T' is a stopped process, 'Z' one that has ended. 0: the process is gone.
char state_of(pid_t process) {
  const std::string status = read_text("/proc/" + std::to_string(process) + "/status"), key = "State:\t";
  const std::size_t place = status.find(key);
  return place == std::string::npos ? char{} : status.at(place + key.size());
}

/// Crashes the worker of an experiment's first trial. False: the trial has a result already.
bool crash_first_trial(const ChildProgram& program, const std::filesystem::path& result) {
  pid_t worker = 0;
  await([&] { return (worker = child_of(program.id())) > 0 || program.has_ended(); }, std::chrono::milliseconds(1));
  if (worker == 0 || ::kill(worker, SIGSTOP) != 0) return false;
  await([&] {
    const char state = state_of(worker);
    return state == 'T' || state == 'Z' || state == char{};
  });
  const bool is_in_time = state_of(worker) == 'T' && !std::filesystem::exists(result);
  if (is_in_time) ::kill(worker, SIGABRT);
  ::kill(worker, SIGCONT);
  return is_in_time;
}

TEST_F(ResultsTest, OfOtherTrialsAreWrittenIfATrialCrashes) {
  if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "no /proc here";
  const std::string all = table("whole");
  std::optional<ChildProgram> program;
  const auto crashes_in_time = [&] {  // on a slow machine the first trial may end before the signal: then repeat
    program.reset();
    std::filesystem::remove_all(path("out"));
    program.emplace(folder.path(), words({"--out", path("out")}));
    return crash_first_trial(*program, result("out", 1));
  };
  ASSERT_TRUE(await(crashes_in_time)) << program->err();
  EXPECT_EQ(program->wait(), kWrong) << program->err();
  const std::string told = program->err();
  const std::size_t crashed = told.find(": crashed (Aborted); this runs it again: reorient experiment ");
  ASSERT_NE(crashed, std::string::npos) << told;
  EXPECT_TRUE(told.ends_with("1 of 4 trials crashed; the others are in " + path("out") + "\n")) << told;
  int there = 0;
  for (const int task : {1, 2, 3, 4}) there += std::filesystem::exists(result("out", task)) ? 1 : 0;
  EXPECT_EQ(there, 3);

  const std::size_t command = told.find("reorient experiment ");
  const std::string line = told.substr(command, told.find('\n', command) - command);
  const std::string shell = std::string("REORIENT_HOME='") + kSourceFolder + "' '" + kProgram + "' --log off ";
  EXPECT_EQ(std::system((shell + line.substr(std::string("reorient ").size())).c_str()), 0) << line;
  EXPECT_EQ(table("out", {"--resume"}), all);
}

TEST_F(ResultsTest, AreNotLostIfTheDiskIsFull) {
  const std::string all = table("whole");
  std::filesystem::create_directory(path("out"));
  const std::string kept = path("kept");
  // Two pages: a result needs one.
  ChildProgram program(folder.path(), words({"--out", path("out")}),
                       [&] { put_a_small_disk(path("out"), kept, "8k"); });
  const int code = program.wait();
  if (code == kCannot) GTEST_SKIP() << "this user may not have a disk of its own (user namespaces)";
  EXPECT_EQ(code, kBadInput);
  EXPECT_NE(program.err().find("cannot write '" + result("out", 3).string() +
                               "': No space left on device; when it is fixed, --resume continues\n"),
            std::string::npos)
      << program.err();
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(result("kept", 1).parent_path()), {}), 2);
  EXPECT_EQ(table("kept", {"--resume"}), all);
}

TEST_F(ResultsTest, ThatCannotBeWrittenAreReportedBeforeAnythingRuns) {
  using std::filesystem::perms;
  std::filesystem::permissions(folder.path(), perms::all);
  std::filesystem::create_directory(path("out"));
  std::filesystem::permissions(path("out"), perms::owner_read | perms::owner_exec | perms::others_read |
                                                perms::others_exec | perms::group_read | perms::group_exec);
  ChildProgram program(folder.path(), words({"--out", path("out")}), become_an_ordinary_user);
  const int code = program.wait();
  if (code == kCannot) GTEST_SKIP() << "this user cannot run a program as a user with fewer permissions";
  EXPECT_EQ(code, kBadInput);
  EXPECT_EQ(program.err(),
            "reorient: cannot write into '" + path("out") + "': Permission denied; name another folder with --out\n");
}

}  // namespace
}  // namespace reorient
