// SPDX-License-Identifier: MIT
#include "robots/footage/raw_image.h"

#include <string>

#include <gtest/gtest.h>

#include "robots/footage/footage.h"

namespace reorient {
namespace {

messages::RawImage raw(const std::string& encoding, std::uint32_t width, std::uint32_t height, std::uint32_t step,
                       const std::vector<int>& values) {
  messages::RawImage image{{}, width, height, encoding, step, {}};
  for (const int value : values) image.data.push_back(static_cast<std::byte>(value));
  return image;
}

std::string error_of(const messages::RawImage& image) {
  try {
    static_cast<void>(image_of(image));
  } catch (const BadFootage& bad) {
    return bad.what();
  }
  return {};
}

TEST(RawImage, OfEachEncodingBecomesYcbcr) {
  using Pixels = std::vector<std::uint8_t>;
  for (const char* const encoding : {"yuv422_yuy2", "yuyv"})
    EXPECT_EQ(image_of(raw(encoding, 2, 1, 4, {1, 2, 3, 4})).bytes(), (Pixels{1, 2, 3, 4}));
  for (const char* const encoding : {"yuv422", "uyvy"})
    EXPECT_EQ(image_of(raw(encoding, 2, 1, 4, {1, 2, 3, 4})).bytes(), (Pixels{2, 1, 4, 3}));
  EXPECT_EQ(image_of(raw("mono8", 2, 1, 2, {1, 2})).bytes(), (Pixels{1, 128, 2, 128}));
  EXPECT_EQ(image_of(raw("nv12", 2, 2, 2, {1, 2, 3, 4, 5, 6})).bytes(), (Pixels{1, 5, 2, 6, 3, 5, 4, 6}));
  const Pixels red{76, 85, 76, 255};
  EXPECT_EQ(image_of(raw("rgb8", 2, 1, 6, {255, 0, 0, 255, 0, 0})).bytes(), red);
  EXPECT_EQ(image_of(raw("bgr8", 2, 1, 6, {0, 0, 255, 0, 0, 255})).bytes(), red);
  EXPECT_EQ(image_of(raw("rgba8", 2, 1, 8, {255, 0, 0, 1, 255, 0, 0, 2})).bytes(), red);
  EXPECT_EQ(image_of(raw("bgra8", 2, 1, 8, {0, 0, 255, 1, 0, 0, 255, 2})).bytes(), red);
}

TEST(RawImage, OfOddWidthLosesItsLastColumn) {
  const Image image = image_of(raw("mono8", 3, 2, 4, {1, 2, 3, 0, 4, 5, 6}));
  EXPECT_EQ(image.width(), 2);
  EXPECT_EQ(image.bytes(), (std::vector<std::uint8_t>{1, 128, 2, 128, 4, 128, 5, 128}));
}

TEST(RawImage, OfAnUnknownEncodingIsRefusedWithAListOfTheKnownEncodings) {
  EXPECT_EQ(error_of(raw("16UC1", 2, 1, 4, {1, 2, 3, 4})),
            "image encoding: expected one of rgb8, bgr8, rgba8, bgra8, mono8, yuv422, uyvy, yuv422_yuy2, yuyv, nv12, "
            "found '16UC1'");
}

TEST(RawImage, WithAnInvalidSizeOrTooFewBytesIsRefused) {
  EXPECT_EQ(error_of(raw("rgb8", 2, 1, 5, {1, 2, 3, 4, 5, 6})),
            "image step: expected at least 6 bytes for 2 pixels of rgb8, found 5");
  EXPECT_EQ(error_of(raw("rgb8", 2, 2, 8, {1, 2, 3, 4, 5, 6})), "image data: expected at least 14 bytes, found 6");
  EXPECT_EQ(error_of(raw("rgb8", 70000, 2, 8, {})), "image size: expected 2x1 to 16384x16384 pixels, found 70000x2");
  EXPECT_NE(error_of(raw("mono8", 16384, 16384, 0xFFFFFFFF, {1})), "");
}

}  // namespace
}  // namespace reorient
