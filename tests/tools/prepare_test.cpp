// What ./reorient and ./test do before they build, with programs that only say how they were called.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class Tree : public testing::Test {
 protected:
  Tree() {
    write_program("cmake", "echo \"cmake $*\" >>\"$PWD/calls\"");
    write_program("dpkg-query", "echo installed bash");
    write_program("apt-get", "exit 1");
    folder.write("tools/packages", "# what is needed\nbash\n");
    std::filesystem::copy(std::filesystem::path(kSourceFolder) / "tools" / "prepare",
                          folder.path() / "tools" / "prepare");
  }

  void write_program(const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder.write("bin/" + name, "#!/bin/sh\n" + text + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }

  void configured_for(const std::filesystem::path& home) {
    folder.write("build/release/build.ninja", "");
    folder.write("build/release/CMakeCache.txt", "A:STRING=b\nCMAKE_HOME_DIRECTORY:INTERNAL=" + home.string() + "\n");
  }

  /// What a build says, and then how cmake was called.
  std::string build() {
    const std::string at = "cd '" + folder.path().string() + "' && export PATH=\"$PWD/bin:$PATH\" REORIENT_JOBS=3 && ";
    const std::string command = at + "bash -euo pipefail -c '. tools/prepare; build all' 2>&1; cat '" +
                                (folder.path() / "calls").string() + "'";
    std::string text;
    FILE* const pipe = popen(command.c_str(), "r");
    std::array<char, 256> buffer;
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) text += buffer.data();
    pclose(pipe);
    return text;
  }

  TemporaryFolder folder;
};

constexpr const char* kBuilds = "cmake --build --preset release -j 3 --target all\n";

TEST_F(Tree, IsConfiguredWhereThereIsNoBuild) {
  EXPECT_EQ(build(), std::string("reorient: building (a few minutes, once)\ncmake --preset release\n") + kBuilds);
}

TEST_F(Tree, IsNotConfiguredAgainWhereItStayed) {
  configured_for(folder.path());
  EXPECT_EQ(build(), kBuilds);
}

TEST_F(Tree, IsConfiguredAfreshWhereItWasMoved) {
  configured_for("/where/it/was");
  EXPECT_EQ(build(), std::string("reorient: this tree was at /where/it/was; building anew (a few minutes, once)\n"
                                 "cmake --fresh --preset release\n") +
                         kBuilds);
}

TEST_F(Tree, IsConfiguredAfreshWhereItIsACopy) {
  const TemporaryFolder original;
  configured_for(original.path());
  EXPECT_EQ(build(), "reorient: this tree was at " + original.path().string() +
                         "; building anew (a few minutes, once)\ncmake --fresh --preset release\n" + kBuilds);
}

}  // namespace
}  // namespace reorient
