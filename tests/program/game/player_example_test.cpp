// SPDX-License-Identifier: MIT
// The player in examples/player, added to a copy of the shipped scripts as its page says.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class PlayerExample : public testing::Test {
 protected:
  PlayerExample() {
    std::filesystem::copy(kProjectFolder / "examples/player", scripts_,
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::skip_existing);
  }

  TemporaryFolder folder_;
  std::filesystem::path scripts_ = copy_scripts(folder_.path());
};

TEST_F(PlayerExample, HasNoFindingAndPassesItsTests) {
  const ProgramRun checked = run_reorient({"check", "--strict", "--scripts", scripts_.string()});
  EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  for (const auto& test : std::filesystem::directory_iterator(kProjectFolder / "examples/player/tests")) {
    const std::string file = (scripts_ / "tests" / test.path().filename()).string();
    const ProgramRun tested = run_reorient({"test", "--scripts", scripts_.string(), file});
    EXPECT_EQ(tested.code, 0) << tested.out << tested.err;
  }
}

TEST_F(PlayerExample, PlaysAGameAgainstItselfWithoutScriptErrors) {
  const std::string behaviors = "player,get_up,orientation,background_training";
  const ProgramRun played = run_reorient({"game", "--robots", "1", "--seconds", "40", "--scripts", scripts_.string(),
                                          "--behaviors", behaviors, "--behaviors-of-opponents", behaviors});
  EXPECT_EQ(played.code, 0) << played.out << played.err;
  EXPECT_EQ(played.out.find("1 script error"), std::string::npos) << played.out;
  EXPECT_EQ(played.err, "");
  EXPECT_NE(played.out.find("blue: "), std::string::npos) << played.out;
}

}  // namespace
}  // namespace reorient
