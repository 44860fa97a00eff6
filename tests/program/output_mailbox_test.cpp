// SPDX-License-Identifier: MIT
// Output that a run does not wait for.
#include "program/output_mailbox.h"

#include <condition_variable>
#include <mutex>
#include <ostream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "program/log.h"

namespace reorient {
namespace {

/// Stopped like a terminal after Ctrl-S, until it is released.
class StoppedOutput : public std::stringbuf {
 public:
  void release() {
    const std::lock_guard lock(mutex_);
    is_released_ = true;
    released_.notify_all();
  }

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    std::unique_lock lock(mutex_);
    released_.wait(lock, [this] { return is_released_; });
    return std::stringbuf::xsputn(text, size);
  }

 private:
  std::mutex mutex_;
  std::condition_variable released_;
  bool is_released_ = false;
};

TEST(OutputMailbox, DropsWhatAStoppedTerminalDoesNotAcceptAndSaysHowMuch) {
  StoppedOutput terminal;
  std::ostream out(&terminal), err(&terminal);
  std::string line(1000, 'x');
  line.back() = '\n';
  {
    const OutputMailbox mailbox(out, err);
    out << "begin\n";
    for (int i = 0; i < 2000; ++i) out << line;
    EXPECT_TRUE(out.good());
    terminal.release();
  }
  const std::string text = terminal.str();
  EXPECT_TRUE(text.starts_with("begin\nx"));
  EXPECT_LE(text.size(), OutputMailbox::kMost + 200);
  EXPECT_GE(text.size(), OutputMailbox::kMost - line.size());
  const std::size_t missing = line.size() * 2000 + 6 - text.rfind("reorient: dropped ");
  EXPECT_NE(text.find("reorient: dropped " + std::to_string(missing) + " bytes of output"), std::string::npos)
      << text.substr(text.size() - 200);
}

TEST(OutputMailbox, KeepsTheOrderOfBothStreamsAndOfTheLog) {
  std::stringbuf terminal;
  std::ostream out(&terminal), err(&terminal);
  set_up_log("info", "never");
  {
    const OutputMailbox mailbox(out, err);
    out << "one\n";
    err << "two\n";
    spdlog::warn("three");
    out << "four" << std::flush << '\n';
  }
  EXPECT_EQ(terminal.str(), "one\ntwo\n[warning] three\nfour\n");
  out << "five\n";
  EXPECT_TRUE(terminal.str().ends_with("five\n")) << "the streams are as before";
}

TEST(OutputMailbox, ReportsThatOutputCouldNotBeWritten) {
  struct FullDisk : std::stringbuf {
    std::streamsize xsputn(const char* /*text*/, std::streamsize /*size*/) override { return 0; }
  } disk;
  std::stringbuf terminal;
  std::ostream out(&disk), err(&terminal);
  {
    const OutputMailbox mailbox(out, err);
    out << "lost\n";
    EXPECT_TRUE(out.good());
  }
  EXPECT_FALSE(out.good());
  EXPECT_TRUE(err.good());
}

}  // namespace
}  // namespace reorient
