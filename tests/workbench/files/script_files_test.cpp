// SPDX-License-Identifier: MIT
// From files on a disk to texts and edits.
#include "workbench/files/script_files.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class ScriptFilesTest : public ::testing::Test {
 protected:
  ScriptTexts read() const { return read_scripts(folder_.path()); }
  std::string problem(const std::string& file) const {
    const ScriptTexts texts = read();
    const ScriptText* const text = texts.find(file);
    return text == nullptr ? "there is no such file" : text->problem;
  }

  TemporaryFolder folder_;
};

TEST_F(ScriptFilesTest, AreTheLuaFilesBelowTheRootWithoutTestsAndAnnotations) {
  for (const char* file : {"behaviors/a.lua", "lib/deep/b.lua", "scenarios/c.lua", "tests/a_test.lua",
                           "annotations/reorient.lua", "behaviors/a.md"})
    folder_.write(file, file);
  const ScriptTexts texts = read();
  EXPECT_EQ(texts.files(), (std::vector<std::string>{"behaviors/a.lua", "lib/deep/b.lua", "scenarios/c.lua"}));
  EXPECT_EQ(texts.find("lib/deep/b.lua")->text, "lib/deep/b.lua");
  EXPECT_EQ(texts.root(), folder_.path().string());
}

TEST_F(ScriptFilesTest, ThatCannotBeUsedReportTheReason) {
  folder_.write("behaviors/large.lua", std::string(kLargestScript + 1, ' '));
  folder_.write("behaviors/full.lua", std::string(kLargestScript, ' '));
  std::filesystem::create_directories(folder_.path() / "behaviors" / "folder.lua");
  EXPECT_NE(problem("behaviors/large.lua").find("of at most 64 KiB"), std::string::npos);
  EXPECT_EQ(problem("behaviors/full.lua"), "");
  EXPECT_EQ(problem("behaviors/folder.lua"), "expected a script, found a folder");
}

TEST_F(ScriptFilesTest, BehindLinksAreReadToo) {
  const TemporaryFolder elsewhere;
  elsewhere.write("installed.lua", "return 1");
  elsewhere.write("more/b.lua", "return 3");
  folder_.write("behaviors/here.lua", "return 2");
  const std::filesystem::path behaviors = folder_.path() / "behaviors";
  std::filesystem::create_symlink(elsewhere.path() / "installed.lua", behaviors / "out.lua");
  std::filesystem::create_symlink("here.lua", behaviors / "in.lua");
  std::filesystem::create_symlink("out of the blue", behaviors / "gone.lua");
  std::filesystem::create_symlink("loop.lua", behaviors / "loop.lua");
  std::filesystem::create_directory_symlink(elsewhere.path() / "more", behaviors / "more");
  const ScriptTexts texts = read();
  EXPECT_EQ(texts.find("behaviors/out.lua")->text, "return 1");
  EXPECT_EQ(texts.find("behaviors/in.lua")->text, "return 2");
  EXPECT_EQ(texts.find("behaviors/more/b.lua")->text, "return 3");
  EXPECT_EQ(problem("behaviors/gone.lua"), "expected a script, found a link to a missing file");
  EXPECT_EQ(problem("behaviors/loop.lua"),
            "expected a script, found one that cannot be read: Too many levels of symbolic links");
}

TEST_F(ScriptFilesTest, BehindLinksInACircleAreReadOnce) {
  folder_.write("behaviors/a.lua", "return 1");
  folder_.write("lib/b.lua", "return 2");
  std::filesystem::create_directory_symlink("..", folder_.path() / "behaviors" / "up");
  std::filesystem::create_directory_symlink("../behaviors", folder_.path() / "lib" / "across");
  const std::vector<std::string> files = read().files();
  EXPECT_NE(std::find(files.begin(), files.end(), "lib/across/a.lua"), files.end());
  EXPECT_LE(files.size(), 6u);
}

TEST_F(ScriptFilesTest, AMissingFolderIsReportedInOneLine) {
  try {
    read_scripts(folder_.path() / "gone");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("expected a folder of scripts, found none"), std::string::npos);
  }
}

/// Root reads everything: so another user reads it, in a child.
TEST_F(ScriptFilesTest, BesideAnUnreadableFolderAreAllRead) {
  for (const char* const name : {"behaviors/a.lua", "behaviors/zz/b.lua", "lib/c.lua", "scenarios/d.lua"})
    folder_.write(name, "return {}");
  const std::filesystem::path secret = folder_.path() / "behaviors" / "private";
  std::filesystem::create_directories(secret);
  using std::filesystem::perms;
  std::filesystem::permissions(secret, perms::none);
  std::filesystem::permissions(folder_.path(), perms::owner_all | perms::group_read | perms::group_exec |
                                                   perms::others_read | perms::others_exec);
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kOtherUser = 65534;
    if (geteuid() == 0 && setuid(kOtherUser) != 0) _exit(77);
    const bool is_hidden = access(secret.c_str(), R_OK) != 0;
    _exit(is_hidden ? static_cast<int>(read().files().size()) : 77);
  }
  int status = 0;
  waitpid(child, &status, 0);
  std::filesystem::permissions(secret, perms::owner_all);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "changing the user is not permitted";
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

TEST_F(ScriptFilesTest, AreNamedWithOrWithoutFolderAndExtension) {
  const std::filesystem::path file = folder_.write("behaviors/a.lua", "");
  EXPECT_EQ(script_named(folder_.path(), "a"), "a");
  EXPECT_EQ(script_named(folder_.path(), file.string()), "behaviors/a.lua");
  EXPECT_EQ(script_named(folder_.path(), "behaviors/a.lua"), "behaviors/a.lua");
}

TEST_F(ScriptFilesTest, AreBelowTheirFolderAlsoIfLinksAreFollowed) {
  const std::filesystem::path root = folder_.path() / "root";
  folder_.write("root/behaviors/a.lua", "");
  folder_.write("outside.lua", "");
  std::filesystem::create_symlink(folder_.path() / "outside.lua", root / "behaviors/out.lua");
  std::filesystem::create_symlink("a.lua", root / "behaviors/in.lua");
  std::filesystem::create_directory_symlink(root, folder_.path() / "link");
  for (const char* const file : {"behaviors/a.lua", "behaviors/../behaviors/in.lua", "absent/b.lua", "..a"}) {
    EXPECT_TRUE(is_below(root, root / file)) << file;
    EXPECT_TRUE(is_below(folder_.path() / "link", folder_.path() / "link" / file)) << file;
  }
  for (const char* const file : {"../outside.lua", "../absent.lua", "behaviors/out.lua", "/etc/passwd", "/absent"})
    EXPECT_FALSE(is_below(root, root / file)) << file;
}

TEST_F(ScriptFilesTest, AnEditIsReportedWithinTheDebounceTime) {
  folder_.write("behaviors/a.lua", "old");
  folder_.write("behaviors/b.lua", "gone soon");
  ScriptFiles files(folder_.path());
  EXPECT_TRUE(files.poll(0.0).empty());
  folder_.write_by_rename("behaviors/a.lua", "new");
  folder_.write("lib/c.lua", "come");
  std::filesystem::remove(folder_.path() / "behaviors" / "b.lua");
  double waited = 0.0;
  std::vector<ScriptEdit> edits;
  for (; edits.empty() && waited < 1.0; waited += 0.01) edits = files.poll(waited);
  EXPECT_LE(waited, 0.1 + 0.02);
  ASSERT_EQ(edits.size(), 3u);
  EXPECT_EQ(edits[0].file, "behaviors/a.lua");
  EXPECT_EQ(edits[0].text->text, "new");
  EXPECT_EQ(edits[1].file, "lib/c.lua");
  EXPECT_EQ(edits[2].file, "behaviors/b.lua");
  EXPECT_FALSE(edits[2].text);
  EXPECT_TRUE(files.poll(2.0).empty());
}

TEST_F(ScriptFilesTest, StayWhileTheirFolderIsMissing) {
  folder_.write("scripts/behaviors/a.lua", "text");
  ScriptFiles files(folder_.path() / "scripts");
  std::filesystem::rename(folder_.path() / "scripts", folder_.path() / "elsewhere");
  for (double time = 0.0; time < 1.0; time += 0.05) EXPECT_TRUE(files.poll(time).empty());
  EXPECT_NE(files.texts().find("behaviors/a.lua"), nullptr);
}

TEST_F(ScriptFilesTest, AreReadAgainAfterTheFolderIsReplaced) {
  folder_.write("scripts/behaviors/a.lua", "old");
  folder_.write("next/behaviors/a.lua", "new");
  ScriptFiles files(folder_.path() / "scripts");
  std::filesystem::rename(folder_.path() / "scripts", folder_.path() / "old");
  double time = 0.0;
  for (; time < 1.0; time += 0.05) EXPECT_TRUE(files.poll(time).empty());
  std::filesystem::rename(folder_.path() / "next", folder_.path() / "scripts");
  std::vector<ScriptEdit> edits;
  for (; edits.empty() && time < 2.0; time += 0.05) edits = files.poll(time);
  ASSERT_EQ(edits.size(), 1u);
  EXPECT_EQ(edits[0].text->text, "new");
}

}  // namespace
}  // namespace reorient
