// SPDX-License-Identifier: MIT
#include "robots/simulator/room/panorama.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>
#include <turbojpeg.h>

#include "robots/simulator/room/room.h"
#include "tests/paths.h"
#include "tests/shared_data.h"

namespace reorient {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 32;

/// A picture with two grays, in the left and in the right half; gamma-coded, three bytes per pixel.
std::vector<std::uint8_t> two_grays(std::uint8_t left, std::uint8_t right) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < kWidth * kHeight; ++i) pixels.insert(pixels.end(), 3, i % kWidth < kWidth / 2 ? left : right);
  return pixels;
}

std::vector<std::uint8_t> encode_png(const std::vector<std::uint8_t>& pixels) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = kWidth;
  png.height = kHeight;
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&png, nullptr, &size, 0, pixels.data(), 0, nullptr);
  std::vector<std::uint8_t> bytes(size);
  png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
  bytes.resize(size);
  return bytes;
}

std::vector<std::uint8_t> encode_jpeg(const std::vector<std::uint8_t>& pixels, int flags = 0) {
  const std::unique_ptr<void, decltype(&tjDestroy)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder.get(), pixels.data(), kWidth, 0, kHeight, TJPF_RGB, &data, &size, TJSAMP_444, 95, flags);
  std::vector<std::uint8_t> bytes(data, data + size);
  tjFree(data);
  return bytes;
}

template <typename Act>
std::string message_of(Act&& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

void expect_refused(const std::vector<std::uint8_t>& bytes, const std::string& part) {
  const std::string message = message_of([&] { decode_panorama(bytes, "room.file"); });
  EXPECT_NE(message.find("'room.file'"), std::string::npos) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Panorama, ConvertsTheGammaOfAPngToLinearLight) {
  const LinearImage image = decode_panorama(encode_png(two_grays(0, 188)), "test");
  ASSERT_EQ(image.width, kWidth);
  EXPECT_NEAR(image.at(5, 5).x(), 0.0f, 1e-3f);
  EXPECT_NEAR(image.at(60, 5).y(), 0.503f, 0.01f);
}

TEST(Panorama, ConvertsTheGammaOfAJpegToLinearLight) {
  const LinearImage image = decode_panorama(encode_jpeg(two_grays(20, 188)), "test");
  ASSERT_EQ(image.height, kHeight);
  EXPECT_NEAR(image.at(5, 5).x(), 0.007f, 0.004f);
  EXPECT_NEAR(image.at(60, 5).z(), 0.503f, 0.02f);
}

TEST(Panorama, NamesTheColorsOfAJpegThatItCannotUse) {
  const std::unique_ptr<void, decltype(&tjDestroy)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  const std::vector<std::uint8_t> inks(std::size_t{4} * kWidth * kHeight, 100);
  ASSERT_EQ(tjCompress2(encoder.get(), inks.data(), kWidth, 0, kHeight, TJPF_CMYK, &data, &size, TJSAMP_444, 95, 0), 0);
  const std::vector<std::uint8_t> jpeg(data, data + size);
  tjFree(data);
  expect_refused(jpeg, "expected a JPEG in gray or RGB colors, found one in CMYK for printing");
}

TEST(Panorama, ReadsAProgressiveJpegAsAnyOther) {
  const LinearImage image = decode_panorama(encode_jpeg(two_grays(20, 188), TJFLAG_PROGRESSIVE), "test");
  EXPECT_NEAR(image.at(60, 5).z(), 0.503f, 0.02f);
}

TEST(Panorama, RefusesTruncatedPictures) {
  auto png = encode_png(two_grays(30, 200));
  auto jpeg = encode_jpeg(two_grays(30, 200));
  png.resize(png.size() / 2);
  jpeg.resize(jpeg.size() / 2);
  expect_refused(png, "again");
  expect_refused(jpeg, "again");
  png.resize(10);
  jpeg.resize(10);
  expect_refused(png, "again");
  expect_refused(jpeg, "again");
}

/// The picture with its last scan repeated many times.
std::vector<std::uint8_t> with_scans(std::vector<std::uint8_t> jpeg, int more) {
  const std::uint8_t begin[] = {0xff, 0xda};
  const auto last = std::find_end(jpeg.begin(), jpeg.end(), std::begin(begin), std::end(begin));
  const std::vector<std::uint8_t> scan(last, jpeg.end() - 2);  // without the end-of-image marker
  for (int i = 0; i < more; ++i) jpeg.insert(jpeg.end() - 2, scan.begin(), scan.end());
  return jpeg;
}

TEST(Panorama, RefusesAJpegOfAThousandScans) {
  expect_refused(with_scans(encode_jpeg(two_grays(30, 200), TJFLAG_PROGRESSIVE), 1000),
                 "expected at most 50 scans, found more");
  EXPECT_EQ(decode_panorama(encode_jpeg(two_grays(30, 200), TJFLAG_PROGRESSIVE), "test").width, kWidth);
}

TEST(Panorama, RefusesSizesForWhichThereAreTooFewBytes) {
  const std::string seeds = std::string(kSourceFolder) + "/tests/fuzz/seeds/room/";
  EXPECT_NE(message_of([&] { read_panorama(seeds + "declares_huge_size.png"); }).find("again"), std::string::npos);
  EXPECT_NE(message_of([&] { read_panorama(seeds + "bomb.png"); }).find("found the end of the file"),
            std::string::npos);
  for (const std::string size : {"-Y 1073741824 +X 2147483647", "-Y 99999999999 +X 199999999998", "-Y -16 +X -32"}) {
    const std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + std::string(64, '\x02');
    expect_refused({text.begin(), text.end()}, ", found ");
  }
}

TEST(Panorama, OfTheBrightestLightThatThereCanBeBecomesARoom) {
  // Wide enough to be averaged down first.
  const Room room = room_from(LinearImage(4160, 2080, LinearColor::Constant(1.7e38f)), "bright", RoomShape{});
  EXPECT_TRUE(room.light.isFinite().all());
  const Texture::Color wall = room.walls.sample(1.0f, 1.0f, 0);
  EXPECT_NEAR(wall[0], 0.16f, 0.01f);
}

TEST(Panorama, RefusesBytesThatAreNotAPicture) {
  expect_refused({'P', '6', '\n', '1'}, "convert it");
  expect_refused({0}, "convert it");
}

TEST(Panorama, RefusesFilesThatCannotBeRead) {
  const auto folder = std::filesystem::temp_directory_path() / "reorient_panorama_test";
  std::filesystem::create_directories(folder);
  const std::string empty = folder / "empty.hdr";
  std::ofstream(empty).flush();
  EXPECT_NE(message_of([&] { read_panorama(folder / "absent.hdr"); }).find("expected an image file, found none"),
            std::string::npos);
  EXPECT_NE(message_of([&] { read_panorama(folder); }).find("found something that is not a file"), std::string::npos);
  EXPECT_NE(message_of([&] { read_panorama(empty); }).find("found an empty file"), std::string::npos);
  EXPECT_NE(message_of([&] { load_room(empty, RoomShape{}); }).find("empty.hdr"), std::string::npos);
  std::filesystem::remove_all(folder);
}

class RealRooms : public SharedDataTest {
 protected:
  RealRooms() : SharedDataTest("rooms") {}
};

TEST_F(RealRooms, AreReadAsPanoramas) {
  int rooms = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() != ".hdr") continue;
    const LinearImage image = read_panorama(entry.path());
    EXPECT_EQ(image.width, 1024) << entry.path();
    EXPECT_EQ(image.height, 512) << entry.path();
    for (const LinearColor& color : image.pixels) ASSERT_TRUE(color.isFinite().all() && color.minCoeff() >= 0.0f);
    ++rooms;
  }
  EXPECT_GT(rooms, 0) << "no *.hdr in " << folder();
}

}  // namespace
}  // namespace reorient
