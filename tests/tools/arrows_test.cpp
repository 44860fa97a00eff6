// The check of the arrows, on small houses of its own.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

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
    std::filesystem::copy(std::filesystem::path(REORIENT_SOURCE_DIR) / "tools" / "arrows",
                          folder.path() / "tools" / "arrows");
  }

  void write(const std::string& file, const std::string& text) {
    std::filesystem::create_directories((folder.path() / file).parent_path());
    std::ofstream(folder.path() / file) << text;
  }

  /// What the check prints, and its exit code.
  std::string check() {
    std::string text;
    FILE* const pipe = popen(((folder.path() / "tools" / "arrows").string() + " 2>&1").c_str(), "r");
    std::array<char, 256> buffer;
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) text += buffer.data();
    return text + "exit " + std::to_string(WEXITSTATUS(pclose(pipe)));
  }

  TemporaryFolder folder;
};

TEST_F(House, PassesWhereAllArrowsRunAsTheTableSays) { EXPECT_EQ(check(), "exit 0"); }

TEST_F(House, FailsAnIncludeThatTheTableDoesNotAllowWithItsLine) {
  write("ground/stone.cpp", "\n  #  include \"upper/beam.h\"\n");
  EXPECT_EQ(check(), "ground/stone.cpp:2: includes upper/beam.h, but ground/ may not include upper/\nexit 1");
}

TEST_F(House, IsNotFooledByAngleBrackets) {
  write("ground/stone.cpp", "#include <upper/beam.h>\n");
  EXPECT_EQ(check(), "ground/stone.cpp:1: includes upper/beam.h, but ground/ may not include upper/\nexit 1");
}

TEST_F(House, FailsAnIncludeOfWhatIsNotThere) {
  write("upper/beam.cpp", "#include \"beam.h\"\n");
  EXPECT_EQ(check(), "upper/beam.cpp:1: there is no beam.h\nexit 1");
}

TEST_F(House, FailsAFileInNoRoom) {
  write("shed/rake.h", "");
  EXPECT_EQ(check(), "shed/rake.h: in no room of docs/architecture.md\nexit 1");
}

TEST_F(House, FailsACircleOfIncludesWithinARoom) {
  write("upper/a.h", "#include \"upper/b.h\"\n");
  write("upper/b.h", "#include \"upper/c.h\"\n");
  write("upper/c.h", "#include \"upper/b.h\"\n");
  EXPECT_EQ(check(), "includes run in a circle: upper/b.h upper/c.h upper/b.h\nexit 1");
}

TEST_F(House, FailsACircleInTheTable) {
  write("docs/architecture.md",
        "<!-- arrows: begin -->\n| `ground/` | `upper/` |\n| `upper/` | `ground/` |\n<!-- arrows: end -->\n");
  EXPECT_EQ(check(), "docs/architecture.md: arrows run in a circle: ground/ upper/ ground/\nexit 1");
}

TEST_F(House, AsksForATable) {
  write("docs/architecture.md", "no table\n");
  EXPECT_EQ(check(), "tools/arrows: docs/architecture.md has no table of arrows\nexit 2");
}

}  // namespace
}  // namespace reorient
