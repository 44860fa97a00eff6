// SPDX-License-Identifier: MIT
// Inputs are read whole, but only up to a limit; an error names its true reason.
#include "workbench/files/input_file.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class InputFile : public ::testing::Test {
 protected:
  std::string complaint(const std::filesystem::path& file, std::uintmax_t most = kLargestText) const {
    try {
      return "read: " + read_input(file, "a table", most);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(InputFile, IsReadWholeUpToItsLimit) {
  const std::string bytes = std::string(200'000, 'x') + '\0' + "end";
  const std::filesystem::path file = folder_.write("a", bytes);
  EXPECT_EQ(read_input(file, "a table", bytes.size()), bytes);
  EXPECT_EQ(read_input(folder_.write("empty", ""), "a table", 0), "");
  EXPECT_EQ(complaint(file, bytes.size() - 1), "expected a table of at most 196 KiB, found a larger one (196 KiB)");
  EXPECT_EQ(complaint(file, 1024), "expected a table of at most 1 KiB, found a larger one (196 KiB)");
  std::filesystem::create_symlink("a", folder_.path() / "link");
  EXPECT_EQ(read_input(folder_.path() / "link", "a table"), bytes);
}

TEST_F(InputFile, OfManyGigabytesIsRefusedBeforeItIsRead) {
  const std::filesystem::path file = folder_.write("sparse", "{");
  std::filesystem::resize_file(file, std::uintmax_t{40} << 30);
  EXPECT_EQ(complaint(file), "expected a table of at most 64 MiB, found a larger one (40960 MiB)");
}

TEST_F(InputFile, WithoutASizeIsReadUpToItsEnd) {
  // A file of the kernel reports a size of 0.
  EXPECT_NE(read_input("/proc/self/status", "a status").find("Pid:"), std::string::npos);
  EXPECT_EQ(complaint("/proc/self/status", 10), "expected a table of at most 1 KiB, found a larger one");
}

TEST_F(InputFile, IsNamedInOneLine) {
  EXPECT_EQ(read_named_input(folder_.write("a", "x"), "a table"), "x");
  try {
    read_named_input(folder_.path() / "a\nb", "a table");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), (folder_.path() / "a b").string() + ": expected a table, found none");
  }
}

TEST_F(InputFile, ThatCannotBeReadIsRefusedWithTheTrueReason) {
  EXPECT_EQ(complaint(folder_.path() / "gone"), "expected a table, found none");
  EXPECT_EQ(complaint(folder_.path()), "expected a table, found a folder");
  std::filesystem::create_symlink("gone", folder_.path() / "link");
  EXPECT_EQ(complaint(folder_.path() / "link"), "expected a table, found a link to a missing file");
  std::filesystem::create_symlink("circle", folder_.path() / "circle");
  EXPECT_EQ(complaint(folder_.path() / "circle"),
            "expected a table, found one that cannot be read: Too many levels of symbolic links");
  ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(complaint(folder_.path() / "pipe"), "expected a table, found another type of file");
  EXPECT_EQ(complaint("/dev/zero"), "expected a table, found another type of file");
  const std::filesystem::path file = folder_.write("locked", "x");
  EXPECT_EQ(complaint(file / "inside"), "expected a table, found one that cannot be read: Not a directory");
  if (geteuid() == 0) return;  // root may read everything
  std::filesystem::permissions(file, std::filesystem::perms::none);
  EXPECT_EQ(complaint(file), "expected a table, found one that cannot be read: Permission denied");
}

}  // namespace
}  // namespace reorient
