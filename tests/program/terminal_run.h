// SPDX-License-Identifier: MIT
// The program at its own pseudo-terminal.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "tests/paths.h"
#include "tests/waiting.h"

namespace reorient {

class TerminalRun {
 public:
  /// `command`: a program and its arguments. Its files for the user are written below `state`.
  TerminalRun(std::vector<std::string> command, const std::filesystem::path& state) {
    std::vector<char*> argv;
    argv.reserve(command.size() + 1);
    for (std::string& word : command) argv.push_back(word.data());
    argv.push_back(nullptr);
    const winsize size{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};
    process_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ != 0) return;
    // A shell without job control starts tests in the background with these ignored.
    for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    setenv("REORIENT_HOME", kSourceFolder, 1);
    setenv("XDG_STATE_HOME", state.c_str(), 1);
    setenv("TERM", "xterm", 1);
    execv(argv[0], argv.data());
    _exit(127);
  }
  ~TerminalRun() {
    if (process_ > 0) {  // signal -1 would reach all processes
      ::kill(process_, SIGKILL);
      wait();
    }
    if (terminal_ >= 0) close(terminal_);
  }
  TerminalRun(const TerminalRun&) = delete;
  TerminalRun& operator=(const TerminalRun&) = delete;

  /// False: no pseudo-terminal is available (a root without /dev/pts).
  bool has_terminal() const { return process_ > 0; }
  void type(const std::string& keys) const { ASSERT_EQ(write(terminal_, keys.data(), keys.size()), std::ssize(keys)); }
  void resize(unsigned short columns, unsigned short rows) const {
    const winsize size{.ws_row = rows, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    ASSERT_EQ(ioctl(terminal_, TIOCSWINSZ, &size), 0);
  }
  void kill(int signal) const {
    if (process_ > 0) ::kill(process_, signal);
  }
  /// Stops the run. Signals that are sent after that reach it together, when it continues.
  void stop() const {
    kill(SIGSTOP);
    siginfo_t stopped{};
    waitid(P_PID, static_cast<id_t>(process_), &stopped, WSTOPPED | WEXITED | WNOWAIT);
  }
  /// Whether the terminal edits lines and shows what is typed itself, as it was found.
  bool is_as_found() const {
    termios modes{};
    constexpr tcflag_t kUsual = ICANON | ECHO | ISIG;
    return tcgetattr(terminal_, &modes) == 0 && (modes.c_lflag & kUsual) == kUsual;
  }

  /// Waits until is_as_found() is `wanted`. The modes may change before or after the text that tells of the change.
  bool await_as_found(bool wanted) {
    const auto is_so = [&] {
      if (is_as_found() == wanted) return true;
      read_some(10);
      return false;
    };
    return reorient::await(is_so, kNoPause);
  }

  /// Waits until `text` is shown, behind the text of the wait before. False: the run ended without, or kWaitLimit
  /// passed.
  bool await(const std::string& text) {
    bool is_shown = false;
    reorient::await(
        [&] {
          const std::size_t place = shown_.find(text);
          is_shown = place != std::string::npos;
          if (!is_shown) return !read_some(10);  // then the run has ended
          passed_ = shown_.substr(0, place);
          shown_.erase(0, place + text.size());
          return true;
        },
        kNoPause);
    return is_shown;
  }
  /// The text that was shown before that.
  const std::string& passed() const { return passed_; }
  const std::string& shown() const { return shown_; }

  /// Its exit code; minus the signal that ended it.
  int wait() {
    int status = 0;
    while (waitpid(process_, &status, WNOHANG) == 0) read_some(10);  // it could not end with a full terminal
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  static constexpr std::chrono::milliseconds kNoPause{0};  // read_some() pauses

  bool read_some(int milliseconds) {
    pollfd waiting{terminal_, POLLIN, 0};
    if (poll(&waiting, 1, milliseconds) != 1) return true;
    std::array<char, 4096> buffer;
    const ssize_t count = read(terminal_, buffer.data(), buffer.size());
    if (count > 0) shown_.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

  int terminal_ = -1;
  pid_t process_ = -1;
  std::string shown_;
  std::string passed_;
};

}  // namespace reorient
