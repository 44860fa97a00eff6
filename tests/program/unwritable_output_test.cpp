// SPDX-License-Identifier: MIT
// If one output cannot be written, the others are still written.
#include <csignal>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/program/less_of_a_user.h"
#include "tests/program/program_run.h"
#include "tests/program/run_with_all_outputs.h"

namespace reorient {
namespace {

class UnwritableOutput : public RunWithAllOutputs {
 protected:
  UnwritableOutput() { std::filesystem::permissions(folder.path(), std::filesystem::perms::all); }
  ~UnwritableOutput() override { allow(std::filesystem::perms::all); }

  /// Sets the permissions of the folder of the pictures.
  void allow(std::filesystem::perms permissions) const {
    std::filesystem::create_directories(folder.path() / "pictures");
    std::filesystem::permissions(folder.path() / "pictures", permissions);
  }
  static constexpr std::filesystem::perms kOnlyToRead =
      std::filesystem::perms::all & ~(std::filesystem::perms::owner_write | std::filesystem::perms::group_write |
                                      std::filesystem::perms::others_write);
};

TEST_F(UnwritableOutput, WritesTheOtherOutputsIfOnePictureCannotBeWritten) {
  std::filesystem::create_directories(folder.path() / "pictures" / "world_view.png" / "in the way");
  ChildProgram run(folder.path(), words({"--seconds", "1"}));
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("reorient: cannot write '" + (folder.path() / "pictures" / "world_view.png").string()),
            std::string::npos)
      << run.err();
  EXPECT_EQ(json()["scenario"], "patrol");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "pictures" / "confidences.png"));
  EXPECT_NE(run.out().find("wrong: "), std::string::npos);
}

TEST_F(UnwritableOutput, ReportsEachOutputWhoseFolderWasRemoved) {
  ChildProgram run(folder.path(), words());
  ASSERT_TRUE(run.await("patrol: "));
  std::filesystem::remove_all(folder.path() / "pictures");
  run.kill(SIGTERM);  // the run lasts until the folder is gone, however long that takes
  EXPECT_EQ(run.wait(), kBadInput);
  for (const char* picture : kPictures) EXPECT_NE(run.err().find(picture), std::string::npos) << run.err();
  EXPECT_EQ(json()["scenario"], "patrol");
}

TEST_F(UnwritableOutput, WritesTheFilesIfTheReaderOfItsOutputHasEnded) {
  ChildProgram run(folder.path(), words({"--seconds", "1"}), [] {
    int ends[2];
    if (pipe(ends) != 0) _exit(126);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
  });
  EXPECT_EQ(run.wait(), 128 + SIGPIPE);
  EXPECT_EQ(run.err().find("reorient: "), std::string::npos) << "it ends quietly: " << run.err();
  expect_all_outputs();
}

TEST_F(UnwritableOutput, WritesSmallFilesBelowASizeLimit) {
  ChildProgram run(folder.path(), words({"--seconds", "1"}), files_up_to(16 * 1024));
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("world_view.png': File too large"), std::string::npos) << run.err();
  EXPECT_EQ(json()["scenario"], "patrol");
  EXPECT_EQ(left_overs(), 0);
}

TEST_F(UnwritableOutput, ReportsTheErrorOfADevice) {
  ChildProgram run(folder.path(), {"run", "--seconds", "1", "--width", "160", "--no-pictures", "--json", "/dev/full"});
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("cannot write '/dev/full': No space left on device"), std::string::npos) << run.err();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(UnwritableOutput, DoesNotFollowALinkBesideTheFile) {
  folder.write("precious.txt", "mine");
  std::filesystem::create_symlink(folder.path() / "precious.txt", folder.path() / "run.json.partial");
  ChildProgram run(folder.path(), words({"--seconds", "1"}));
  EXPECT_EQ(run.wait(), kWrong);
  EXPECT_EQ(read_text(folder.path() / "precious.txt"), "mine");
  expect_all_outputs();
}

TEST_F(UnwritableOutput, WorksBesideAnotherRunInTheSameFolder) {
  TemporaryFolder other;
  ChildProgram first(folder.path(), words({"--seconds", "2"}));
  ChildProgram second(other.path(), words({"--seconds", "2"}));
  EXPECT_EQ(first.wait(), kWrong);
  EXPECT_EQ(second.wait(), kWrong);
  expect_all_outputs();
  EXPECT_EQ(left_overs(), 0);
}

TEST_F(UnwritableOutput, IsReportedBeforeTheRunIfAFolderIsNotWritable) {
  allow(kOnlyToRead);
  const std::string pictures = (folder.path() / "pictures").string();
  const std::string summary = pictures + "/run.json";
  const std::pair<std::vector<std::string>, std::string> runs[] = {
      {words(), "reorient: cannot write into '" + pictures + "': Permission denied; name another folder with --out\n"},
      {{"run", "--no-pictures", "--json", summary},
       "reorient: cannot write '" + summary + "': Permission denied; name another file with --json\n"}};
  for (const auto& [all, complaint] : runs) {
    ChildProgram run(folder.path(), all, become_an_ordinary_user);
    const int code = run.wait();
    if (code == kCannot) GTEST_SKIP() << "this user cannot run a program as a user with fewer permissions";
    EXPECT_EQ(code, kBadInput);
    EXPECT_EQ(run.out(), "");
    EXPECT_EQ(run.err(), complaint);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "run.json"));
  }
}

TEST_F(UnwritableOutput, ReportsEachPictureIfItsFolderBecomesReadOnly) {
  allow(std::filesystem::perms::all);
  ChildProgram run(folder.path(), words(), become_an_ordinary_user);
  const bool began = run.await("patrol: ");
  allow(kOnlyToRead);
  run.kill(SIGTERM);  // the run lasts until then, however long that takes
  const int code = run.wait();
  if (code == kCannot) GTEST_SKIP() << "this user cannot run a program as a user with fewer permissions";
  ASSERT_TRUE(began) << run.err();
  EXPECT_EQ(code, kBadInput);
  for (const char* name : kPictures) {
    EXPECT_NE(run.err().find("reorient: cannot write '" + picture(name).string() + "': Permission denied\n"),
              std::string::npos)
        << run.err();
  }
  EXPECT_EQ(json()["scenario"], "patrol");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "tuned.toml"));
  EXPECT_EQ(left_overs(), 0);
}

class FullDisk : public UnwritableOutput, public ::testing::WithParamInterface<bool> {};

TEST_P(FullDisk, GetsFilesThatFitAndNoPartialFiles) {
  allow(std::filesystem::perms::all);
  const bool as_ordinary_user = GetParam();
  const std::filesystem::path kept = folder.path() / "kept";
  ChildProgram run(folder.path(), words({"--seconds", "1"}), [&] {
    if (as_ordinary_user) become_an_ordinary_user();
    put_a_small_disk(folder.path() / "pictures", kept, "64k");
  });
  const int code = run.wait();
  if (code == kCannot) GTEST_SKIP() << "this user may not have a disk of its own (user namespaces)";
  EXPECT_EQ(code, kBadInput) << run.err();
  int missing = 0;
  for (const char* name : kPictures) {
    const bool is_told = run.err().find("reorient: cannot write '" + picture(name).string() +
                                        "': No space left on device\n") != std::string::npos;
    EXPECT_NE(is_told, std::filesystem::exists(kept / name)) << name << "\n" << run.err();
    if (is_told) {
      ++missing;
    } else {
      EXPECT_TRUE(is_whole_picture(kept / name)) << name;
    }
  }
  EXPECT_GT(missing, 0);
  EXPECT_LT(missing, 4) << "a small picture fits";
  EXPECT_EQ(json()["scenario"], "patrol");
  EXPECT_EQ(left_overs(), 0);
  EXPECT_NE(run.out().find("digest: "), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Of, FullDisk, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "AnOrdinaryUser" : "ThisUser"; });

}  // namespace
}  // namespace reorient
