#include "robots/companion/image_formats.h"

#include <vector>

#include <gtest/gtest.h>

#include "robots/companion/reorient_companion.h"

namespace reorient {
namespace {

std::size_t bytes_of_image(std::uint32_t format, int width = 64, int height = 64) {
  reorient_camera camera{};
  camera.width = static_cast<std::uint16_t>(width);
  camera.height = static_cast<std::uint16_t>(height);
  camera.format = format;
  return reorient_image_bytes(&camera);
}

Image converted(std::vector<std::uint8_t> bytes, std::uint32_t format, int width = 2, int height = 2) {
  EXPECT_EQ(bytes.size(), bytes_of_image(format, width, height));
  Image image(width, height);
  convert_image(bytes, format, image);
  return image;
}

TEST(ImageFormats, OursIsCopied) {
  const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(converted(bytes, REORIENT_YUYV).bytes(), bytes);
}

TEST(ImageFormats, Nv12SharesItsChromaBetweenTwoRows) {
  const Image image = converted({10, 11, 20, 21, 100, 200}, REORIENT_NV12);
  EXPECT_EQ(image.bytes(), (std::vector<std::uint8_t>{10, 100, 11, 200, 20, 100, 21, 200}));
}

TEST(ImageFormats, GreyHasNoColor) {
  EXPECT_EQ(converted({1, 2, 3, 4}, REORIENT_GREY).bytes(),
            (std::vector<std::uint8_t>{1, 128, 2, 128, 3, 128, 4, 128}));
}

TEST(ImageFormats, RedGreenAndBlueAreThoseOfBt601) {
  const Image white = converted(std::vector<std::uint8_t>(12, 255), REORIENT_RGB);
  EXPECT_EQ(white.view().at(0, 0), (Ycbcr{255, 128, 128}));
  const std::vector<std::uint8_t> red{255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0};
  EXPECT_EQ(converted(red, REORIENT_RGB).view().at(1, 1), (Ycbcr{76, 85, 255}));
  EXPECT_EQ(converted(red, REORIENT_BGR).view().at(1, 1), (Ycbcr{29, 255, 107})) << "that is blue, then";
}

TEST(ImageFormats, ThatThereAreNotHaveNoSize) {
  for (const std::uint32_t format : {0u, 6u, 4000000000u}) EXPECT_EQ(bytes_of_image(format), 0u);
}

}  // namespace
}  // namespace reorient
