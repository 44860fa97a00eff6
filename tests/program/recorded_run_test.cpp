// SPDX-License-Identifier: MIT
// `run --record`, `replay` and `recording`, called as by a user. REORIENT_INTERRUPTIONS=200 kills 200 runs.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "program/run/run_recording.h"
#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/program/less_of_a_user.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/recording_file.h"

namespace reorient {
namespace {

class RunThatIsRecorded : public testing::Test {
 protected:
  std::string file(const char* name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(RunThatIsRecorded, HasTheDigestOfOneThatIsNotAndOfItsReplay) {
  const ProgramRun plain = run_shortly({});
  const ProgramRun recorded = run_shortly({"--record", file("run.mcap")});
  EXPECT_EQ(digest_of(recorded), digest_of(plain));
  EXPECT_NE(recorded.out.find("recording: " + file("run.mcap") + ", 91 frames, "), std::string::npos) << recorded.out;
  const ProgramRun replayed = run_reorient({"replay", file("run.mcap")});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_EQ(digest_of(replayed), digest_of(plain));
  EXPECT_NE(replayed.out.find("all frames are the same as recorded"), std::string::npos) << replayed.out;
  const ProgramRun info = run_reorient({"recording", "info", file("run.mcap")});
  EXPECT_EQ(info.code, 0);
  EXPECT_NE(info.out.find("91 frames, 0.00 to 3.00 s of the robot; 91 can be replayed exactly"), std::string::npos)
      << info.out;
}

TEST_F(RunThatIsRecorded, MayBeCutAnywhere) {
  run_shortly({"--record", file("run.mcap")});
  Random random(11);
  for (int i = 0; i < 20; ++i) {
    const double from = random.uniform(0.0, 2.9), to = from + random.uniform(0.1, 2.0);
    SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
    const ProgramRun cut = run_reorient({"recording", "cut", file("run.mcap"), "--from", std::to_string(from), "--to",
                                         std::to_string(to), "--out", file("part.mcap")});
    ASSERT_EQ(cut.code, 0) << cut.err;
    Recording part(file("part.mcap"));
    RecordedFrame frame;
    int frames = 0;
    for (; part.next(frame); ++frames) {
      EXPECT_GE(frame.entry.time, from);
      EXPECT_LE(frame.entry.time, to);
    }
    EXPECT_NEAR(frames, 30.0 * (std::min(to, 3.0) - from), 1.5);
    const ProgramRun replayed = run_reorient({"replay", file("part.mcap")});
    EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
    EXPECT_NE(replayed.out.find(std::to_string(frames) + " frames"), std::string::npos) << replayed.out;
  }
}

TEST_F(RunThatIsRecorded, ReportsWhatAnotherParameterWouldHaveChanged) {
  const ProgramRun recorded = run_reorient(
      {"run", "--seconds", "60", "--width", "160", "--no-pictures", "--log", "off", "--record", file("run.mcap")});
  ASSERT_NE(recorded.out.find("flip_pose"), std::string::npos) << recorded.out;
  const ProgramRun what_if = run_reorient({"replay", file("run.mcap"), "--set", "orientation.hold_time=2"});
  EXPECT_EQ(what_if.code, 0) << what_if.err;
  EXPECT_NE(what_if.out.find("the first decision that differs is at "), std::string::npos) << what_if.out;
  EXPECT_NE(
      what_if.out.find("recorded, but not replayed:\n  orientation: watching/unconfirmed > watching/confirmed (the "
                       "believed pose won)"),
      std::string::npos)
      << what_if.out;
  EXPECT_NE(what_if.out.find("the robot would have acted differently from frame "), std::string::npos) << what_if.out;

  const std::filesystem::path scripts = copy_scripts(folder_.path());
  const ProgramRun same = run_reorient({"replay", file("run.mcap"), "--scripts", scripts.string()});
  EXPECT_NE(same.out.find("all frames are the same as recorded"), std::string::npos) << same.out;
  std::ofstream(scripts / "behaviors" / "wall_gaze.lua", std::ios::app) << "\n-- edited\n";
  const ProgramRun edited = run_reorient({"replay", file("run.mcap"), "--scripts", scripts.string()});
  EXPECT_EQ(edited.code, 0) << edited.err;
  EXPECT_NE(edited.out.find("behaviors/wall_gaze.lua was accepted"), std::string::npos) << edited.out;
  EXPECT_NE(edited.out.find("no decision of a behavior differs"), std::string::npos) << edited.out;
  std::filesystem::remove(scripts / "behaviors" / "wall_gaze.lua");
  const ProgramRun without = run_reorient({"replay", file("run.mcap"), "--scripts", scripts.string()});
  EXPECT_EQ(without.code, 2);
  EXPECT_NE(without.err.find("behaviors/wall_gaze.lua: script not found"), std::string::npos) << without.err;
}

TEST_F(RunThatIsRecorded, IsExportedAsTablesAndPicturesOfAnyTime) {
  run_shortly({"--record", file("run.mcap")});
  const ProgramRun world = run_reorient({"recording", "export", file("run.mcap"), "--csv", "world"});
  EXPECT_EQ(world.code, 0) << world.err;
  EXPECT_EQ(std::count(world.out.begin(), world.out.end(), '\n'), 92);
  EXPECT_TRUE(world.out.starts_with("frame,clock.")) << world.out.substr(0, 100);
  EXPECT_NE(world.out.find(",upright,"), std::string::npos);
  const ProgramRun events =
      run_reorient({"recording", "export", file("run.mcap"), "--csv", "events", "--out", file("events.csv")});
  EXPECT_EQ(events.code, 0) << events.err;
  EXPECT_TRUE(read_text(file("events.csv")).starts_with("time,machine,state,command,verdict,reason\n"));
  EXPECT_NE(read_text(file("events.csv")).find(",orientation,"), std::string::npos);

  const ProgramRun pictures =
      run_reorient({"recording", "pictures", file("run.mcap"), "--at", "1.5", "--out", file("pictures")});
  EXPECT_EQ(pictures.code, 0) << pictures.err;
  EXPECT_NE(pictures.out.find("pictures of 1.50 s"), std::string::npos) << pictures.out;
  for (const char* const name : {"world_view.png", "camera_view.png", "confidences.png", "reorientations.png"})
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "pictures" / name)) << name;
}

/// The frames of a recording so far, also while a program still writes it.
struct Recorded {
  int frames = 0;
  double until = -1.0;  ///< s of the robot, of the last frame; -1: no frame yet
};

Recorded recorded_in(const std::string& file) {
  Recorded recorded;
  try {
    Recording recording(file);
    for (RecordedFrame frame; recording.next(frame); ++recorded.frames) recorded.until = frame.entry.time;
  } catch (const std::runtime_error&) {  // its head is not written yet
  }
  return recorded;
}

/// s of the robot, of the last whole line of the timeline; -1: no line yet.
double last_reported(const std::string& out) {
  double time = -1.0;
  std::istringstream lines(out.substr(0, out.rfind('\n') + 1));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream in(line);
    double seconds = 0.0;
    std::string unit;
    if (in >> seconds >> unit && unit == "s") time = seconds;
  }
  return time;
}

/// The bound itself: a frame waits for kFlushEvery until the recorder looks, and may then be too young to be written
/// for as long again. How late the recorder is beyond that depends on the machine, and no test asserts it. The tests
/// below assert that frames reach the file and the disk while the run continues.
static_assert(2 * RecordingFile::kFlushEvery <= std::chrono::milliseconds(500));

TEST_F(RunThatIsRecorded, LosesAtMostTheLastSecondIfItIsKilled) {
  const char* const wanted = std::getenv("REORIENT_INTERRUPTIONS");
  const int times = wanted == nullptr ? 3 : std::atoi(wanted);
  double most_lost = 0.0;
  Random random(7);
  for (int i = 0; i < times; ++i) {
    std::filesystem::remove(file("run.mcap"));
    ChildProgram run(folder_.path(), {"run", "--realtime", "--width", "160", "--no-pictures", "--every-transition",
                                      "--record", file("run.mcap")});
    ASSERT_TRUE(run.await("orientation"));  // the timeline has begun
    // Random frames after the first flush, so that the signal meets any moment between two flushes.
    const double least = last_reported(run.out()) + random.uniform(0.0, 2.0);
    const auto has_recorded = [&] { return recorded_in(file("run.mcap")).until >= least; };
    ASSERT_TRUE(await(has_recorded, std::chrono::milliseconds(20))) << least;
    let_time_pass(random.uniform(0.0, 0.5));
    run.kill(SIGKILL);
    run.wait();
    const Recorded recorded = recorded_in(file("run.mcap"));
    const int frames = recorded.frames;
    EXPECT_GE(recorded.until, least) << "written frames are not lost";
    most_lost = std::max(most_lost, last_reported(run.out()) - recorded.until);
    const ProgramRun replayed = run_reorient({"replay", file("run.mcap")});
    EXPECT_EQ(replayed.code, 1) << replayed.out << replayed.err;
    EXPECT_NE(replayed.out.find("these frames are the same as recorded"), std::string::npos) << replayed.out;
    EXPECT_NE(replayed.err.find("at byte "), std::string::npos) << "its end is missing: " << replayed.err;
    const ProgramRun recovered = run_reorient({"recording", "recover", file("run.mcap"), "--out", file("whole.mcap")});
    // The signal may come within a write. Then the frames of that chunk are lost, and their number is unknown.
    const bool ends_within = recovered.out.find("; an unknown number of frames lost\n") != std::string::npos;
    EXPECT_EQ(recovered.code, ends_within ? 1 : 0) << recovered.out << recovered.err;
    const ProgramRun whole = run_reorient({"replay", file("whole.mcap")});
    EXPECT_EQ(whole.err, "");
    EXPECT_EQ(whole.code, 0) << whole.out;
    EXPECT_NE(whole.out.find(std::to_string(frames) + " frames"), std::string::npos) << whole.out;
  }
  RecordProperty("most_lost", std::to_string(most_lost));
  if (wanted != nullptr) std::cout << "at most " << most_lost << " s of the timeline are missing in a recording\n";
}

/// The report of sync_shim.cpp so far.
struct Flushes {
  long times = 0;
  double longest = -1.0;  ///< s
  long behind = -1;       ///< bytes
};

Flushes flushes_in(const std::string& report) {
  Flushes flushes;
  std::istringstream(read_text(report)) >> flushes.times >> flushes.longest >> flushes.behind;
  return flushes;
}

TEST_F(RunThatIsRecorded, IsOnTheDiskItselfWithinHalfASecond) {
#if defined(REORIENT_EMULATOR) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "LD_PRELOAD does not work here";
#endif
  const std::string report = file("report.txt");
  ChildProgram run(folder_.path(),
                   {"run", "--realtime", "--width", "160", "--no-pictures", "--record", file("run.mcap")}, [&] {
                     setenv("REORIENT_SYNC_REPORT", report.c_str(), 1);
                     setenv("LD_PRELOAD", kSyncShim, 1);
                   });
  EXPECT_TRUE(await([&] { return flushes_in(report).times >= 4 || run.has_ended(); }));
  EXPECT_FALSE(run.has_ended()) << "the recording is flushed while the run continues\n" << run.err();
  run.kill(SIGTERM);
  EXPECT_EQ(run.wait(), 128 + SIGTERM) << run.err();
  const Flushes flushes = flushes_in(report);
  EXPECT_GE(flushes.times, 4);
  EXPECT_EQ(flushes.behind, 0) << "bytes were written and never flushed";
  RecordProperty("longest", std::to_string(flushes.longest));
  if (std::getenv("REORIENT_INTERRUPTIONS") == nullptr) return;
  std::cout << flushes.times << " times flushed, " << flushes.longest << " s after the first byte at most\n";
}

TEST_F(RunThatIsRecorded, EndsItsRecordingWithoutDamageIfTheDiskIsFullAndContinues) {
  // No file may become larger than 2 MB; a run of 10 s would take 8.
  ChildProgram run(folder_.path(),
                   {"run", "--seconds", "10", "--width", "160", "--no-pictures", "--record", file("run.mcap")},
                   files_up_to(2'000'000));
  EXPECT_EQ(run.wait(), 1) << run.err();  // the job takes longer
  EXPECT_NE(run.err().find("reorient: the recording ends here: " + file("run.mcap") + ": the file cannot be written: "),
            std::string::npos)
      << run.err();
  EXPECT_NE(run.out().find("10.0 s in 301 frames"), std::string::npos) << run.out();
  const ProgramRun replayed = run_reorient({"replay", file("run.mcap")});
  EXPECT_EQ(replayed.code, 0) << replayed.out;
  EXPECT_EQ(replayed.err, "") << "the recording is complete";
}

/// In real time a chunk is small, and the space after the last chunk may be too small for the summary.
TEST_F(RunThatIsRecorded, EndsItsRecordingWithoutDamageIfTheDiskIsFullWithinAChunk) {
  constexpr rlim_t kLeast = 650'000, kMost = 950'000, kStep = 25'000;  // the first chunk fits
  constexpr rlim_t kAtOnce = 4;  // more would slow down two processors below real time
  for (rlim_t first = kLeast; first < kMost; first += kAtOnce * kStep) {
    std::vector<std::unique_ptr<ChildProgram>> runs;
    std::vector<std::string> files;
    for (rlim_t most = first; most < first + kAtOnce * kStep; most += kStep) {
      files.push_back(file((std::to_string(most) + ".mcap").c_str()));
      runs.push_back(
          std::make_unique<ChildProgram>(folder_.path(),
                                         std::vector<std::string>{"run", "--realtime", "--seconds", "2", "--width",
                                                                  "160", "--no-pictures", "--record", files.back()},
                                         files_up_to(most)));
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
      EXPECT_EQ(runs[i]->wait(), 1) << runs[i]->err();  // the job takes longer
      EXPECT_NE(runs[i]->err().find("reorient: the recording ends here: "), std::string::npos) << runs[i]->err();
      const ProgramRun replayed = run_reorient({"replay", files[i]});
      EXPECT_EQ(replayed.code, 0) << files[i] << ": " << replayed.out;
      EXPECT_EQ(replayed.err, "") << files[i] << ": it is whole";
    }
  }
}

/// The limit is reached before the end of the first part, between two parts, or in the second part: all frames in the
/// files can be replayed, and the printed counts match them.
TEST_F(RunThatIsRecorded, EndsEveryPartWithoutDamageIfTheDiskIsFull) {
  for (int size = 1180; size < 1300; size += 12) {
    const std::filesystem::path disk = folder_.path() / ("disk" + std::to_string(size)), kept = disk.string() + "-kept";
    std::filesystem::create_directory(disk);
    ChildProgram run(folder_.path(),
                     {"run", "--seconds", "3", "--width", "160", "--no-pictures", "--record",
                      (disk / "run.mcap").string(), "--record-rotate", "1s"},
                     [&] { put_a_small_disk(disk, kept, (std::to_string(size) + "k").c_str()); });
    const int code = run.wait();
    if (code == kCannot) GTEST_SKIP() << "this user may not have a disk of its own (user namespaces)";
    EXPECT_EQ(code, 1) << run.err();  // the job takes longer
    EXPECT_NE(run.err().find("No space left on device"), std::string::npos) << size << run.err();
    std::uint64_t frames = 0;
    int parts = 0;
    for (const auto& part : std::filesystem::directory_iterator(kept)) {
      const ProgramRun replayed = run_reorient({"replay", part.path().string()});
      EXPECT_EQ(replayed.code, 0) << size << part.path() << replayed.out;
      EXPECT_EQ(replayed.err, "") << size << part.path() << ": it is whole";
      Recording recording(part.path());
      for (RecordedFrame frame; recording.next(frame);) ++frames;
      ++parts;
    }
    const std::string told = "run.mcap" + (parts > 1 ? " and " + std::to_string(parts - 1) + " more, " : ", ") +
                             std::to_string(frames) + " frames, ";
    EXPECT_NE(run.out().find(told), std::string::npos) << size << ": " << told << '\n' << run.out();
  }
}

TEST_F(RunThatIsRecorded, IsReadWholeWithAnyFlippedBitInItsHead) {
  run_shortly({"--record", file("run.mcap")});
  const std::string whole = read_text(file("run.mcap"));
  for (std::size_t place = 8; place < 700; place += 3) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    folder_.write("damaged.mcap", damaged);
    const ProgramRun recovered =
        run_reorient({"recording", "recover", file("damaged.mcap"), "--out", file("whole.mcap")});
    if (recovered.err.find(", found format ") != std::string::npos) continue;  // the number itself
    ASSERT_EQ(recovered.code, 0) << place << recovered.err;
    EXPECT_NE(recovered.out.find(": 91 frames, 0.00 to 3.00 s"), std::string::npos) << place << recovered.out;
  }
}

TEST_F(RunThatIsRecorded, KeepsTheOldFileIfItCannotBeReplaced) {
  run_shortly({"--record", file("run.mcap")});
  const std::string before = read_text(file("run.mcap"));
  folder_.write("other.mcap", before);
  folder_.write("kept.mcap", before);
  for (const char* const command : {"recover", "cut"}) {
    ChildProgram rewriting(folder_.path(), {"recording", command, file("other.mcap"), "--out", file("kept.mcap")},
                           files_up_to(100000));
    EXPECT_EQ(rewriting.wait(), 2) << rewriting.err();
    EXPECT_EQ(read_text(file("kept.mcap")), before) << command;
  }
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    files += entry.path().extension() == ".partial" ? 1 : 0;
  EXPECT_EQ(files, 0);
}

TEST_F(RunThatIsRecorded, WithAGapIsRecoveredWithExitCode1) {
  run_shortly({"--record", file("run.mcap")});
  std::string bytes = read_text(file("run.mcap"));
  bytes.replace(bytes.size() / 2, 2000, 2000, 'x');
  folder_.write("hole.mcap", bytes);
  const ProgramRun recovered = run_reorient({"recording", "recover", file("hole.mcap"), "--out", file("rest.mcap")});
  EXPECT_EQ(recovered.code, 1) << recovered.err;
  EXPECT_NE(recovered.out.find(" frames lost"), std::string::npos) << recovered.out;
}

TEST_F(RunThatIsRecorded, ThatIsDamagedIsReplayedInPart) {
  run_shortly({"--record", file("run.mcap")});
  std::string bytes = read_text(file("run.mcap"));
  bytes.replace(bytes.size() / 2, 2000, 2000, 'x');
  folder_.write("hole.mcap", bytes);
  const ProgramRun hole = run_reorient({"replay", file("hole.mcap")});
  EXPECT_EQ(hole.code, 1) << hole.out;
  EXPECT_NE(hole.out.find(" frames, up to "), std::string::npos) << hole.out;
  EXPECT_NE(hole.out.find(" of "), std::string::npos) << hole.out;
  EXPECT_NE(hole.out.find("; the rest cannot be replayed"), std::string::npos) << hole.out;
  EXPECT_EQ(hole.out.find("all frames"), std::string::npos) << hole.out;
  folder_.write("half.mcap", bytes.substr(0, bytes.size() / 2));
  const ProgramRun half = run_reorient({"replay", file("half.mcap")});
  EXPECT_EQ(half.code, 1) << half.out;
  EXPECT_NE(half.out.find("; the rest cannot be replayed"), std::string::npos) << half.out;
  const ProgramRun sound_part = run_reorient({"replay", file("half.mcap"), "--to", "0.5"});
  EXPECT_EQ(sound_part.code, 0) << sound_part.out;
  EXPECT_NE(sound_part.out.find("all frames are the same as recorded"), std::string::npos) << sound_part.out;
}

/// A block that is lost in the middle: its frames belong to the total, and a tool that passes on the rest counts them.
TEST_F(RunThatIsRecorded, CountsLostFramesInItsTotal) {
  run_shortly({"--record", file("run.mcap")});
  std::string bytes = read_text(file("run.mcap"));
  bytes.replace(bytes.size() / 2, 2000, 2000, 'x');
  folder_.write("hole.mcap", bytes);
  const ProgramRun hole = run_reorient({"replay", file("hole.mcap")});
  EXPECT_NE(hole.out.find(" of 91 frames, up to "), std::string::npos) << hole.out;
  const ProgramRun info = run_reorient({"recording", "info", file("hole.mcap")});
  EXPECT_EQ(info.code, 1);
  EXPECT_NE(info.out.find(" frames lost"), std::string::npos) << info.out;
  const ProgramRun world = run_reorient({"recording", "export", file("hole.mcap"), "--csv", "world"});
  EXPECT_EQ(world.code, 1);
  EXPECT_NE(world.err.find(" frames lost\n"), std::string::npos) << world.err;
  // The bytes of a chunk end within it.
  folder_.write("half.mcap", bytes.substr(0, bytes.size() / 2 + 1000));
  const ProgramRun half = run_reorient({"recording", "recover", file("half.mcap"), "--out", file("whole.mcap")});
  EXPECT_EQ(half.code, 1) << half.out;
  EXPECT_NE(half.out.find("; an unknown number of frames lost\n"), std::string::npos) << half.out;
}

TEST_F(RunThatIsRecorded, IsExportedOverATableButOverNoOtherFile) {
  run_shortly({"--record", file("run.mcap")});
  for (const char* const table : {"world", "events", "world"}) {
    const ProgramRun written =
        run_reorient({"recording", "export", file("run.mcap"), "--csv", table, "--out", file("table.csv")});
    EXPECT_EQ(written.code, 0) << written.err;
  }
  folder_.write("notes.txt", "important");
  const ProgramRun refused =
      run_reorient({"recording", "export", file("run.mcap"), "--csv", "events", "--out", file("notes.txt")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(read_text(file("notes.txt")), "important");
}

TEST_F(RunThatIsRecorded, IsExportedToAReaderThatEndsEarly) {
  run_shortly({"--record", file("run.mcap")});
  ChildProgram exporting(folder_.path(), {"recording", "export", file("run.mcap"), "--csv", "world"}, [] {
    int ends[2];
    if (pipe(ends) != 0) _exit(126);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
  });
  EXPECT_EQ(exporting.wait(), 128 + SIGPIPE);
  EXPECT_EQ(exporting.err(), "");
}

TEST_F(RunThatIsRecorded, KeepsTheFurtherPartsOfAnEarlierOne) {
  folder_.write("rot.3.mcap", "a part of an earlier run");
  folder_.write("rot.notes.mcap", "no part");
  const ProgramRun refused = run_shortly({"--record", file("rot.mcap"), "--record-rotate", "1s"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find(file("rot.3.mcap") + ": expected no part of an earlier run, found one"), std::string::npos)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(file("rot.mcap")));
  std::filesystem::remove(file("rot.3.mcap"));
  run_shortly({"--record", file("rot.mcap"), "--record-rotate", "1s"});
  EXPECT_TRUE(std::filesystem::exists(file("rot.2.mcap")));
}

TEST_F(RunThatIsRecorded, ByARobotUsesTheNextFreeName) {
  RunOptions options;
  options.robot = "nao";
  options.record = file("run.mcap");
  folder_.write("run-2.4.mcap", "a part of an earlier run");
  for (int run = 0; run < 2; ++run) {
    RunRecording recording(
        recorder_options(options, ""), [](const std::string& line) { ADD_FAILURE() << line; }, EarlierRecording::stays);
    std::ostringstream out;
    recording.end(out);
  }
  EXPECT_TRUE(std::filesystem::exists(file("run.mcap")));
  EXPECT_FALSE(std::filesystem::exists(file("run-2.mcap")));
  EXPECT_TRUE(std::filesystem::exists(file("run-3.mcap")));
}

TEST_F(RunThatIsRecorded, ByRobotsThatStartTogetherUsesANameForEach) {
  constexpr int kRobots = 8;
  RunOptions options;
  options.robot = "companion";
  options.record = file("run.mcap");
  std::vector<std::future<std::string>> robots;
  robots.reserve(kRobots);
  for (int robot = 0; robot < kRobots; ++robot) {
    robots.push_back(std::async(std::launch::async, [&options] {
      RunRecording recording(
          recorder_options(options, ""), [](const std::string& line) { ADD_FAILURE() << line; },
          EarlierRecording::stays);
      std::ostringstream out;
      recording.end(out);
      return out.str();
    }));
  }
  std::set<std::string> names;
  for (std::future<std::string>& robot : robots) names.insert(robot.get());
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kRobots)) << *names.begin();
  EXPECT_TRUE(std::filesystem::exists(file("run-8.mcap")));
  EXPECT_FALSE(std::filesystem::exists(file("run-9.mcap")));
}

TEST_F(RunThatIsRecorded, IsNotMixedWithAnotherRunOfTheSameFile) {
  const TemporaryFolder other;
  ChildProgram first(folder_.path(), {"run", "--realtime", "--seconds", "600", "--width", "160", "--no-pictures",
                                      "--record", file("run.mcap")});
  ASSERT_TRUE(await([&] { return std::filesystem::exists(file("run.mcap")) || first.has_ended(); }));
  ASSERT_TRUE(first.await("0.50 s"));
  ChildProgram second(other.path(),
                      {"run", "--seconds", "3", "--width", "160", "--no-pictures", "--record", file("run.mcap")});
  EXPECT_EQ(second.wait(), 2);
  EXPECT_EQ(second.err(), "reorient: " + file("run.mcap") +
                              ": expected a file that no other process writes, found a recording in progress; name "
                              "another file\n");
  first.kill(SIGTERM);
  EXPECT_EQ(first.wait(), 128 + SIGTERM) << first.err();
  const ProgramRun replayed = run_reorient({"replay", file("run.mcap")});
  EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
}

TEST_F(RunThatIsRecorded, PrintsThatItsFileIsGone) {
  ChildProgram run(folder_.path(), {"run", "--realtime", "--seconds", "600", "--width", "160", "--no-pictures",
                                    "--record", file("run.mcap")});
  ASSERT_TRUE(run.await("0.50 s"));
  std::filesystem::rename(file("run.mcap"), file("moved.mcap"));
  run.kill(SIGTERM);
  EXPECT_EQ(run.wait(), 128 + SIGTERM) << run.err();
  EXPECT_NE(run.err().find("reorient: the recording is lost: " + file("run.mcap") + ": expected the recording of "),
            std::string::npos)
      << run.err();
  EXPECT_NE(run.out().find("recording: " + file("run.mcap") + ", 0 frames, 0.0 MB"), std::string::npos) << run.out();
}

TEST_F(RunThatIsRecorded, RefusesTimesOutsideOfTheRecording) {
  run_shortly({"--record", file("run.mcap")});
  run_reorient({"recording", "cut", file("run.mcap"), "--from", "2", "--out", file("late.mcap")});
  const std::pair<std::vector<std::string>, const char*> mistakes[] = {
      {{"replay", "run", "--from", "100"}, "--from 100: expected at most 3.00, where the recording ends"},
      {{"replay", "run", "--from", "2", "--to", "1"}, "--from 2 --to 1: expected --to at or after --from"},
      {{"replay", "run", "--from", "nan"}, "--from: expected a non-negative number of seconds, found 'nan'"},
      {{"replay", "run", "--to", "-1"}, "--to: expected a non-negative number of seconds, found '-1'"},
      {{"replay", "late", "--to", "1"}, "--to 1: expected at least 2.00, where the recording begins"},
      {{"recording", "pictures", "run", "--at", "500"}, "--at 500: expected at most 3.00, where the recording ends"},
      {{"recording", "pictures", "run", "--at", "nan"}, "--at: expected a non-negative number of seconds, found 'nan'"},
      {{"recording", "cut", "run", "--from", "nan", "--to", "2", "--out", "part"},
       "--from: expected a non-negative number of seconds, found 'nan'"},
      {{"recording", "cut", "run", "--from", "50", "--out", "part"},
       "--from 50: expected at most 3.00, where the recording ends"},
      {{"record-test", "run", "--from", "nan", "--to", "nan", "--name", "x"},
       "--from: expected a non-negative number of seconds, found 'nan'"},
  };
  for (auto [words, why] : mistakes) {
    for (std::string& word : words) {
      if (word == "run" || word == "late" || word == "part") word = file((word += ".mcap").c_str());
    }
    const ProgramRun run = run_reorient(words);
    EXPECT_EQ(run.code, 2) << why;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(file("part.mcap")));
  const ProgramRun beyond = run_reorient({"replay", file("run.mcap"), "--from", "1", "--to", "9"});
  EXPECT_EQ(beyond.code, 0) << "up to its end";
  EXPECT_EQ(beyond.err, "reorient: --to 9: the recording ends at 3.00 s\n");
  const ProgramRun cut =
      run_reorient({"recording", "cut", file("run.mcap"), "--from", "2", "--to", "9", "--out", file("part.mcap")});
  EXPECT_EQ(cut.code, 0);
  EXPECT_EQ(cut.err, "reorient: --to 9: the recording ends at 3.00 s\n");
  EXPECT_EQ(run_reorient({"replay", file("run.mcap"), "--to", "3"}).err, "");
  EXPECT_EQ(run_reorient({"replay", file("late.mcap"), "--to", "2"}).code, 0) << "the time that info prints";
}

TEST_F(RunThatIsRecorded, RefusesInvalidOptionsWithOneLine) {
  const std::string text = folder_.write("text.mcap", "no recording").string();
  run_shortly({"--record", file("run.mcap")});
  const std::pair<std::vector<std::string>, const char*> mistakes[] = {
      {{"run", "--record", "/nowhere/run.mcap"}, "--record"},
      {{"run", "--record", folder_.path().string()}, "--record"},
      {{"run", "--record", file("x.mcap"), "--record-images", "some"},
       "--record-images: expected lossless, every:N (each Nth frame) or none, found 'some'"},
      {{"run", "--record", file("x.mcap"), "--record-images", "every:0"},
       "--record-images: expected lossless, every:N (each Nth frame) or none, found 'every:0'"},
      {{"run", "--record", file("x.mcap"), "--view-images", "jpeg:101"},
       "--view-images: expected jpeg:Q (a quality from 1 to 100) or none, found 'jpeg:101'"},
      {{"run", "--record", file("x.mcap"), "--view-images", "png"},
       "--view-images: expected jpeg:Q (a quality from 1 to 100) or none, found 'png'"},
      {{"run", "--record", file("x.mcap"), "--view-particles", "every:"},
       "--view-particles: expected every:N (each Nth frame) or none, found 'every:'"},
      {{"replay", "/nowhere.mcap"}, "/nowhere.mcap: it cannot be read: No such file"},
      {{"replay", text}, "at byte 0: expected the start mark of an MCAP file, found other bytes; name a recording"},
      {{"replay", folder_.path().string()}, "expected a recording, found something that is not a file"},
      {{"replay", file("run.mcap"), "--set", "orientation.hold_tme=2"}, "orientation.hold_tme"},
      {{"replay", file("run.mcap"), "--scripts", "/nowhere"}, "/nowhere"},
      {{"recording", "info", text}, "name a recording"},
      {{"recording", "cut", file("run.mcap")}, "expected --out ("},
      {{"recording", "recover", file("run.mcap"), "--out", file("run.mcap")},
       "the recording and --out: expected two files, found the same one"},
      {{"recording", "export", file("run.mcap"), "--csv", "world", "--out", file("run.mcap")},
       "expected two files, found the same one"},
      {{"recording", "export", file("run.mcap"), "--csv", "world", "--out", text},
       "expected a new file or a table of this command, found another file, which was not changed"},
      {{"recording", "recover", file("run.mcap"), "--out", text},
       "expected a new file or a recording, found another file"},
      {{"run", "--record", file("x.mcap"), "--record-rotate", "often"},
       "--record-rotate: expected a size or a time, as in 500MB, 2GB, 90s or 10min, found 'often'"},
      {{"run", "--record", file("x.mcap"), "--record-rotate", "-5min"},
       "--record-rotate: expected a size or a time, as in 500MB, 2GB, 90s or 10min, found '-5min'"},
      {{"recording", "export", file("run.mcap"), "--csv", "everything"}, "--csv"},
      {{"recording", "export", file("run.mcap"), "--csv", "world", "--out", "/nowhere/x.csv"}, "--out"},
      {{"recording", "pictures", file("run.mcap")}, "expected --at ("},
      {{"recording", "look"}, "expected a command: "},
  };
  for (const auto& [words, why] : mistakes) {
    const ProgramRun run = run_reorient(words);
    EXPECT_EQ(run.code, 2) << why;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(file("part.mcap")));
}

}  // namespace
}  // namespace reorient
