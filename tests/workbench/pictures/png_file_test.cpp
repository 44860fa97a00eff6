// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/canvas/png_file.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <png.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

namespace reorient::pictures {
namespace {

namespace fs = std::filesystem;

class PngFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("reorient-png-" + std::to_string(::getpid()) + "-" + test->name());
    fs::create_directories(folder_);
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  long files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  fs::path folder_;
};

using PngFileProperty = PngFile;

Picture gradient(int width, int height) {
  Picture picture{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) picture.bytes.push_back(static_cast<std::uint8_t>(i * 7));
  return picture;
}

Picture decode(const fs::path& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, file.c_str()) == 0) return {};
  header.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  picture.bytes.resize(PNG_IMAGE_SIZE(header));
  if (png_image_finish_read(&header, nullptr, picture.bytes.data(), 0, nullptr) == 0) return {};
  return picture;
}

std::string refusal(const fs::path& file, const Picture& picture) {
  try {
    write_png(file, picture);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

RC_GTEST_FIXTURE_PROP(PngFileProperty, RestoresTheSamePixels, ()) {
  const int width = *rc::gen::inRange(1, 40);
  const int height = *rc::gen::inRange(1, 40);
  const auto size = std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const Picture picture{width, height,
                        *rc::gen::container<std::vector<std::uint8_t>>(size, rc::gen::arbitrary<std::uint8_t>())};
  write_png(folder_ / "picture.png", picture);
  RC_ASSERT(decode(folder_ / "picture.png") == picture);
}

TEST_F(PngFile, ReplacesAnOlderPictureAndLeavesNoOtherFile) {
  write_png(folder_ / "picture.png", gradient(5, 4));
  write_png(folder_ / "picture.png", gradient(9, 3));
  EXPECT_EQ(decode(folder_ / "picture.png"), gradient(9, 3));
  EXPECT_EQ(files(), 1);
}

TEST_F(PngFile, ReportsFileAndReasonInOneLineIfTheFolderDoesNotExist) {
  const std::string words = refusal(folder_ / "missing" / "picture.png", gradient(2, 2));
  EXPECT_NE(words.find("missing/picture.png"), std::string::npos) << words;
  EXPECT_NE(words.find("No such file or directory"), std::string::npos) << words;
  EXPECT_EQ(words.find('\n'), std::string::npos);
  EXPECT_EQ(files(), 0);
}

TEST_F(PngFile, RejectsAFolderThatIsAFile) {
  std::ofstream(folder_ / "out") << "not a folder";
  const std::string words = refusal(folder_ / "out" / "picture.png", gradient(2, 2));
  EXPECT_NE(words.find("Not a directory"), std::string::npos) << words;
  EXPECT_EQ(files(), 1);
}

TEST_F(PngFile, RejectsAFolderWithoutWritePermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root can write to every folder";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  const std::string words = refusal(folder_ / "picture.png", gradient(2, 2));
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_NE(words.find("Permission denied"), std::string::npos) << words;
  EXPECT_EQ(files(), 0);
}

TEST_F(PngFile, RemovesItsTemporaryFileIfTheNameIsAFolder) {
  fs::create_directories(folder_ / "picture.png" / "inside");
  EXPECT_NE(refusal(folder_ / "picture.png", gradient(2, 2)), "");
  EXPECT_TRUE(fs::is_directory(folder_ / "picture.png" / "inside"));
  EXPECT_EQ(files(), 1);
}

TEST_F(PngFile, RejectsPicturesWhoseBytesDoNotMatchTheirSize) {
  Picture short_of_bytes = gradient(4, 4);
  short_of_bytes.bytes.pop_back();
  for (const Picture& picture : {Picture{}, Picture{-3, -3, {}}, short_of_bytes})
    EXPECT_NE(refusal(folder_ / "picture.png", picture), "");
  EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace reorient::pictures
