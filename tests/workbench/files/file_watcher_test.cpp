// SPDX-License-Identifier: MIT
// Changed files are noticed, in place or by renaming, without sleeping.
#include "workbench/files/file_watcher.h"

#include <chrono>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class Watcher : public ::testing::TestWithParam<FileWatcher::Means> {
 protected:
  /// How often something was reported within this many seconds of the watcher's own clock.
  int reports(FileWatcher& watcher, double seconds = 1.0) {
    int count = 0;
    for (const double end = time_ + seconds; time_ < end; time_ += 0.01) count += watcher.poll(time_) ? 1 : 0;
    return count;
  }

  TemporaryFolder folder_;
  double time_ = 100.0;
};

TEST_P(Watcher, ReportsNothingWhileNothingChanges) {
  folder_.write("behaviors/a.lua", "1");
  FileWatcher watcher(folder_.path(), GetParam());
  EXPECT_EQ(reports(watcher), 0);
}

TEST_P(Watcher, NoticesAFileThatIsSavedInPlace) {
  folder_.write("behaviors/a.lua", "1");
  FileWatcher watcher(folder_.path(), GetParam());
  folder_.write("behaviors/a.lua", "22");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, NoticesAFileThatIsRenamedIntoPlace) {
  folder_.write("behaviors/a.lua", "1");
  FileWatcher watcher(folder_.path(), GetParam());
  folder_.write_by_rename("behaviors/a.lua", "22");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, ReportsFilesThatAreSavedTogetherOnce) {
  for (const char* file : {"a", "b", "c"}) folder_.write(std::string("lib/") + file + ".lua", "1");
  FileWatcher watcher(folder_.path(), GetParam());
  for (const char* file : {"a", "b", "c"}) folder_.write(std::string("lib/") + file + ".lua", "22");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, NoticesFilesInAFolderThatIsNew) {
  FileWatcher watcher(folder_.path(), GetParam());
  folder_.write("new/deep/a.lua", "1");
  EXPECT_EQ(reports(watcher), 1);
  folder_.write("new/deep/a.lua", "22");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, NoticesAFolderThatIsReplaced) {
  folder_.write("lib/a.lua", "1");
  FileWatcher watcher(folder_.path(), GetParam());
  std::filesystem::remove_all(folder_.path() / "lib");
  EXPECT_GE(reports(watcher), 1);
  folder_.write("lib/a.lua", "22");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, ContinuesAfterTheWholeFolderIsReplaced) {
  folder_.write("scripts/a.lua", "1");
  folder_.write("other/a.lua", "22");
  const std::filesystem::path root = folder_.path() / "scripts";
  FileWatcher watcher(root, GetParam());
  std::filesystem::rename(root, folder_.path() / "old");
  EXPECT_GE(reports(watcher), 1);
  EXPECT_EQ(reports(watcher), 0) << "it is gone";
  std::filesystem::rename(folder_.path() / "other", root);
  EXPECT_EQ(reports(watcher), 1);
  folder_.write("old/a.lua", "333");
  EXPECT_EQ(reports(watcher), 0) << "that is another folder now";
  folder_.write("scripts/a.lua", "333");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, ContinuesAfterTheFolderIsDeletedAndCreatedAgain) {
  folder_.write("scripts/lib/a.lua", "1");
  FileWatcher watcher(folder_.path() / "scripts", GetParam());
  std::filesystem::remove_all(folder_.path() / "scripts");
  EXPECT_GE(reports(watcher), 1);
  folder_.write("scripts/lib/a.lua", "22");
  EXPECT_EQ(reports(watcher), 1);
  folder_.write("scripts/lib/a.lua", "333");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, FollowsASymbolicLinkThatIsSwitched) {
  folder_.write("one/a.lua", "1");
  folder_.write("two/a.lua", "22");
  const std::filesystem::path link = folder_.path() / "scripts";
  const std::filesystem::path next = folder_.path() / "next";
  std::filesystem::create_directory_symlink("one", link);
  FileWatcher watcher(link, GetParam());
  std::filesystem::create_directory_symlink("two", next);
  std::filesystem::rename(next, link);
  EXPECT_EQ(reports(watcher), 1);
  folder_.write("one/a.lua", "333");
  EXPECT_EQ(reports(watcher), 0);
  folder_.write("two/a.lua", "333");
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, DoesNotWaitForeverForQuiet) {
  folder_.write("a.lua", "1");
  FileWatcher watcher(folder_.path(), GetParam());
  int count = 0;
  std::string text = "1";
  for (int i = 0; i < 30; ++i, time_ += 0.01) {
    folder_.write("a.lua", text += "x");
    count += watcher.poll(time_) ? 1 : 0;
  }
  EXPECT_GE(count, 1);
}

/// As on a share: another computer changed the file, and this computer gets no event. Here the mask has none for times.
TEST_P(Watcher, NoticesAChangeWithoutAnEvent) {
  const std::filesystem::path file = folder_.write("behaviors/a.lua", "1");
  FileWatcher watcher(folder_.path(), GetParam());
  EXPECT_EQ(reports(watcher), 0);
  std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::hours(1));
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, NoticesAFileOfTheSameSizeAndTime) {
  const std::filesystem::path file = folder_.write("behaviors/a.lua", "1");
  const auto time = std::filesystem::last_write_time(file);
  FileWatcher watcher(folder_.path(), GetParam());
  std::filesystem::last_write_time(folder_.write("new", "2"), time);
  std::filesystem::rename(folder_.path() / "new", file);
  EXPECT_EQ(reports(watcher), 1);
}

TEST_P(Watcher, LooksOnlyAtItsFolders) {
  folder_.write("behaviors/deep/a.lua", "1");
  folder_.write("logs/deep/a.log", "1");
  FileWatcher watcher(folder_.path(), GetParam(), {"behaviors", "lib"});
  folder_.write("logs/deep/a.log", "22");
  EXPECT_EQ(reports(watcher), 0);
  folder_.write("behaviors/deep/a.lua", "22");
  EXPECT_EQ(reports(watcher), 1);
  folder_.write("lib/a.lua", "1");
  EXPECT_EQ(reports(watcher), 1) << "a new folder";
  folder_.write("lib/a.lua", "22");
  EXPECT_EQ(reports(watcher), 1);
}

INSTANTIATE_TEST_SUITE_P(Means, Watcher, ::testing::Values(FileWatcher::Means::automatic, FileWatcher::Means::polling),
                         [](const auto& means) {
                           return means.param == FileWatcher::Means::polling ? "Polling" : "Inotify";
                         });

}  // namespace
}  // namespace reorient
