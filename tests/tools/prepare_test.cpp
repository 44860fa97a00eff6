// SPDX-License-Identifier: MIT
// tools/prepare, which ./reorient and ./test use before they build, with programs that only print their arguments.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
#include "tests/tools/tool_tree.h"

namespace reorient {
namespace {

class Tree : public testing::Test, protected ToolTree {
 protected:
  Tree() {
    write_program("cmake", "echo \"cmake $*\" >>\"$PWD/calls\"");
    write_program("dpkg-query", "echo installed bash");
    write_program("apt-get", "exit 1");
    folder.write("tools/packages", "# what is needed\nbash\n");
    copy("tools/prepare");
  }

  void configured_for(const std::filesystem::path& home) {
    folder.write("build/release/build.ninja", "");
    folder.write("build/release/CMakeCache.txt", "A:STRING=b\nCMAKE_HOME_DIRECTORY:INTERNAL=" + home.string() + "\n");
  }

  /// The output of a build, then the arguments of cmake.
  std::string build() { return run("export REORIENT_JOBS=3; . tools/prepare; build all; cat calls").text; }

  std::string install_optional_packages() {
    folder.write("tools/packages-all", "# more\nbash\none\ntwo cmake\nthree command-that-is-missing\n");
    const Result result = run(". tools/prepare; install_optional_packages tools/packages-all");
    EXPECT_EQ(result.code, 0);
    return result.text;
  }
};

constexpr const char* kBuilds = "cmake --build --preset release -j 3 --target all\n";

TEST_F(Tree, IsConfiguredIfNoBuildExists) {
  EXPECT_EQ(build(), std::string("reorient: building (a few minutes, once)\ncmake --preset release\n") + kBuilds);
}

TEST_F(Tree, IsNotConfiguredAgainAtTheSamePath) {
  configured_for(folder.path());
  EXPECT_EQ(build(), kBuilds);
}

TEST_F(Tree, IsConfiguredAgainAfterItWasMoved) {
  configured_for("/where/it/was");
  EXPECT_EQ(build(),
            std::string("reorient: the build folder belongs to /where/it/was; building again (a few minutes, once)\n"
                        "cmake --fresh --preset release\n") +
                kBuilds);
}

TEST_F(Tree, IsConfiguredAgainIfItIsACopy) {
  const TemporaryFolder original;
  configured_for(original.path());
  EXPECT_EQ(build(), "reorient: the build folder belongs to " + original.path().string() +
                         "; building again (a few minutes, once)\ncmake --fresh --preset release\n" + kBuilds);
}

TEST_F(Tree, InstallsOptionalPackagesWhoseCommandIsMissing) {
  write_program("id", "echo 0");
  write_program("apt-get", "for last; do :; done; echo \"$last\" >>\"$PWD/calls\"");
  EXPECT_EQ(install_optional_packages(), "reorient: installing with apt: one three\n");
  EXPECT_NE(run("cat calls").text.find("\none\nthree\n"), std::string::npos);
}

TEST_F(Tree, ContinuesWithoutAnOptionalPackageThatIsUnknownToApt) {
  write_program("id", "echo 0");
  write_program("apt-get", "for last; do :; done; [ \"$last\" != one ]");
  EXPECT_EQ(install_optional_packages(),
            "reorient: installing with apt: one three\n"
            "reorient: apt could not install: one (tests that need them are skipped)\n");
}

TEST_F(Tree, ContinuesWithoutOptionalPackagesIfRootIsNotAvailable) {
  write_program("id", "echo 1000");
  write_program("sudo", "exit 1");
  EXPECT_EQ(install_optional_packages(),
            "reorient: not installed, because this needs root or sudo: one three (tests that need them are skipped)\n");
}

}  // namespace
}  // namespace reorient
