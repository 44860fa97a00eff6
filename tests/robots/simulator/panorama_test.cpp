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
#include "tests/robots/exif_block.h"
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

std::vector<std::uint8_t> encode_jpeg(const std::vector<std::uint8_t>& pixels, int flags = 0, int sampling = TJSAMP_444,
                                      TJPF format = TJPF_RGB) {
  const std::unique_ptr<void, decltype(&tjDestroy)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder.get(), pixels.data(), kWidth, 0, kHeight, format, &data, &size, sampling, 95, flags);
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

/// A PNG without a gamma. `row`: the samples of each row, as they are stored.
std::vector<std::uint8_t> encode_png_rows(int bits, int color_type, const std::vector<std::uint8_t>& row) {
  std::vector<std::uint8_t> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp to, png_bytep data, png_size_t size) {
        auto* const all = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(to));
        all->insert(all->end(), data, data + size);
      },
      nullptr);
  png_set_IHDR(png, info, kWidth, kHeight, bits, color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[] = {{0, 0, 0}, {188, 188, 188}};
  if (color_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_write_info(png, info);
  for (int y = 0; y < kHeight; ++y) png_write_row(png, row.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// Samples of a row of which the left half is black and the right half has the gray 188 of 255.
std::vector<std::uint8_t> black_and_gray(const std::vector<std::uint8_t>& black,
                                         const std::vector<std::uint8_t>& gray) {
  std::vector<std::uint8_t> row;
  for (int x = 0; x < kWidth; ++x) {
    const auto& pixel = x < kWidth / 2 ? black : gray;
    row.insert(row.end(), pixel.begin(), pixel.end());
  }
  return row;
}

TEST(Panorama, ReadsAPngOfEachDepthAndColorTypeWithTheGammaOfSrgb) {
  const std::vector<std::vector<std::uint8_t>> pictures{
      encode_png_rows(8, PNG_COLOR_TYPE_GRAY, black_and_gray({0}, {188})),
      encode_png_rows(16, PNG_COLOR_TYPE_GRAY, black_and_gray({0, 0}, {188, 188})),
      encode_png_rows(8, PNG_COLOR_TYPE_GRAY_ALPHA, black_and_gray({0, 255}, {188, 255})),
      encode_png_rows(16, PNG_COLOR_TYPE_RGB, black_and_gray({0, 0, 0, 0, 0, 0}, {188, 188, 188, 188, 188, 188})),
      encode_png_rows(8, PNG_COLOR_TYPE_RGB_ALPHA, black_and_gray({0, 0, 0, 255}, {188, 188, 188, 255})),
      encode_png_rows(8, PNG_COLOR_TYPE_PALETTE, black_and_gray({0}, {1}))};
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const LinearImage image = decode_panorama(pictures[i], "test");
    EXPECT_NEAR(image.at(5, 5).x(), 0.0f, 1e-3f) << i;
    EXPECT_NEAR(image.at(60, 5).y(), 0.503f, 0.01f) << i;
  }
}

TEST(Panorama, BlendsTransparentPixelsOfAPngWithBlack) {
  const auto png = encode_png_rows(8, PNG_COLOR_TYPE_GRAY_ALPHA, black_and_gray({188, 0}, {188, 128}));
  const LinearImage image = decode_panorama(png, "test");
  EXPECT_NEAR(image.at(5, 5).x(), 0.0f, 1e-3f);
  EXPECT_NEAR(image.at(60, 5).y(), 0.252f, 0.01f) << "half of the light";
}

TEST(Panorama, ConvertsTheGammaOfAJpegToLinearLight) {
  const LinearImage image = decode_panorama(encode_jpeg(two_grays(20, 188)), "test");
  ASSERT_EQ(image.height, kHeight);
  EXPECT_NEAR(image.at(5, 5).x(), 0.007f, 0.004f);
  EXPECT_NEAR(image.at(60, 5).z(), 0.503f, 0.02f);
}

TEST(Panorama, MultipliesTheInksOfACmykJpegByBlack) {
  std::vector<std::uint8_t> inks;  // inverted: 255 is no ink
  for (int i = 0; i < kWidth * kHeight; ++i) inks.insert(inks.end(), {200, 100, 50, 188});
  const LinearImage image = decode_panorama(encode_jpeg(inks, 0, TJSAMP_444, TJPF_CMYK), "test");
  const LinearColor& color = image.at(20, 10);
  EXPECT_NEAR(color.x(), 0.294f, 0.01f) << "147 of 255 in sRGB";
  EXPECT_NEAR(color.y(), 0.070f, 0.006f) << "74";
  EXPECT_NEAR(color.z(), 0.0185f, 0.004f) << "37";
}

TEST(Panorama, ReadsAJpegWithEachSubsampling) {
  for (const int sampling : {TJSAMP_444, TJSAMP_422, TJSAMP_420, TJSAMP_GRAY, TJSAMP_440, TJSAMP_411})
    EXPECT_NEAR(decode_panorama(encode_jpeg(two_grays(20, 188), 0, sampling), "test").at(60, 5).z(), 0.503f, 0.02f)
        << sampling;
}

TEST(Panorama, ReadsAJpegWithASubsamplingThatHasNoName) {
  // 64 x 32 pixels; the left half has the gray 20, the right half 188, with a third of the chroma in each row.
  const std::string digits =
      "ffd8ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e2931302e292d2c333a4a3e333646372c"
      "2d405741464c4e525352323e5a615a50604a51524fffdb0043010e0e0e131113261515264f352d354f4f4f4f4f4f4f4f4f4f"
      "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4fffc00011080020004003"
      "013100021101031101ffc4001500010100000000000000000000000000000007ffc400141001000000000000000000000000"
      "00000000ffc40014010100000000000000000000000000000000ffc40014110100000000000000000000000000000000ffda"
      "000c03010002110311003f009e800b38000230002ce00008c000b38000230002ce0000ffd9";
  std::vector<std::uint8_t> jpeg;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    jpeg.push_back(static_cast<std::uint8_t>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  const LinearImage image = decode_panorama(jpeg, "test");
  EXPECT_NEAR(image.at(5, 5).x(), 0.007f, 0.004f);
  EXPECT_NEAR(image.at(60, 5).z(), 0.503f, 0.02f);
}

TEST(Panorama, NamesWhyItCannotDecodeAJpeg) {
  const auto with_frame = [](std::size_t offset, std::uint8_t value) {
    auto jpeg = encode_jpeg(two_grays(20, 188));
    const std::uint8_t begin[] = {0xff, 0xc0};
    std::search(jpeg.begin(), jpeg.end(), std::begin(begin), std::end(begin))[static_cast<std::ptrdiff_t>(offset)] =
        value;
    return jpeg;
  };
  expect_refused(with_frame(4, 12), "expected a JPEG with 8 bits per color, found 12");
  expect_refused(with_frame(1, 0xc3), "expected a baseline or progressive JPEG, found a lossless or hierarchical one");
}

/// Inserts `more` at an offset.
std::vector<std::uint8_t> with_bytes(std::vector<std::uint8_t> bytes, std::size_t at, std::vector<std::uint8_t> more) {
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), more.begin(), more.end());
  return bytes;
}

TEST(Panorama, IsReadAsTheOrientationOfAJpegSays) {
  const auto jpeg = encode_jpeg(two_grays(20, 188));
  EXPECT_NEAR(decode_panorama(with_bytes(jpeg, 2, exif_segment(1)), "test").at(60, 5).x(), 0.503f, 0.02f);
  EXPECT_NEAR(decode_panorama(with_bytes(jpeg, 2, exif_segment(3)), "test").at(60, 5).x(), 0.007f, 0.004f);
  EXPECT_NEAR(decode_panorama(with_bytes(jpeg, 2, exif_segment(3)), "test").at(3, 5).x(), 0.503f, 0.02f);
  expect_refused(with_bytes(jpeg, 2, exif_segment(6)), "twice as wide as high, found 32 x 64 pixels");
}

TEST(Panorama, IsReadAsTheOrientationOfAPngSays) {
  const auto block = exif_block(2);
  std::vector<std::uint8_t> chunk{0, 0, 0, static_cast<std::uint8_t>(block.size()), 'e', 'X', 'I', 'f'};
  chunk.insert(chunk.end(), block.begin(), block.end());
  chunk.insert(chunk.end(), {0x38, 0x28, 0x74, 0xd3});  // the checksum
  constexpr std::size_t kAfterHeader = 33;
  const LinearImage image = decode_panorama(with_bytes(encode_png(two_grays(0, 188)), kAfterHeader, chunk), "test");
  EXPECT_NEAR(image.at(5, 5).x(), 0.503f, 0.01f);
  EXPECT_NEAR(image.at(60, 5).x(), 0.0f, 1e-3f);
}

TEST(Panorama, MayHaveBytesAfterItsEndOrBetweenItsSegments) {
  const auto jpeg = encode_jpeg(two_grays(20, 188));
  std::vector<std::uint8_t> video;  // as phones append one
  for (int i = 0; i < 100; ++i) video.insert(video.end(), {0xff, 0xda, 0, 2, 7});
  EXPECT_NEAR(decode_panorama(with_bytes(jpeg, jpeg.size(), video), "test").at(60, 5).x(), 0.503f, 0.02f);
  constexpr std::size_t kAfterFirstSegment = 20;
  const auto padded = with_bytes(jpeg, kAfterFirstSegment, {0, 0, 0, 0});
  EXPECT_NEAR(decode_panorama(padded, "test").at(60, 5).x(), 0.503f, 0.02f);
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
                 "expected a JPEG with at most 50 scans, found 10");
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
