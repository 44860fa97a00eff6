// SPDX-License-Identifier: MIT
// The line that shows the progress of a long command, on a terminal of any width and in a file.
#include "program/progress_line.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace reorient {
namespace {

constexpr const char* kCleared = "\r\x1B[K";

/// The standard error of the test is a terminal, or a file without one.
class StandardError {
 public:
  StandardError() : before_(dup(STDERR_FILENO)) {}
  ~StandardError() {
    dup2(before_, STDERR_FILENO);
    close(before_);
    for (const int end : {master_, slave_}) {
      if (end >= 0) close(end);
    }
  }
  StandardError(const StandardError&) = delete;
  StandardError& operator=(const StandardError&) = delete;

  /// False: no pseudo-terminal is available (a root without /dev/pts).
  bool become_terminal() {
    return openpty(&master_, &slave_, nullptr, nullptr, nullptr) == 0 && dup2(slave_, STDERR_FILENO) >= 0;
  }
  void resize(unsigned short columns) const {
    const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    ASSERT_EQ(ioctl(slave_, TIOCSWINSZ, &size), 0);
  }
  bool become_file() {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) return false;
    master_ = ends[0], slave_ = ends[1];
    return dup2(slave_, STDERR_FILENO) >= 0;
  }

 private:
  int before_;
  int master_ = -1, slave_ = -1;
};

class ProgressOnATerminal : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!error.become_terminal()) GTEST_SKIP() << "no pseudo-terminal";
  }
  void begin(unsigned short columns) {
    error.resize(columns);
    line.emplace(out);
  }
  /// The output of showing the text.
  std::string shown(const std::string& text) {
    out.str("");
    line->show(text);
    return out.str();
  }

  StandardError error;
  std::ostringstream out;
  std::optional<ProgressLine> line;
};

TEST_F(ProgressOnATerminal, IsOverwrittenByTheNextOne) {
  begin(80);
  EXPECT_EQ(shown("1 of 2"), kCleared + std::string("1 of 2"));
  EXPECT_EQ(shown("2 of 2"), kCleared + std::string("2 of 2"));
}

TEST_F(ProgressOnATerminal, LeavesNothingOfALongerLine) {
  begin(80);
  shown("a long line about 1000 trials");
  EXPECT_EQ(shown("short"), kCleared + std::string("short")) << "the rest of the row is cleared first";
}

TEST_F(ProgressOnATerminal, FillsAtMostOneRow) {
  begin(20);
  EXPECT_EQ(shown(std::string(19, 'x')), kCleared + std::string(19, 'x'));
  EXPECT_EQ(shown(std::string(20, 'x')), kCleared + std::string(19, 'x')) << "a full row may begin the next one";
  EXPECT_EQ(shown(std::string(5000, 'x')), kCleared + std::string(19, 'x'));
}

TEST_F(ProgressOnATerminal, FollowsTheWidthOfTheTerminal) {
  begin(20);
  error.resize(10);
  EXPECT_EQ(shown(std::string(50, 'x')), kCleared + std::string(9, 'x'));
  error.resize(40);
  EXPECT_EQ(shown(std::string(50, 'x')), kCleared + std::string(39, 'x'));
}

TEST_F(ProgressOnATerminal, OfAnUnknownWidthHas80Columns) {
  begin(0);
  EXPECT_EQ(shown(std::string(100, 'x')), kCleared + std::string(79, 'x'));
}

TEST_F(ProgressOnATerminal, OfOneColumnShowsOneLetter) {
  begin(1);
  EXPECT_EQ(shown("xyz"), kCleared + std::string("x"));
}

TEST_F(ProgressOnATerminal, IsNotCutWithinALetter) {
  begin(10);
  EXPECT_EQ(shown("12345678\xC3\xBC"), kCleared + std::string("12345678"));
}

TEST_F(ProgressOnATerminal, IsOneLineWithoutControlCharacters) {
  begin(80);
  const std::string text = shown("a\nb\x1B[2J");
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  EXPECT_EQ(text.find('\x1B', 1 + text.find('\x1B')), std::string::npos) << text;
}

TEST_F(ProgressOnATerminal, IsClearedOnceForAnotherLineAndAtTheEnd) {
  begin(80);
  shown("1 of 2");
  out.str("");
  line->clear();
  EXPECT_EQ(out.str(), kCleared);
  line->clear();
  EXPECT_EQ(out.str(), kCleared) << "nothing is shown any more";
  shown("2 of 2");
  out.str("");
  line.reset();
  EXPECT_EQ(out.str(), kCleared);
}

TEST_F(ProgressOnATerminal, ThatWasNeverShownIsNotCleared) {
  begin(80);
  line.reset();
  EXPECT_EQ(out.str(), "");
}

TEST_F(ProgressOnATerminal, IsDueAtOnceWithoutAPause) {
  begin(80);
  EXPECT_TRUE(line->is_due());
  line.emplace(out, std::chrono::hours(1));
  EXPECT_FALSE(line->is_due());
}

TEST(ProgressInAFile, IsAWholeLineEachTimeAndIsNeverCleared) {
  StandardError error;
  ASSERT_TRUE(error.become_file());
  const std::string long_text(200, 'x');
  std::ostringstream out;
  {
    ProgressLine line(out);
    line.show(long_text);
    line.clear();
    line.show("a\nb");
  }
  const std::string text = out.str();
  EXPECT_EQ(text.find('\n'), long_text.size()) << "no width limits it: " << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_EQ(text.find('\x1B'), std::string::npos) << text;
  EXPECT_EQ(text.find('\r'), std::string::npos) << text;
}

TEST(ProgressInAFile, IsNotDueBeforeTenSeconds) {
  StandardError error;
  ASSERT_TRUE(error.become_file());
  std::ostringstream out;
  EXPECT_FALSE(ProgressLine(out).is_due()) << "a log would fill with lines";
}

}  // namespace
}  // namespace reorient
