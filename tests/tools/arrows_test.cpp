// SPDX-License-Identifier: MIT
// tools/arrows on small trees.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class House : public testing::Test {
 protected:
  House() {
    write("docs/architecture.md",
          "<!-- arrows: begin -->\n| room | may include |\n|---|---|\n| `ground/` | – |\n| `upper/` | `ground/` |\n"
          "| `roof/` | everything |\n<!-- arrows: end -->\n| `ground/` | `roof/` |\n");
    write("ground/stone.h", "#pragma once\n#include <vector>\n");
    write("upper/beam.h", "#pragma once\n#include \"ground/stone.h\"\n");
    std::filesystem::create_directories(folder.path() / "tools");
    std::filesystem::copy(std::filesystem::path(kSourceFolder) / "tools" / "arrows",
                          folder.path() / "tools" / "arrows");
  }

  void write(const std::string& file, const std::string& text) {
    std::filesystem::create_directories((folder.path() / file).parent_path());
    std::ofstream(folder.path() / file) << text;
  }

  std::string read(const std::string& file) {
    std::ifstream stream(folder.path() / file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// The output of the check and its exit code.
  std::string check(const std::string& option = "") {
    std::string text;
    const std::string command = (folder.path() / "tools" / "arrows").string() + " " + option + " 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    std::array<char, 256> buffer;
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) text += buffer.data();
    return text + "exit " + std::to_string(WEXITSTATUS(pclose(pipe)));
  }

  TemporaryFolder folder;
};

TEST_F(House, PassesIfTheTableAllowsAllIncludes) { EXPECT_EQ(check(), "exit 0"); }

TEST_F(House, ReportsAnIncludeThatTheTableDoesNotAllowWithItsLine) {
  write("ground/stone.cpp", "\n  #  include \"upper/beam.h\"\n");
  EXPECT_EQ(check(), "ground/stone.cpp:2: includes upper/beam.h, but ground/ must not include upper/\nexit 1");
}

TEST_F(House, AlsoChecksIncludesInAngleBrackets) {
  write("ground/stone.cpp", "#include <upper/beam.h>\n");
  EXPECT_EQ(check(), "ground/stone.cpp:1: includes upper/beam.h, but ground/ must not include upper/\nexit 1");
}

TEST_F(House, DrawsTheDiagramOfItsTableAndReportsAnotherOne) {
  const std::string rooms =
      "<!-- arrows: begin -->\n| `ground/` | – |\n| `upper/` | `ground/` |\n| `attic/` | `ground/`, `upper/` |\n"
      "| `roof/` | everything |\n<!-- arrows: end -->\n";
  write("docs/architecture.md", rooms + "<!-- modules: begin -->\nold\n<!-- modules: end -->\nThe end.\n");
  EXPECT_EQ(check(),
            "docs/architecture.md: the diagram differs from the table; tools/arrows --draw draws it again\nexit 1");
  EXPECT_EQ(check("--draw"), "exit 0");
  EXPECT_EQ(check(), "exit 0");
  // The diagram has no arrow from the attic to the ground, because it follows from the other arrows.
  EXPECT_EQ(
      read("docs/architecture.md"),
      rooms +
          "<!-- modules: begin -->\n```mermaid\nflowchart TD\n  attic_[\"attic/\"]\n  upper_[\"upper/\"]\n"
          "  ground_[\"ground/\"]\n  attic_ --> upper_\n  upper_ --> ground_\n```\n<!-- modules: end -->\nThe end.\n");
}

TEST_F(House, ReportsAnIncludeOfAMissingFile) {
  write("upper/beam.cpp", "#include \"beam.h\"\n");
  EXPECT_EQ(check(), "upper/beam.cpp:1: unknown header beam.h (expected a path from the top of the tree)\nexit 1");
}

TEST_F(House, ReportsAFileOutsideOfAllModules) {
  write("shed/rake.h", "");
  EXPECT_EQ(check(), "shed/rake.h: unknown module (expected one of docs/architecture.md)\nexit 1");
}

TEST_F(House, ReportsACycleOfIncludesWithinAModule) {
  write("upper/a.h", "#include \"upper/b.h\"\n");
  write("upper/b.h", "#include \"upper/c.h\"\n");
  write("upper/c.h", "#include \"upper/b.h\"\n");
  EXPECT_EQ(check(), "includes form a cycle: upper/b.h upper/c.h upper/b.h\nexit 1");
}

TEST_F(House, ReportsACycleOfFoldersWithinAModule) {
  write("upper/left/a.h", "#include \"upper/right/deep/b.h\"\n");
  write("upper/right/deep/b.h", "");
  write("upper/right/c.h", "#include \"upper/left/d.h\"\n");
  write("upper/left/d.h", "#include \"upper/beam.h\"\n");
  EXPECT_EQ(check(), "includes of folders form a cycle: upper/left/ upper/right/ upper/left/\nexit 1");
}

TEST_F(House, ReportsACycleInTheTable) {
  write("docs/architecture.md",
        "<!-- arrows: begin -->\n| `ground/` | `upper/` |\n| `upper/` | `ground/` |\n<!-- arrows: end -->\n");
  EXPECT_EQ(check(), "docs/architecture.md: modules form a cycle: ground/ upper/ ground/\nexit 1");
}

TEST_F(House, RequiresATable) {
  write("docs/architecture.md", "no table\n");
  EXPECT_EQ(check(),
            "tools/arrows: docs/architecture.md: expected a table of modules after <!-- arrows: begin -->, found none\n"
            "exit 2");
}

}  // namespace
}  // namespace reorient
