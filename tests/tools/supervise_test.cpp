// SPDX-License-Identifier: MIT
// tools/supervise: no process that it started is left after its end.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

const std::string kSupervise = std::string(kSourceFolder) + "/tools/supervise";

class Supervised : public testing::Test {
 protected:
  /// Starts a shell under tools/supervise.
  pid_t start(const std::string& script) const {
    const pid_t process = fork();
    if (process == 0) {
      for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
      if (chdir(folder_.path().c_str()) != 0) _exit(127);
      execl(kSupervise.c_str(), kSupervise.c_str(), "sh", "-c", script.c_str(), nullptr);
      _exit(127);
    }
    return process;
  }
  static int code_of(pid_t process) {
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  /// Waits for the number that the script writes to a file.
  pid_t process_in(const std::string& name) const {
    for (int i = 0; i < 12'000; ++i) {
      std::ifstream in(folder_.path() / name);
      pid_t process = 0;
      if (in >> process && in.get() == '\n') return process;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << name << " was not written";
    return 0;
  }
  static bool lives(pid_t process) {
    std::ifstream in("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(in, text);
    return !text.empty() && text.find(") Z ") == std::string::npos;
  }

  TemporaryFolder folder_;
};

TEST_F(Supervised, HasTheCommandsExitCode) {
  EXPECT_EQ(code_of(start("exit 3")), 3);
  EXPECT_EQ(code_of(start("kill -9 $$")), 128 + SIGKILL);
  EXPECT_EQ(code_of(start("exit 0")), 0);
}

TEST_F(Supervised, EndsDaemonsAfterTheCommandHasEnded) {
  const pid_t command =
      start("setsid sh -c 'echo $$ >daemon; exec sleep 1000' & while [ ! -s daemon ]; do sleep 0.01; done");
  EXPECT_EQ(code_of(command), 0);
  EXPECT_FALSE(lives(process_in("daemon")));
}

TEST_F(Supervised, EndsEverythingWhenItIsInterrupted) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    for (const char* const name : {"child", "daemon", "stubborn"}) std::filesystem::remove(folder_.path() / name);
    const pid_t command = start(
        "setsid sh -c 'echo $$ >daemon; exec sleep 1000' & sh -c 'trap \"\" TERM; echo $$ >stubborn; while :; do sleep "
        "1; done' &"
        " sh -c 'echo $$ >child; exec sleep 1000'");
    const pid_t processes[] = {process_in("child"), process_in("daemon"), process_in("stubborn")};
    kill(command, signal);
    EXPECT_EQ(code_of(command), 128 + signal);
    for (const pid_t process : processes) EXPECT_FALSE(lives(process)) << process;
  }
}

TEST_F(Supervised, RequiresACommand) {
  EXPECT_EQ(WEXITSTATUS(std::system((kSupervise + " 2>/dev/null").c_str())), 2);
  EXPECT_EQ(WEXITSTATUS(std::system((kSupervise + " /nowhere/command 2>/dev/null").c_str())), 127);
}

}  // namespace
}  // namespace reorient
