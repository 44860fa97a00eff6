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

TEST(ImageFormats, OursIsCopied) {
  const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(converted(bytes, PixelFormat::yuyv).bytes(), bytes);
}

TEST(ImageFormats, Nv12SharesItsChromaBetweenTwoRows) {
  const Image image = converted({10, 11, 20, 21, 100, 200}, PixelFormat::nv12);
  EXPECT_EQ(image.bytes(), (std::vector<std::uint8_t>{10, 100, 11, 200, 20, 100, 21, 200}));
}

TEST(ImageFormats, GrayHasNoColor) {
  EXPECT_EQ(converted({1, 2, 3, 4}, PixelFormat::gray).bytes(),
            (std::vector<std::uint8_t>{1, 128, 2, 128, 3, 128, 4, 128}));
}

TEST(ImageFormats, RedGreenAndBlueAreThoseOfBt601) {
  const Image white = converted(std::vector<std::uint8_t>(12, 255), PixelFormat::rgb);
  EXPECT_EQ(white.view().at(0, 0), (Ycbcr{255, 128, 128}));
  const std::vector<std::uint8_t> red{255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0};
  EXPECT_EQ(converted(red, PixelFormat::rgb).view().at(1, 1), (Ycbcr{76, 85, 255}));
  EXPECT_EQ(converted(red, PixelFormat::bgr).view().at(1, 1), (Ycbcr{29, 255, 107})) << "that is blue, then";
}

}  // namespace
}  // namespace reorient
