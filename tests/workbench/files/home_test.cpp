// SPDX-License-Identifier: MIT
// The meaning of a name on the command line.
#include "workbench/files/home.h"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr std::array<std::string_view, 1> kToml{".toml"};

/// The folder in which a program runs.
class InAFolder {
 public:
  explicit InAFolder(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  InAFolder(const InAFolder&) = delete;
  InAFolder& operator=(const InAFolder&) = delete;
  ~InAFolder() { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_;
};

TEST(AssetName, MeansAFileOfThatPathBeforeAnAsset) {
  const TemporaryFolder folder;
  folder.write("hard", "");
  const InAFolder here(folder.path());
  EXPECT_EQ(asset_file("parameters/light", "hard", kToml), "hard");
}

TEST(AssetName, MeansAnAssetIfAFolderHasThatName) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "localization");
  const InAFolder here(folder.path());
  const std::filesystem::path file = asset_file("experiments", "localization", kToml);
  EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
}

TEST(AssetName, IsUnchangedWithoutFileAndAsset) {
  EXPECT_EQ(asset_file("experiments", "no_such_experiment", kToml), "no_such_experiment");
}

TEST(OtherHome, IsTheProjectAroundAFolderIfItIsNotTheProgramsOwn) {
  const TemporaryFolder folder;
  EXPECT_EQ(other_home_around(folder.path()), "");
  EXPECT_EQ(other_home_around(find_home() / "scripts" / "lib"), "") << "the program's own";
  std::filesystem::create_directories(folder.path() / "project/scripts/behaviors/mine");
  EXPECT_EQ(other_home_around(folder.path() / "project"), "") << "no assets";
  std::filesystem::create_directories(folder.path() / "project/assets");
  EXPECT_EQ(other_home_around(folder.path() / "project/scripts/behaviors/mine"), folder.path() / "project");
  EXPECT_EQ(other_home_around(folder.path()), "");
  EXPECT_EQ(other_home_around(""), "");
}

}  // namespace
}  // namespace reorient
