// SPDX-License-Identifier: MIT
// A run that writes all possible outputs, to be interrupted, slowed down and killed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <toml++/toml.h>

#include "tests/program/child_program.h"
#include "tests/temporary_folder.h"

namespace reorient {

inline constexpr const char* kPictures[] = {"world_view.png", "camera_view.png", "confidences.png",
                                            "reorientations.png"};

class RunWithAllOutputs : public ::testing::Test {
 protected:
  /// The arguments of a long run.
  std::vector<std::string> words(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"run",           "patrol",
                                 "--width",       "160",
                                 "--set",         "orientation.lingering=0.4",
                                 "--save-params", (folder.path() / "tuned.toml").string(),
                                 "--json",        (folder.path() / "run.json").string(),
                                 "--out",         (folder.path() / "pictures").string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  nlohmann::json json() const { return nlohmann::json::parse(read_text(folder.path() / "run.json")); }

  std::filesystem::path picture(const char* name) const { return folder.path() / "pictures" / name; }
  static bool is_whole_picture(const std::filesystem::path& file) {
    return read_text(file).ends_with(std::string("IEND\xAE\x42\x60\x82"));
  }

  void expect_all_outputs() const {
    EXPECT_EQ(json()["scenario"], "patrol");
    EXPECT_EQ(toml::parse_file((folder.path() / "tuned.toml").string())["orientation"]["lingering"].value<double>(),
              0.4);
    for (const char* name : kPictures) EXPECT_TRUE(is_whole_picture(picture(name))) << name;
  }
  /// Number of temporary files that were not renamed.
  int left_overs() const {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
      count += entry.path().string().ends_with(".partial");
    return count;
  }

  TemporaryFolder folder;
};

}  // namespace reorient
