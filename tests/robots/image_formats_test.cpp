// SPDX-License-Identifier: MIT
#include "robots/image_formats.h"

#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

Image converted(const std::vector<std::uint8_t>& bytes, PixelFormat format) {
  Image image(2, 2);
  convert_image(bytes, format, image);
  return image;
}

TEST(ImageFormats, YuyvIsCopied) {
  const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(converted(bytes, PixelFormat::yuyv).bytes(), bytes);
}

TEST(ImageFormats, Nv12HasOneRowOfChromaForTwoRows) {
  const Image image = converted({10, 11, 20, 21, 100, 200}, PixelFormat::nv12);
  EXPECT_EQ(image.bytes(), (std::vector<std::uint8_t>{10, 100, 11, 200, 20, 100, 21, 200}));
}

TEST(ImageFormats, GrayHasNoColor) {
  EXPECT_EQ(converted({1, 2, 3, 4}, PixelFormat::gray).bytes(),
            (std::vector<std::uint8_t>{1, 128, 2, 128, 3, 128, 4, 128}));
}

TEST(ImageFormats, RgbIsConvertedByBt601) {
  const Image white = converted(std::vector<std::uint8_t>(12, 255), PixelFormat::rgb);
  EXPECT_EQ(white.view().at(0, 0), (Ycbcr{255, 128, 128}));
  const std::vector<std::uint8_t> red{255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0};
  EXPECT_EQ(converted(red, PixelFormat::rgb).view().at(1, 1), (Ycbcr{76, 85, 255}));
  EXPECT_EQ(converted(red, PixelFormat::bgr).view().at(1, 1), (Ycbcr{29, 255, 107})) << "read as BGR, it is blue";
}

TEST(ImageFormats, UyvySwapsBytes) {
  EXPECT_EQ(converted({2, 1, 4, 3, 6, 5, 8, 7}, PixelFormat::uyvy).bytes(),
            (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(ImageFormats, TheFourthByteOfAPixelIsIgnored) {
  const std::vector<std::uint8_t> rgb{10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120};
  std::vector<std::uint8_t> rgba, bgra;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 7});
    bgra.insert(bgra.end(), {rgb[i + 2], rgb[i + 1], rgb[i], 9});
  }
  EXPECT_EQ(converted(rgba, PixelFormat::rgba).bytes(), converted(rgb, PixelFormat::rgb).bytes());
  EXPECT_EQ(converted(bgra, PixelFormat::bgra).bytes(), converted(rgb, PixelFormat::rgb).bytes());
}

TEST(ImageFormats, PaddingAfterRowsIsIgnored) {
  Image gray(2, 2), nv12(2, 2);
  convert_image(std::vector<std::uint8_t>{1, 2, 99, 3, 4}, PixelFormat::gray, 3, gray);
  EXPECT_EQ(gray.bytes(), converted({1, 2, 3, 4}, PixelFormat::gray).bytes());
  EXPECT_EQ(image_bytes(PixelFormat::gray, 2, 2, 3), 5u);
  convert_image(std::vector<std::uint8_t>{10, 11, 99, 20, 21, 99, 100, 200}, PixelFormat::nv12, 3, nv12);
  EXPECT_EQ(nv12.bytes(), converted({10, 11, 20, 21, 100, 200}, PixelFormat::nv12).bytes());
  EXPECT_EQ(image_bytes(PixelFormat::nv12, 2, 2, 3), 8u);
}

}  // namespace
}  // namespace reorient
