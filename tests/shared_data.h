// SPDX-License-Identifier: MIT
// Access to real data (camera images, rooms) that is too large for the repository.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace reorient {

/// A test that reads the folder $REORIENT_SHARED/`name`. If the folder is missing, GoogleTest reports the test as
/// skipped, with the reason.
class SharedDataTest : public testing::Test {
 protected:
  explicit SharedDataTest(const std::string& name) : name_(name) {}

  void SetUp() override {
    const char* const root = std::getenv("REORIENT_SHARED");
    if (root == nullptr || *root == '\0') GTEST_SKIP() << "REORIENT_SHARED is not set";
    if (!std::filesystem::is_directory(std::filesystem::path(root) / name_)) {
      GTEST_SKIP() << "REORIENT_SHARED=" << root << ": missing folder " << name_ << "/";
    }
    folder_ = std::filesystem::path(root) / name_;
  }

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::string name_;
  std::filesystem::path folder_;
};

}  // namespace reorient
