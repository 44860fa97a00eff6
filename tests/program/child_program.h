// SPDX-License-Identifier: MIT
// The program as a separate process, to be interrupted, slowed down and killed.
#pragma once

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/paths.h"
#include "tests/waiting.h"

namespace reorient {

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Limits the size of the program's files, as on a full disk.
inline std::function<void()> files_up_to(rlim_t bytes) {
  return [bytes] {
    const rlimit most{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &most);
  };
}

class ChildProgram {
 public:
  /// Redirects its output to the files out.txt and err.txt of `folder`. `prepare` runs in the child, just before.
  ChildProgram(const std::filesystem::path& folder, const std::vector<std::string>& words,
               const std::function<void()>& prepare = {})
      : folder_(folder) {
    const char* const other = std::getenv("REORIENT_TEST_PROGRAM");  // for another processor than the tests
    std::vector<std::string> all{other != nullptr ? other : kProgram};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> argv;
    argv.reserve(all.size() + 1);
    for (std::string& word : all) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string out = (folder / "out.txt").string(), err = (folder / "err.txt").string();
    for (const std::string& old : {out, err})
      std::filesystem::remove(old);  // otherwise they would be read as output of this program
    process_ = fork();
    if (process_ != 0) return;
    setenv("REORIENT_HOME", kSourceFolder, 1);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    // A shell that started the tests in the background may ignore these signals, and a program does not change that.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    if (prepare) prepare();
    execv(argv[0], argv.data());
    _exit(127);
  }
  ~ChildProgram() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    wait();
  }
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  void kill(int signal) const {
    if (process_ > 0) ::kill(process_, signal);  // signal -1 would reach all processes
  }
  /// Stops the program. Signals that are sent after that reach it together, when it continues.
  void stop() const {
    kill(SIGSTOP);
    siginfo_t stopped{};
    waitid(P_PID, static_cast<id_t>(process_), &stopped, WSTOPPED | WEXITED | WNOWAIT);
  }
  bool has_ended() const {
    siginfo_t ended{};
    waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT);
    return ended.si_pid != 0;
  }
  pid_t id() const { return process_; }
  std::string out() const { return read_text(folder_ / "out.txt"); }
  std::string err() const { return read_text(folder_ / "err.txt"); }

  /// Waits until the program has printed `text` to its output or its errors. False: it ended without the text, or
  /// kWaitLimit passed.
  bool await(const std::string& text) const {
    bool is_printed = false;
    reorient::await([&] {
      const bool has_ended = this->has_ended();  // check first, because it may print the text and end in between
      is_printed = err().find(text) != std::string::npos || out().find(text) != std::string::npos;
      return is_printed || has_ended;
    });
    return is_printed;
  }

  /// Its exit code; minus the signal that ended it.
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  std::filesystem::path folder_;
  pid_t process_ = -1;
};

}  // namespace reorient
