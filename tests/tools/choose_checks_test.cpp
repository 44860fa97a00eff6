// SPDX-License-Identifier: MIT
// tools/choose-checks in a small project with a history.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr const char* kArchitecture = R"(<!-- arrows: begin -->
| room | may include | what lives there |
|---|---|---|
| `geometry/` | – | x |
| `engine/` | `geometry/` | x |
| `engine/script/` | – | x |
| `program/` | everything | x |
| `tests/` | everything | x |
<!-- arrows: end -->
)";
constexpr const char* kGroups = R"(<!-- groups: begin -->
| group | concerned by | what it covers |
|---|---|---|
| `runs` | `engine/`, `scripts/`, `tests/runs/`, `*.hpp` | x |
| `bundles` | `program/` | x |
| `sanitizers` | `program/`, `tests/engine/` | x |
| `gate` | `docs/`, `tests/`, `README.md` | x |
<!-- groups: end -->
)";

class ChooseChecks : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "git is not installed";
    folder_.write("docs/architecture.md", kArchitecture);
    folder_.write("CONTRIBUTING.md", kGroups);
    folder_.write("tests/engine/frame_test.cpp", "TEST(Frame, IsAValue) {}\n");
    for (const char* const file : {"geometry/angle.h", "engine/frame.cpp", "engine/script/host.cpp", "program/main.cpp",
                                   "scripts/scan.lua", "README.md", "docs/frame.md"})
      folder_.write(file, "1\n");
    folder_.write("tools/choose-checks", "");
    std::filesystem::copy_file(std::filesystem::path(kSourceFolder) / "tools" / "choose-checks",
                               folder_.path() / "tools" / "choose-checks",
                               std::filesystem::copy_options::overwrite_existing);
    git("init -q -b main");
    commit("first");
    run("tools/choose-checks --record .ci/last-full-run");
    commit("the record");
  }

  std::string run(const std::string& command) const {
    const std::string line = "cd '" + folder_.path().string() + "' && mkdir -p .ci && env -u REORIENT_CI " + command +
                             " 2>&1; echo \"code $?\"";
    std::string text;
    FILE* const pipe = popen(line.c_str(), "r");
    std::array<char, 256> buffer;
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) text += buffer.data();
    pclose(pipe);
    return text;
  }
  void git(const std::string& words) const {
    const std::string said = run("git -c user.name=a -c user.email=a@b -c commit.gpgsign=false " + words);
    EXPECT_TRUE(said.ends_with("code 0\n")) << said;
  }
  void commit(const std::string& title) const {
    git("add -A");
    git("commit -q --allow-empty -m '" + title + "'");
  }
  /// The names that are chosen after a file was changed and committed, each with a blank after it.
  std::string chosen_after(const std::string& file) const {
    folder_.write(file, "2\n");
    commit("a change");
    return run("tools/choose-checks 2>/dev/null | cut -f 1 | tr '\\n' ' '");
  }
  std::string choice() const { return run("tools/choose-checks"); }

  TemporaryFolder folder_;
};

constexpr const char* kEverything = "everything runs bundles sanitizers code 0\n";

TEST_F(ChooseChecks, ChoosesNothingIfNothingChanged) { EXPECT_NE(choice().find("changed since"), std::string::npos); }

TEST_F(ChooseChecks, ChoosesTheGroupsThatDependOnAChange) {
  EXPECT_EQ(chosen_after("geometry/angle.h"), "runs bundles sanitizers code 0\n");
}

TEST_F(ChooseChecks, LeavesOutGroupsThatDoNotDependOnAChange) {
  EXPECT_EQ(chosen_after("engine/script/host.cpp"), "bundles sanitizers code 0\n");
}

TEST_F(ChooseChecks, ChoosesGroupsByPathOutsideOfTheArchitecture) {
  EXPECT_EQ(chosen_after("scripts/scan.lua"), "runs code 0\n");
}

TEST_F(ChooseChecks, ChoosesGroupsByFileExtension) { EXPECT_EQ(chosen_after("docs/a.hpp"), "runs code 0\n"); }

TEST_F(ChooseChecks, RunsNoMoreThanTheGateForADocument) { EXPECT_EQ(chosen_after("docs/frame.md"), "code 0\n"); }

TEST_F(ChooseChecks, ChoosesOnlyItsOwnGroupsForAChangedTest) {
  EXPECT_EQ(chosen_after("tests/runs/run_test.cpp"), "runs code 0\n");
}

TEST_F(ChooseChecks, ListsTheFoldersForTheSanitizers) {
  folder_.write("engine/frame.cpp", "2\n");
  folder_.write("tests/engine/state_test.cpp", "2\n");
  EXPECT_NE(choice().find("sanitizers\tengine\t"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, RunsEverythingForAFileThatNoGroupLists) {
  EXPECT_EQ(chosen_after("something.new"), kEverything);
  EXPECT_NE(choice().find("something.new is in neither table"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, RunsEverythingForChangesOfTheBuildAndOfTheChoice) {
  for (const char* const file :
       {"cmake/tests.cmake", "CMakePresets.json", "tools/packages-lint", ".ci/run", "tests/paths.h"}) {
    folder_.write(file, "2\n");
    EXPECT_NE(choice().find(std::string(file) + " concerns every check"), std::string::npos) << choice();
    std::filesystem::remove(folder_.path() / file);
  }
}

TEST_F(ChooseChecks, IncludesUncommittedChanges) {
  folder_.write("scripts/scan.lua", "2\n");
  EXPECT_NE(choice().find("runs\t\tscripts/scan.lua"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, IncludesARemovedFile) {
  std::filesystem::remove(folder_.path() / "scripts/scan.lua");
  commit("removed");
  EXPECT_NE(choice().find("runs\t\tscripts/scan.lua"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, ReportsARemovedTest) {
  folder_.write("tests/engine/frame_test.cpp", "");
  commit("a test is removed");
  EXPECT_NE(choice().find("removed since "), std::string::npos) << choice();
  EXPECT_NE(choice().find("TEST(Frame, IsAValue)"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, RunsEverythingOnRequest) {
  EXPECT_NE(run("env REORIENT_CI=all tools/choose-checks").find("runs\t\tREORIENT_CI=all"), std::string::npos);
}

TEST_F(ChooseChecks, IgnoresARecordThatDoesNotMatch) {
  const std::string file = ".ci/last-full-run";
  const std::string good = run("cat .ci/last-full-run");
  const std::string commit = good.substr(0, 40), digest = good.substr(52, 64);
  const std::pair<std::string, const char*> damages[] = {
      {"", "expected a commit, a date and a digest"},
      {"main 2026-01-01 " + digest, "expected a commit, a date and a digest"},
      {std::string(40, 'a') + " 2026-01-01 " + digest, "is not an ancestor of HEAD"},
      {commit + " 2026-01-01 " + std::string(64, '0'), "the digest does not match"},
  };
  for (const auto& [text, why] : damages) {
    folder_.write(file, text + "\n");
    EXPECT_NE(choice().find(why), std::string::npos) << choice();
    EXPECT_NE(choice().find("bundles\t\t"), std::string::npos) << "everything runs";
  }
  std::filesystem::remove(folder_.path() / file);
  EXPECT_NE(choice().find("is missing"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, IgnoresARecordOfAnotherBranch) {
  git("checkout -q --orphan other");
  commit("another history");
  EXPECT_NE(choice().find("is not an ancestor of HEAD"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, RunsEverythingAgainAfterAWeekOrManyCommits) {
  git("checkout -q --orphan old");
  run("git -c user.name=a -c user.email=a@b add -A; GIT_COMMITTER_DATE='2020-01-01T00:00:00Z' git -c user.name=a -c "
      "user.email=a@b "
      "-c commit.gpgsign=false commit -q -m old");
  run("tools/choose-checks --record .ci/last-full-run");
  EXPECT_NE(choice().find("days old (limit 7)"), std::string::npos) << choice();
  git("checkout -q -f main");
  for (int i = 0; i < 151; ++i) git("commit -q --allow-empty -m more");
  EXPECT_NE(choice().find("commits old (limit 150)"), std::string::npos) << choice();
}

TEST_F(ChooseChecks, RecordsOnlyACommittedTree) {
  folder_.write("scripts/scan.lua", "3\n");
  const std::string said = run("tools/choose-checks --record .ci/last-full-run");
  EXPECT_NE(said.find("is not written: the work tree differs from HEAD (scripts/scan.lua)"), std::string::npos) << said;
}

TEST_F(ChooseChecks, RefusesUnknownArguments) {
  EXPECT_NE(run("tools/choose-checks --all").find("unknown arguments: --all"), std::string::npos);
  EXPECT_TRUE(run("tools/choose-checks --record elsewhere").ends_with("code 2\n"));
  folder_.write("CONTRIBUTING.md", "no table\n");
  EXPECT_NE(choice().find("CONTRIBUTING.md: expected a table between"), std::string::npos) << choice();
  EXPECT_TRUE(choice().ends_with("code 2\n"));
}

}  // namespace
}  // namespace reorient
