// SPDX-License-Identifier: MIT
// Parts of the prompt: keys, names, and the lines of earlier runs.
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "program/run/console/history_file.h"
#include "program/run/console/key_queue.h"
#include "program/run/console/name_pattern.h"
#include "program/safe_output.h"
#include "tests/program/child_program.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

using Strings = std::vector<std::string>;

Strings keys(KeyQueue& queue) {
  Strings all;
  while (std::optional<std::string> key = queue.next()) all.push_back(*key);
  return all;
}

class Keys : public ::testing::Test {
 protected:
  Strings of(const std::string& bytes) {
    queue.add(bytes);
    return keys(queue);
  }
  KeyQueue queue{{"\x1B[A", "\x1BOA", "\x1B[1;5C", "\033f"}};
};

TEST_F(Keys, AreLettersControlsAndKnownSequences) {
  EXPECT_EQ(of("a\r\x04"), (Strings{"a", "\r", "\x04"}));
  EXPECT_EQ(of("ä€😀"), (Strings{"ä", "€", "😀"}));
  EXPECT_EQ(of("\x1B[A\x1BOA\x1B[1;5C\033fx"), (Strings{"\x1B[A", "\x1BOA", "\x1B[1;5C", "\033f", "x"}));
}

TEST_F(Keys, WaitForTheirRest) {
  EXPECT_EQ(of("\x1B["), Strings());
  EXPECT_EQ(of("A"), Strings{"\x1B[A"});
  EXPECT_EQ(of("\xE2\x82"), Strings());
  EXPECT_EQ(of("\xAC"), Strings{"€"});
  EXPECT_EQ(of("\x1B\r"), Strings{"\r"}) << "the Escape key, then Enter";
  EXPECT_EQ(of("\x1B"), Strings());
  queue.drop_begun();
  EXPECT_EQ(of("A"), Strings{"A"});
}

TEST_F(Keys, DoNotWaitBehindALetterInAnotherEncoding) {
  EXPECT_EQ(of("\xFF"
               "a"),
            Strings{"a"})
      << "Latin-1";
  EXPECT_EQ(of("\xE4"
               "b"),
            Strings{"b"});
  EXPECT_EQ(of("\xF6"
               "c"),
            Strings{"c"});
  EXPECT_EQ(of("\xE2\x82"
               "d"),
            Strings{"d"});
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(of("\xE4"), Strings());
  EXPECT_EQ(of("\r"), Strings{"\r"});
}

TEST_F(Keys, AreIgnoredIfUnknown) {
  EXPECT_EQ(of("\x1B[5~a"), Strings{"a"});  // page up
  EXPECT_EQ(of("\x1B\x1B[Ab"), (Strings{"\x1B[A", "b"}));
  EXPECT_EQ(of("\x80\xFF\xC3(c"), (Strings{"(", "c"}));
  EXPECT_EQ(of("\x1B[1\x1B[Ad"), (Strings{"\x1B[A", "d"})) << "cut off by the next";
  EXPECT_EQ(of("\x1B[" + std::string(1000, '1') + "A").back(), "A") << "no end";
}

TEST_F(Keys, OfAnotherEncodingAreDroppedAlone) {
  EXPECT_EQ(of("f\xFCr"), (Strings{"f", "r"})) << "Latin-1, without waiting for the rest of a letter";
  EXPECT_EQ(of("\xE4\xF6\r"), Strings{"\r"});
}

TEST(NamePattern, AStarMatchesAnyLetters) {
  EXPECT_TRUE(matches("pose.*", "pose.x"));
  EXPECT_TRUE(matches("*.current", "confidence.current"));
  EXPECT_TRUE(matches("*o*e*", "pose"));
  EXPECT_TRUE(matches("**", ""));
  EXPECT_FALSE(matches("pose.*", "robot.pose.x"));
  EXPECT_FALSE(matches("pose", "pose.x"));
  std::string hard;
  for (int i = 0; i < 400; ++i) hard += "*a";
  EXPECT_FALSE(matches(hard + "b", std::string(1000, 'a'))) << "without exponential time";
}

TEST(NamePattern, PrefersTheExactName) {
  const Strings names{"a.lead", "a.lead_time", "b.lead"};
  EXPECT_EQ(pick("a.lead", names, "name"), (std::vector<std::size_t>{0}));
  EXPECT_EQ(pick("lead", names, "name"), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(pick("*.lead", names, "name"), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(pick("", names, "name").size(), 3u);
  EXPECT_THROW(pick("c.*", names, "name"), std::runtime_error);
}

TEST(Printable, ContainsNoControlCharacters) {
  EXPECT_EQ(printable("für\x1B[2J\x7F\xFF"), "für\\x1B[2J\\x7F\\xFF");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J\xC2\xA7"),
            "\\xC2\\x9B2J§");
  EXPECT_LT(printable(std::string(100000, '\x01')).size(), 320u);
  EXPECT_EQ(printable(std::string(299, 'x') + "€").substr(295), "xxxx ...") << "no half letters";
}

TEST(Printable, IsOneLineInOneDirection) {
  EXPECT_EQ(printable("a\nb\tc\r"), "a b c\\x0D");
  EXPECT_EQ(printable("\u2028\u202E\u2066\u2027"), "\\xE2\\x80\\xA8\\xE2\\x80\\xAE\\xE2\\x81\\xA6\u2027");
}

TEST(SafeOutput, EscapesWhatATerminalWouldExecute) {
  std::ostringstream terminal;
  SafeOutput safe(terminal);
  std::ostream out(&safe);
  out << "two\tlines\n"
      << "f\u00FCr\x1B[2J\r\x7F\xFF\u009B1m" << '\a' << std::flush;
  EXPECT_EQ(terminal.str(), "two\tlines\nf\u00FCr\\x1B[2J\\x0D\\x7F\\xFF\\xC2\\x9B1m\\x07");
}

TEST(SafeOutput, JoinsLettersThatArriveInPieces) {
  std::ostringstream terminal;
  SafeOutput safe(terminal);
  std::ostream out(&safe);
  for (const char byte : std::string("\u20AC\U0001F600\u009B")) out << byte;
  EXPECT_EQ(terminal.str(), "\u20AC\U0001F600\\xC2\\x9B");
  out << "\xE2\x82" << std::flush;
  EXPECT_EQ(terminal.str(), "\u20AC\U0001F600\\xC2\\x9B\\xE2\\x82") << "the rest does not come";
}

// ---- history

class HistoryFile : public ::testing::Test {
 protected:
  std::string refusal() const {
    try {
      append_history(file, {"set a.b 1"});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "reorient" / "history";
};

TEST_F(HistoryFile, IsInTheFolderForState) {
  const char* const home = std::getenv("HOME");
  const std::string before = home == nullptr ? "" : home;
  setenv("HOME", "/home/user", 1);
  setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(history_path(), "/state/reorient/history");
  setenv("XDG_STATE_HOME", "not/absolute", 1);
  EXPECT_EQ(history_path(), "/home/user/.local/state/reorient/history");
  unsetenv("XDG_STATE_HOME");
  EXPECT_EQ(history_path(), "/home/user/.local/state/reorient/history");
  unsetenv("HOME");
  EXPECT_EQ(history_path(), std::nullopt);
  if (home != nullptr) setenv("HOME", before.c_str(), 1);
}

TEST_F(HistoryFile, ContainsTheLinesOfAllRuns) {
  EXPECT_EQ(read_history(file), Strings());
  append_history(file, {"states", "why orientation"});
  append_history(file, {"why orientation", "diff"});
  EXPECT_EQ(read_history(file), (Strings{"states", "why orientation", "diff"}));
  EXPECT_EQ(std::filesystem::status(file.parent_path()).permissions(), std::filesystem::perms::owner_all);
}

TEST_F(HistoryFile, RemovesTheOldestLines) {
  for (int run = 0; run < 3; ++run) {
    Strings lines;
    for (int i = 0; i < 300; ++i) lines.push_back("set a.b " + std::to_string(1000 * run + i));
    append_history(file, lines);
  }
  EXPECT_EQ(read_history(file).size(), kMostHistory);
  EXPECT_EQ(read_history(file).back(), "set a.b 2299");
  folder.write("reorient/history", std::string(5'000'000, 'x') + "\nstates\n");
  EXPECT_EQ(read_history(file), Strings{"states"});
  append_history(file, {"diff"});
  EXPECT_EQ(read_text(file), "states\ndiff\n");
}

TEST_F(HistoryFile, IgnoresLinesThatNoPromptWrote) {
  folder.write("reorient/history",
               std::string("states\n\x1B[2J\n\0\0\n\xFF\n", 17) + std::string(2000, 'x') + "\n\ndiff");
  EXPECT_EQ(read_history(file), (Strings{"states", "diff"}));
}

TEST_F(HistoryFile, WritesOnlyToAPlainFile) {
  std::filesystem::create_directories(file);
  EXPECT_NE(refusal().find("expected a plain file, found another type of file"), std::string::npos) << refusal();
  std::filesystem::remove(file);
  folder.write("precious.txt", "mine\n");
  std::filesystem::create_symlink(folder.path() / "precious.txt", file);
  EXPECT_NE(refusal().find("expected a plain file, found a link"), std::string::npos) << refusal();
  EXPECT_EQ(read_text(folder.path() / "precious.txt"), "mine\n");
  std::filesystem::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_NE(refusal().find("expected a plain file, found another type of file"), std::string::npos)
      << "and does not block";
  std::filesystem::remove_all(file.parent_path());
  folder.write("reorient", "a file where the folder should be");
  EXPECT_NE(refusal(), "");
}

}  // namespace
}  // namespace reorient
