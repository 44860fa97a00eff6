// SPDX-License-Identifier: MIT
// `reorient run --model` and `reorient model`: the model of a room that is loaded and saved by runs.
#include <algorithm>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "program/model/model_file.h"
#include "program/model/model_keeper.h"
#include "tests/perception/room/saved_models.h"
#include "tests/program/child_program.h"
#include "tests/program/less_of_a_user.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"

namespace reorient {
namespace {

using test::some_model;

class RunWithAModel : public ::testing::Test {
 protected:
  std::string file_of(const SavedModel& model, const std::string& name = "yesterday.model") const {
    const std::filesystem::path path = folder.path() / name;
    write_model_file(model, path);
    return path.string();
  }
  std::string file_of(const test::ModelBytes& bytes) const {
    return folder.write("hall.model", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}).string();
  }
  /// The run does not start, prints one line with the reason, and the file is unchanged.
  static void expect_refused(const std::string& file, const std::vector<std::string>& more,
                             const std::string& complaint) {
    const std::string before = read_text(file);
    std::vector<std::string> words{"--model", file};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun refused = run_shortly(words);
    EXPECT_EQ(refused.code, kBadInput);
    EXPECT_EQ(refused.out, "");
    EXPECT_NE(refused.err.find(complaint), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_TRUE(refused.err.starts_with("reorient: --model " + file + ": ")) << refused.err;
    EXPECT_EQ(read_text(file), before);
  }

  TemporaryFolder folder;
  const std::string file = (folder.path() / "hall.model").string();
};

TEST_F(RunWithAModel, CreatesTheFileAndContinuesItInTheNextRun) {
  const std::string without = digest_of(run_shortly({}));
  const ProgramRun first = run_shortly({"--model", file});
  EXPECT_EQ(digest_of(first), without) << "saving changes no frame";
  EXPECT_NE(first.out.find("model: " + file + " (saved)\n"), std::string::npos) << first.out;
  const SavedModel learned = read_model_file(file);
  EXPECT_GT(learned.learned, 1.0);
  EXPECT_GT(learned.model.known_tiles(), 10);

  const std::string copy = (folder.path() / "copy.model").string();
  std::filesystem::copy_file(file, copy);
  const ProgramRun second = run_shortly({"--model", file});
  EXPECT_NE(digest_of(second), without);
  EXPECT_EQ(digest_of(run_shortly({"--model", copy})), digest_of(second)) << "the same file gives the same digest";
  EXPECT_EQ(read_text(copy), read_text(file)) << "and the same file";
  EXPECT_GT(read_model_file(file).learned, learned.learned + 1.0);
  EXPECT_GE(read_model_file(file).model.known_tiles(), learned.model.known_tiles());
}

TEST_F(RunWithAModel, ThatLearnsNothingDoesNotChangeTheFile) {
  const auto run_for_a_moment = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "--seconds", "0.2", "--width", "160", "--no-pictures", "--log", "off"});
    return run_reorient(more);
  };
  const ProgramRun none = run_for_a_moment({"--model", file});
  EXPECT_NE(none.out.find("model: " + file + " (unchanged: nothing new was learned)\n"), std::string::npos) << none.out;
  EXPECT_FALSE(std::filesystem::exists(file));
  const std::string good = file_of(some_model(1));
  const std::string before = read_text(good);
  EXPECT_EQ(run_for_a_moment({"--model", good}).err.find("reorient:"), std::string::npos);
  EXPECT_EQ(read_text(good), before);
  EXPECT_EQ(run_for_a_moment({"--model", good, "--sides-changed"}).err.find("reorient:"), std::string::npos);
  EXPECT_EQ(read_text(good), before);
}

TEST_F(RunWithAModel, RotatesItIfTheSidesHaveChanged) {
  const SavedModel model = some_model(1);
  SavedModel turned = model;
  turned.rotate_by_180_degrees();
  const std::string one = file_of(model, "one"), other = file_of(turned, "other");
  EXPECT_EQ(digest_of(run_shortly({"--model", one, "--sides-changed"})), digest_of(run_shortly({"--model", other})));
}

TEST_F(RunWithAModel, RefusesADamagedModel) {
  const std::vector<test::DamagedModel> all = test::damaged_models();
  EXPECT_GE(all.size(), 48u);
  for (const test::DamagedModel& damaged : all) {
    SCOPED_TRACE(damaged.what);
    expect_refused(file_of(damaged.bytes), {}, damaged.complaint);
  }
  expect_refused(file_of(test::damaged_models()[1].bytes), {}, "it was not changed; name a new file");
}

TEST_F(RunWithAModel, RefusesAModelWithOtherParameters) {
  const std::string good = file_of(some_model(1));
  expect_refused(good, {"--set", "wall.columns=24"},
                 "it was learned with other parameters: wall.columns=48; set the same values with --set, or name "
                 "another file with --model");
  expect_refused(good, {"--set", "color.dark_below=80"}, "color.dark_below=85");
  expect_refused(good, {"--params", "paper"}, "light_adaptation.enabled=true");
  expect_refused(good, {"--no-room-awareness"}, "expected room awareness, found --no-room-awareness");
}

TEST_F(RunWithAModel, RefusesWhatIsNotAFile) {
  std::filesystem::create_directory(folder.path() / "folder");
  mkfifo((folder.path() / "pipe").c_str(), 0600);
  for (const auto& [name, complaint] :
       {std::pair("folder", ", found a folder"), {"pipe", "expected a model of a room, found another type of file"}}) {
    const ProgramRun refused = run_shortly({"--model", (folder.path() / name).string()});
    EXPECT_EQ(refused.code, kBadInput);
    EXPECT_NE(refused.err.find(complaint), std::string::npos) << refused.err;
  }
  const ProgramRun nowhere = run_shortly({"--model", (folder.path() / "no" / "where").string()});
  EXPECT_EQ(nowhere.code, kBadInput);
  EXPECT_NE(nowhere.err.find("No such file or directory; name another file with --model"), std::string::npos);
  const ProgramRun alone = run_shortly({"--sides-changed"});
  EXPECT_EQ(alone.code, kBadInput);
  EXPECT_NE(alone.err.find("--sides-changed: expected together with --model, found alone"), std::string::npos)
      << alone.err;
}

TEST_F(RunWithAModel, RefusesAnUnreadableModel) {
  const std::string good = file_of(some_model(1), "hall.model");
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  std::filesystem::permissions(good, std::filesystem::perms::none);
  ChildProgram run(folder.path(), {"run", "--model", good, "--no-pictures", "--seconds", "1"}, become_an_ordinary_user);
  const int code = run.wait();
  if (code == kCannot) GTEST_SKIP() << "this user cannot run a program as a user with fewer permissions";
  EXPECT_EQ(code, kBadInput);
  EXPECT_NE(run.err().find(
                "expected a model of a room, found one that cannot be read: Permission denied; it was not changed"),
            std::string::npos)
      << run.err();
}

TEST_F(RunWithAModel, KeepsOtherOutputsAndTheOldFileIfItCannotBeSaved) {
  SavedModel hardly_learned = some_model(1);
  hardly_learned.learned = 2.0;  // s: too short, so that the robot continues to learn
  const std::string good = file_of(hardly_learned, "hall.model");
  const std::string before = read_text(good);
  ASSERT_GT(before.size(), 16u * 1024u);
  const std::string json = (folder.path() / "run.json").string();
  ChildProgram run(folder.path(),
                   {"run", "--model", good, "--no-pictures", "--seconds", "10", "--width", "160", "--json", json},
                   files_up_to(16 * 1024));
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("reorient: cannot write '" + good + "': File too large\n"), std::string::npos) << run.err();
  EXPECT_NE(run.out().find("model: " + good + " (not saved)\n"), std::string::npos) << run.out();
  EXPECT_NE(run.out().find("digest: "), std::string::npos);
  EXPECT_NE(read_text(json).find("\"scenario\""), std::string::npos);
  EXPECT_EQ(read_text(good), before);
}

TEST_F(RunWithAModel, SavesItWhenInterrupted) {
  // Ten minutes of the robot: the run does not end before the signal.
  ChildProgram run(folder.path(), {"run", "patrol", "--model", file, "--no-pictures", "--width", "160"});
  ASSERT_TRUE(run.await("  10.0 s  ")) << run.err();
  run.kill(SIGTERM);
  EXPECT_EQ(run.wait(), 128 + SIGTERM);
  EXPECT_GT(read_model_file(file).learned, 5.0);
}

/// The frames of a run for the keeper, one at a time.
class ModelKeeperTest : public RunWithAModel {
 protected:
  static FrameRecord frame_of(const SavedModel& model, double time) {
    FrameRecord frame;
    frame.world.time = time;
    frame.world.trained_seconds = model.learned;
    frame.room.basis = model.basis;
    frame.room.model.assign(model.model.tiles().begin(), model.model.tiles().end());
    return frame;
  }
  static SavedModel longer_learned(SavedModel model, double seconds) {
    model.learned += seconds;
    return model;
  }
};

TEST_F(ModelKeeperTest, LosesLittleIfTheRobotIsSwitchedOff) {
  const auto saved = [this] { return std::filesystem::exists(file) ? read_model_file(file).learned : 0.0; };
  const SavedModel model = some_model(1);
  ModelKeeper keeper(file, std::nullopt, false);
  double time = 0.0;
  const auto is_saved_after_a_frame = [&] {
    keeper.observe(frame_of(longer_learned(model, time), time), SceneTruth());
    time += 0.5;
    return saved() >= model.learned + 30.0;
  };
  EXPECT_TRUE(await(is_saved_after_a_frame)) << "the run has not ended";
}

TEST_F(ModelKeeperTest, KeepsTheAxesOfTheFileWhenTheTeamsChangeSides) {
  const SavedModel in_the_file = some_model(1);
  SavedModel turned = in_the_file;
  turned.rotate_by_180_degrees();
  for (const bool turned_at_first : {false, true}) {
    for (const bool half_time : {false, true}) {
      ModelKeeper keeper(file, turned_at_first ? turned : in_the_file, turned_at_first);
      FrameRecord last = frame_of(longer_learned(turned_at_first != half_time ? turned : in_the_file, 1.0), 9.0);
      last.world.sides_changed = half_time;
      keeper.finish(last, SceneTruth());
      keeper.save();
      EXPECT_EQ(keeper.outcome(), "saved");
      EXPECT_EQ(test::bytes_of(read_model_file(file)), test::bytes_of(longer_learned(in_the_file, 1.0)));
    }
  }
}

TEST_F(ModelKeeperTest, KeepsABiasForTheCalibrationThatItWasLearnedWith) {
  constexpr std::uint64_t kBody = 7, kCalibrated = 0x1234;
  SavedModel model = some_model(1);
  FrameRecord last = frame_of(longer_learned(model, 1.0), 9.0);
  last.world.body = kBody;
  last.world.camera_bias.deviation = 0.001;
  ModelKeeper keeper(file, std::nullopt, false, kCalibrated);
  keeper.finish(last, SceneTruth());
  keeper.save();
  const auto body_for = [&](std::uint64_t mounting) {
    return as_mounted(read_model_file(file), mounting)->camera_bias.value().body;
  };
  EXPECT_EQ(body_for(kCalibrated), kBody);
  EXPECT_NE(body_for(0), kBody) << "without a calibration";
  EXPECT_NE(body_for(0x1235), kBody) << "with another one";
  EXPECT_FALSE(as_mounted(std::nullopt, kCalibrated));
}

TEST_F(ModelKeeperTest, KeepsTheRoomThatTheRunForgot) {
  const SavedModel good = some_model(1);
  write_model_file(good, file);
  const std::string before = read_text(file);
  const SavedModel restarts = longer_learned(some_model(1, 0, 0.1, 0, 5), 3.0);
  SavedModel of_another_wall = longer_learned(good, 3.0);
  of_another_wall.basis.wall.radius = 9.0;
  for (const SavedModel& end : {restarts, of_another_wall}) {
    ModelKeeper keeper(file, good, false);
    keeper.observe(frame_of(end, 1.0), SceneTruth());
    keeper.finish(frame_of(end, 2.0), SceneTruth());
    EXPECT_THROW(keeper.save(), std::runtime_error);
    EXPECT_EQ(keeper.outcome(), "not saved");
    EXPECT_EQ(read_text(file), before);
  }
}

class ModelCommand : public RunWithAModel {
 protected:
  static ProgramRun model(const std::vector<std::string>& words) {
    std::vector<std::string> all{"model"};
    all.insert(all.end(), words.begin(), words.end());
    return run_reorient(all);
  }
  static void expect_bad(const std::vector<std::string>& words, const std::string& complaint) {
    const ProgramRun refused = model(words);
    EXPECT_EQ(refused.code, kBadInput);
    EXPECT_EQ(refused.out, "");
    EXPECT_NE(refused.err.find(complaint), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
};

TEST_F(ModelCommand, KeepsExistingFilesIfItsOutputCannotBeWritten) {
  const std::string one = file_of(some_model(1), "one.model"), other = file_of(some_model(1, 1), "other.model");
  const std::string out = (folder.path() / "out").string();
  for (const auto& words :
       {std::vector<std::string>{"model", "merge", one, other, "--out", out}, {"model", one, "--picture", out}}) {
    // A file of the same type, which would be replaced.
    const std::string before = words[1] == "merge" ? read_text(other) : "\x89PNG, and what was here";
    folder.write("out", before);
    ChildProgram run(folder.path(), words, files_up_to(4 * 1024));
    EXPECT_EQ(run.wait(), kBadInput) << words[1];
    EXPECT_NE(run.err().find("reorient: cannot write '" + out + "': File too large\n"), std::string::npos) << run.err();
    EXPECT_EQ(read_text(out), before);
  }
}

TEST_F(ModelCommand, ShowsAndDrawsTheKnownTiles) {
  const std::string good = file_of(some_model(1, 0, 0.1, 0, 40)), picture = (folder.path() / "hall.png").string();
  const ProgramRun shown = model({good, "--picture", picture});
  EXPECT_EQ(shown.code, kSuccess) << shown.err;
  EXPECT_TRUE(shown.out.starts_with(good + ", saved ")) << shown.out;
  for (const char* line :
       {"\n  learned for 40.0 s\n", "\n  wall: 8 m from the field's center, 0.7 to 5.5 m high, 4 rows of 48 columns\n",
        "\n  parameters: as by default\n", "\n  known: 160 of 192 tiles; row by row, from the top: 40 40 40 40\n",
        "\n  coverage: 0.83 (enough for decisions)\n", "(distinguishable from itself rotated by 180 degrees)\n",
        "(a rotation by 180 degrees changes it like other rotations)\n"})
    EXPECT_NE(shown.out.find(line), std::string::npos) << line << "\n" << shown.out;
  EXPECT_TRUE(read_text(picture).starts_with("\x89PNG"));
  SavedModel other = some_model(1, 0, 0.1, 0, 4);
  other.basis.wall.radius = 9.0;
  const ProgramRun little = model({file_of(other)});
  EXPECT_NE(little.out.find("parameters: wall.radius=9\n"), std::string::npos) << little.out;
  EXPECT_NE(little.out.find("too little for decisions"), std::string::npos);
  EXPECT_NE(little.out.find("no evidence about the pose"), std::string::npos);
}

TEST_F(ModelCommand, ReportsWhereTwoModelsDifferAndWhetherOneIsRotated) {
  const std::string one = file_of(some_model(1, 0), "one"), other = file_of(some_model(1, 1), "other");
  SavedModel half_a_turn_on = some_model(1, 1);
  half_a_turn_on.rotate_by_180_degrees();
  const std::string turned = file_of(half_a_turn_on, "turned");
  const ProgramRun same = model({"compare", one, other});
  EXPECT_EQ(same.code, kSuccess) << same.err;
  EXPECT_TRUE(same.out.starts_with("A: " + one + "\nB: " + other + "\nboth know 192 tiles; only A 0, only B 0\n"));
  EXPECT_NE(same.out.find("verdict: the same room, seen from the same end of the field\n"), std::string::npos)
      << same.out;
  const ProgramRun different = model({"compare", one, turned});
  EXPECT_EQ(different.code, kWrong);
  EXPECT_NE(different.out.find("B looks like A rotated by 180 degrees"), std::string::npos) << different.out;
  const ProgramRun hall = model({"compare", one, file_of(some_model(2), "hall")});
  EXPECT_EQ(hall.code, kWrong);
  EXPECT_NE(hall.out.find("verdict: they are not of the same room"), std::string::npos) << hall.out;
}

TEST_F(ModelCommand, DoesNotReplaceAFileOfAnotherType) {
  const std::string one = file_of(some_model(1, 0), "one"), other = file_of(some_model(1, 1), "other");
  const std::string notes = folder.write("notes.txt", "mine").string();
  expect_bad(
      {one, "--picture", notes},
      "--picture " + notes + ": expected a new file or a PNG picture, found another file, which was not changed");
  expect_bad({"merge", one, other, "--out", notes},
             "--out " + notes + ": expected a new file or a model, found another file, which was not changed");
  EXPECT_EQ(read_text(notes), "mine");
  const std::string picture = (folder.path() / "one.png").string(), both = file_of(some_model(3), "both");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(model({one, "--picture", picture}).code, kSuccess);
  EXPECT_EQ(model({"merge", one, other, "--out", both}).code, kSuccess);
}

TEST_F(ModelCommand, MergesTwoModelsUnlessOneIsRotated) {
  const std::string one = file_of(some_model(1, 0), "one"), other = file_of(some_model(1, 1), "other");
  SavedModel half_a_turn_on = some_model(1, 1);
  half_a_turn_on.rotate_by_180_degrees();
  const std::string turned = file_of(half_a_turn_on, "turned"), both = (folder.path() / "both").string();
  const ProgramRun done = model({"merge", one, other, "--out", both});
  EXPECT_EQ(done.code, kSuccess) << done.err;
  EXPECT_NE(done.out.find("learned for 80.0 s"), std::string::npos) << done.out;
  const std::string merged_bytes = read_text(both);
  expect_bad({"merge", one, turned, "--out", both}, "the teams changed sides; merge them with --sides-changed");
  expect_bad({"merge", one, other, "--out", both, "--sides-changed"}, "leave out --sides-changed");
  expect_bad({"merge", one, file_of(some_model(2), "hall"), "--out", both},
             ": expected models of the same room, found a mean difference of ");
  EXPECT_EQ(read_text(both), merged_bytes);
  EXPECT_EQ(model({"merge", one, turned, "--out", both, "--sides-changed"}).code, kSuccess);
  EXPECT_EQ(read_text(both), merged_bytes);
  SavedModel other_wall = some_model(1);
  other_wall.basis.wall.radius = 9.0;
  expect_bad({"merge", one, file_of(other_wall, "far"), "--out", both},
             "its parameters differ from those of " + one + ": wall.radius=9; only models with the same parameters");
  expect_bad({"merge", one, other}, "expected --out (");
  expect_bad({"merge", one, other, "--out", (folder.path() / "no" / "where").string()},
             "No such file or directory; name another file with --out");
  EXPECT_EQ(read_text(both), merged_bytes);
}

TEST_F(ModelCommand, RefusesTheSameModelTwice) {
  const std::string one = file_of(some_model(1), "one"), copy = file_of(some_model(1), "copy");
  const std::string other = file_of(some_model(1, 1), "other"), before = read_text(one);
  expect_bad({"merge", one, one, "--out", one}, "expected two files, found the same one");
  expect_bad({"merge", one, one, "--out", (folder.path() / "both").string()},
             "expected two different models, found the same one");
  expect_bad({"merge", one, copy, "--out", (folder.path() / "both").string()},
             "expected two different models, found the same one");
  expect_bad({"merge", one, other, "--out", other},
             "a model to merge and --out: expected two files, found the same one");
  expect_bad({one, "--picture", one}, "the model and --picture: expected two files, found the same one");
  EXPECT_EQ(read_text(one), before);
  const ProgramRun same = model({"compare", one, copy});
  EXPECT_NE(same.out.find("no tile differs\n"), std::string::npos) << same.out;
  EXPECT_EQ(same.out.find("differ most"), std::string::npos) << same.out;
}

TEST_F(ModelCommand, RefusesFilesThatAreNotModels) {
  expect_bad({}, "expected a file that 'reorient run --model FILE' wrote, found none");
  expect_bad({(folder.path() / "none").string()}, "expected a model of a room, found none; name a file that");
  expect_bad({folder.path().string()}, "expected a model of a room, found a folder; name a file that");
  expect_bad({folder.write("long", std::string(std::size_t{2} << 20, 'x')).string()},
             "expected a model of a room of at most 1 MiB, found a larger one");
  for (const test::DamagedModel& damaged : test::damaged_models()) {
    SCOPED_TRACE(damaged.what);
    expect_bad({file_of(damaged.bytes)}, damaged.complaint);
  }
}

}  // namespace
}  // namespace reorient
