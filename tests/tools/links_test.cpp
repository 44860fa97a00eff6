// SPDX-License-Identifier: MIT
// tools/links on small trees.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class Pages : public testing::Test {
 protected:
  Pages() {
    std::filesystem::create_directories(folder.path() / "tools");
    std::filesystem::copy(std::filesystem::path(kSourceFolder) / "tools" / "links", folder.path() / "tools" / "links");
    write("docs/guide.md", "# A guide\n## Step 1: `go`\n");
  }

  void write(const std::string& file, const std::string& text) {
    std::filesystem::create_directories((folder.path() / file).parent_path());
    std::ofstream(folder.path() / file) << text;
  }

  /// The output of the check and its exit code.
  std::string check() {
    std::string text;
    FILE* const pipe = popen(((folder.path() / "tools" / "links").string() + " 2>&1").c_str(), "r");
    std::array<char, 256> buffer;
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) text += buffer.data();
    return text + "exit " + std::to_string(WEXITSTATUS(pclose(pipe)));
  }

  TemporaryFolder folder;
};

TEST_F(Pages, PassIfTheTargetsOfAllLinksExist) {
  write("README.md",
        "[guide](docs/guide.md), [step](docs/guide.md#step-1-go), [here](#top), [all](docs), [web](https://no.one)\n# "
        "Top\n");
  write("docs/other.md", "![guide](guide.md \"a guide\") and [up](../README.md)\n\n[ref]: guide.md\n");
  EXPECT_EQ(check(), "exit 0");
}

TEST_F(Pages, FailWithTheLineOfALinkToAMissingFile) {
  write("docs/other.md", "\n[one](guide.md) [two](README.md)\n");
  EXPECT_EQ(check(), "docs/other.md:2: missing file README.md (expected a path from docs/)\nexit 1");
}

TEST_F(Pages, FailALinkToAMissingHeading) {
  write("README.md", "[step](docs/guide.md#step-2)\n");
  EXPECT_EQ(check(), "README.md:1: docs/guide.md has no heading #step-2\nexit 1");
}

TEST_F(Pages, FailAReferenceToAMissingFile) {
  write("README.md", "[one][two]\n\n[two]: docs/two.md\n");
  EXPECT_EQ(check(), "README.md:3: missing file docs/two.md (expected a path from the top)\nexit 1");
}

TEST_F(Pages, MayContainAnyLinkInCode) {
  write("README.md", "`[a](b)`\n```lua\nt[1](nothing)\n```\n");
  EXPECT_EQ(check(), "exit 0");
}

}  // namespace
}  // namespace reorient
