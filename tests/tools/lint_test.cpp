// SPDX-License-Identifier: MIT
// tools/lint on small trees.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr const char* kCleanHeader = "#pragma once\ninline int* address() { return nullptr; }\n";
constexpr const char* kHeaderWithFinding = "#pragma once\ninline int* address() { return 0; }\n";

/// The output of a command and its exit code.
std::string output_of(const std::string& command) {
  std::string text;
  FILE* const pipe = popen(command.c_str(), "r");
  std::array<char, 256> buffer;
  while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) text += buffer.data();
  return text + "exit " + std::to_string(WEXITSTATUS(pclose(pipe)));
}

/// A tree with two sources that share a header. Its scripts, includes, links, licenses and words are always clean.
class LintedTree {
 public:
  explicit LintedTree(const TemporaryFolder& cache) : cache_(cache) {
    write("CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\nproject(small LANGUAGES CXX)\n"
          "add_library(small STATIC part/a.cpp part/b.cpp)\ntarget_include_directories(small PRIVATE .)\n");
    write("part/shared.h", kCleanHeader);
    write("part/a.cpp", "#include \"part/shared.h\"\n\nint* a() { return address(); }\n");
    write("part/b.cpp", "#include \"part/shared.h\"\n\nint* b() { return address(); }\n");
    write(".clang-tidy", "Checks: '-*,modernize-use-nullptr,clang-analyzer-core.*'\nWarningsAsErrors: '*'\n");
    write(".clang-format", "BasedOnStyle: Google\n");
    write("tools/prepare", "install_packages() { :; }\n");
    write("scripts/a.lua", "");
    write_program("tools/arrows", "");
    write_program("tools/links", "");
    write_program("tools/spdx", "");
    write_program("tools/words", "");
    write_program("bin/luacheck", "");
    std::filesystem::copy(std::filesystem::path(kSourceFolder) / "tools" / "lint", folder_.path() / "tools" / "lint");
  }

  void write(const std::string& file, const std::string& text) { folder_.write(file, text); }

  void write_program(const std::string& file, const std::string& text) {
    std::filesystem::permissions(folder_.write(file, "#!/bin/sh\n" + text + "\n"), std::filesystem::perms::owner_all);
  }

  std::string lint(const std::string& options = "") { return run("tools/lint " + options); }

  /// Runs a line of shell at the top of the tree. Returns its output and its exit code.
  std::string run(const std::string& line) {
    return output_of("cd '" + folder_.path().string() + "' && export PATH=\"$PWD/bin:$PATH\" XDG_CACHE_HOME='" +
                     cache_.path().string() + "' && { " + line + "; } 2>&1");
  }

  bool has_batches() const { return std::filesystem::exists(folder_.path() / "build" / "lint" / "batches"); }

 private:
  const TemporaryFolder& cache_;
  TemporaryFolder folder_;
};

class Lint : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("{ clang-tidy-14 --version && clang-format-14 --version; } >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "clang-tidy-14 or clang-format-14 is not installed (Debian 12: apt-get install clang-tidy "
                      "clang-format)";
    }
  }

  TemporaryFolder cache;
  LintedTree tree{cache};
};

TEST_F(Lint, ReportsAFindingInAHeaderOnce) {
  tree.write("part/shared.h", kHeaderWithFinding);
  EXPECT_EQ(tree.lint(),
            "tools/lint: clang-tidy reads 2 sources\npart/shared.h:2:32: use nullptr [modernize-use-nullptr]\n"
            "tools/lint: 1 finding\nexit 1");
}

TEST_F(Lint, ReportsAFindingInASourceWithItsOwnLineAndReadsOnlyThisSourceAgain) {
  tree.write("part/b.cpp", "#include \"part/shared.h\"\n\nint* b() { return 0; }  // error: here\n");
  const std::string finding = "part/b.cpp:3:19: use nullptr [modernize-use-nullptr]\ntools/lint: 1 finding\nexit 1";
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 2 sources\n" + finding);
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 1 sources\n" + finding);
}

TEST_F(Lint, ReportsAThreadThatTheThreadSanitizerWouldNotSee) {
  tree.write("tests/a.cpp", "std::thread here(allowed);\n");
  tree.write("part/a.cpp", "int count = std::thread::hardware_concurrency();\nstd::jthread hidden(work);\n");
  EXPECT_EQ(tree.lint("--quick"),
            "part/a.cpp:2: starts a thread, which MAY_START_THREADS in tools/lint does not list\n"
            "tools/lint: 1 finding\nexit 1");
}

TEST_F(Lint, ReportsTheFirstLineOfAFileThatIsNotFormatted) {
  tree.write("part/a.cpp", "int  a();\nint  b();\n");
  EXPECT_EQ(tree.lint("--quick"),
            "part/a.cpp:1: not formatted; run: clang-format -i part/a.cpp\ntools/lint: 1 finding\nexit 1");
}

TEST_F(Lint, ReportsASourceThatDoesNotCompileOnEachRun) {
  tree.write("part/a.cpp", "#include \"part/shared.h\"\n\nint* a() { return missing(); }\n");
  const std::string result =
      "tools/lint: clang-tidy reads 2 sources\n"
      "part/a.cpp:3:19: use of undeclared identifier 'missing' [clang-diagnostic-error]\n"
      "tools/lint: 1 finding\nexit 1";
  EXPECT_EQ(tree.lint(), result);
  EXPECT_EQ(tree.lint(), result);
}

TEST_F(Lint, UsesCleanResultsFromTheCacheInACloneAtAnotherPath) {
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 2 sources\nexit 0");
  LintedTree clone(cache);
  EXPECT_EQ(clone.lint(), "tools/lint: clang-tidy reads 0 sources\nexit 0");
}

TEST_F(Lint, ReadsTheSourcesAgainThatIncludeAChangedHeader) {
  tree.write("part/b.cpp", "int* b() { return nullptr; }\n");
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 2 sources\nexit 0");
  tree.write("part/shared.h", std::string(kCleanHeader) + "inline int* other() { return nullptr; }\n");
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 1 sources\nexit 0");
}

TEST_F(Lint, ReadsAllSourcesAgainWhenTheSettingsOfClangTidyChange) {
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 2 sources\nexit 0");
  tree.write(".clang-tidy", "Checks: '-*,modernize-use-nullptr,misc-redundant-expression'\nWarningsAsErrors: '*'\n");
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 2 sources\nexit 0");
}

TEST_F(Lint, RunsTheAnalyzerOnlyWithAll) {
  tree.write("part/a.cpp", "int a() {\n  int* const nothing = nullptr;\n  return *nothing;\n}\n");
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 2 sources\nexit 0");
  EXPECT_EQ(tree.lint("--all"),
            "tools/lint: clang-tidy reads 2 sources\npart/a.cpp:3:10: Dereference of null pointer (loaded from "
            "variable 'nothing') [clang-analyzer-core.NullDereference]\ntools/lint: 1 finding\nexit 1");
}

TEST_F(Lint, ReadsSourcesThatNoTargetCompiles) {
  tree.write("loose/c.cpp", "#include <reorient/part/shared.h>\n\nint* c() { return address(); }\n");
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 3 sources\nexit 0");
  tree.write("part/shared.h", kHeaderWithFinding);
  EXPECT_EQ(tree.lint(),
            "tools/lint: clang-tidy reads 3 sources\npart/shared.h:2:32: use nullptr [modernize-use-nullptr]\n"
            "tools/lint: 1 finding\nexit 1");
}

TEST_F(Lint, AcceptsEqualNamesInDifferentTargets) {
  tree.write("CMakeLists.txt",
             "cmake_minimum_required(VERSION 3.25)\nproject(small LANGUAGES CXX)\n"
             "add_library(one STATIC part/a.cpp)\nadd_library(two STATIC part/b.cpp)\n");
  tree.write("part/a.cpp", "int first = 1, same = 2;\n");
  tree.write("part/b.cpp", "int second = 1, same = 2;\n");
  EXPECT_EQ(tree.lint(), "tools/lint: clang-tidy reads 2 sources\nexit 0");
}

TEST_F(Lint, ReadsOnlyChangedSourcesWithSince) {
  tree.write(".gitignore", "/build/\n");
  EXPECT_EQ(tree.run("git init -q && git add . && git -c user.name=a -c user.email=a@b commit -qm first"), "exit 0");
  tree.write("part/b.cpp", "int* b() { return nullptr; }\n");
  EXPECT_EQ(tree.lint("--since HEAD"), "tools/lint: clang-tidy reads 1 sources\nexit 0");
}

TEST_F(Lint, WorksWithoutAFolderForItsCache) {
  EXPECT_EQ(tree.run("XDG_CACHE_HOME=/dev/null tools/lint"), "tools/lint: clang-tidy reads 2 sources\nexit 0");
}

TEST_F(Lint, RejectsAnUnknownOptionWithExitCode2) {
  EXPECT_EQ(tree.lint("--fast"),
            "tools/lint: unrecognized arguments: --fast (expected --quick, --all or --since REV)\nexit 2");
}

TEST_F(Lint, LeavesNoProcessAndNoFileWhenItIsInterrupted) {
  // Replace clang-tidy with a program that has a child that takes too long.
  tree.write_program("bin/clang-tidy-14",
                     "[ \"$1\" = --version ] && { echo 'LLVM version 14.0.6'; exit; }\n"
                     "sleep 1000 & echo $! >../../started.new; mv ../../started.new ../../started; wait");
  EXPECT_EQ(
      tree.run("REORIENT_JOBS=1 tools/lint & lint=$!; until [ -e started ]; do sleep 0.05; done; "
               "kill -TERM $lint; wait $lint; echo \"lint $?\"; ! grep -qs sleep \"/proc/$(cat started)/cmdline\""),
      "tools/lint: clang-tidy reads 2 sources\nlint 143\nexit 0");
  EXPECT_FALSE(tree.has_batches());
}

}  // namespace
}  // namespace reorient
