// SPDX-License-Identifier: MIT
// Files that are written completely or not at all, and what is left of an interrupted process.
#include "workbench/files/atomic_file.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace reorient {
namespace {

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Runs `work` in another process, which then ends as if it were killed.
template <typename Work>
void in_another_process(const Work& work) {
  const pid_t process = fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(process, &status, 0);
  ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST(AtomicFile, RemovesTheTemporaryFilesOfProcessesThatWereKilled) {
  const TemporaryFolder folder;
  in_another_process([&] {
    new FileInTheMaking(folder.path() / "run.json");
    new FileInTheMaking(folder.path() / "other.json");
  });
  ASSERT_EQ(names_in(folder.path()).size(), 2u);
  write_whole_file(folder.path() / "third.json", "3");
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"third.json"});
}

TEST(AtomicFile, KeepsTheTemporaryFilesOfRunningProcessesAndOfOthers) {
  const TemporaryFolder folder;
  FileInTheMaking running(folder.path() / "run.json");
  const std::string name = running.path().filename().string();
  // The number of a process that does not exist, in the name of another computer or container, and of other programs.
  folder.write("run.json.1-4194305-0.partial", "");
  folder.write("run.json.4194305-0.partial", "");
  folder.write("download.partial", "");
  folder.write(".partial", "");
  const std::size_t dash = name.find('-');
  folder.write(name.substr(0, dash) + "-0-0.partial", "");
  folder.write(name.substr(0, dash) + "--1-0.partial", "");
  folder.write(name.substr(0, dash) + "-4194305.partial", "");
  folder.write(name.substr(0, dash) + "-99999999999999999999-0.partial", "");
  std::filesystem::create_directory(folder.path() / (name.substr(0, dash) + "-4194305-0.partial"));
  const std::vector<std::string> before = names_in(folder.path());
  in_another_process([&] { FileInTheMaking(folder.path() / "other.json"); });
  EXPECT_EQ(names_in(folder.path()), before);
  running.end();
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "run.json"));
}

}  // namespace
}  // namespace reorient
