// SPDX-License-Identifier: MIT
// What is read from the markers and chunks of image files, and the orientation of EXIF.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "robots/image_files/exif_orientation.h"
#include "robots/image_files/jpeg_headers.h"
#include "robots/image_files/png_chunks.h"
#include "tests/robots/exif_block.h"

namespace reorient {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

const Bytes kStart{0xff, 0xd8}, kEnd{0xff, 0xd9};
const Bytes kScan{0xff, 0xda, 0, 3, 0, 0x12, 0xff, 0, 0xff, 0xd0, 0x34};  // with a stuffed byte and a restart

Bytes frame(std::uint8_t code, std::uint8_t bits, std::uint8_t colors) {
  return {0xff, code, 0, 8, bits, 1, 2, 3, 4, colors};
}

TEST(JpegHeaders, AreReadUpToTheEndOfTheImage) {
  const JpegHeaders jpeg = read_jpeg_headers(joined({kStart, frame(0xc2, 8, 3), kScan, kScan, kEnd, kScan, kScan}));
  EXPECT_EQ(jpeg.process, 2);
  EXPECT_EQ(jpeg.bits, 8);
  EXPECT_EQ(jpeg.width, 0x0304);
  EXPECT_EQ(jpeg.height, 0x0102);
  EXPECT_EQ(jpeg.colors, 3);
  EXPECT_EQ(jpeg.scans, 2) << "scans behind the end belong to no image";
  EXPECT_TRUE(jpeg.has_end);
  EXPECT_EQ(jpeg.orientation, 1);
  EXPECT_EQ(undecodable(jpeg), "");
}

TEST(JpegHeaders, DoNotTakeTheThumbnailInASegmentForTheImage) {
  const Bytes thumbnail = joined({kStart, frame(0xc0, 8, 1), kScan, kEnd});
  const auto length = static_cast<std::uint8_t>(thumbnail.size() + 2);
  const JpegHeaders jpeg = read_jpeg_headers(joined({kStart, {0xff, 0xe1, 0, length}, thumbnail, frame(0xc0, 8, 3)}));
  EXPECT_EQ(jpeg.colors, 3);
  EXPECT_EQ(jpeg.scans, 0);
  EXPECT_FALSE(jpeg.has_end);
}

TEST(JpegHeaders, NameWhatNoDecoderReads) {
  const auto reason = [](const Bytes& header) {
    return undecodable(read_jpeg_headers(joined({kStart, header, kEnd})));
  };
  EXPECT_EQ(reason(frame(0xc1, 12, 3)), "expected a JPEG with 8 bits per color, found 12; export it with 8 bits");
  EXPECT_EQ(reason(frame(0xc0, 8, 2)), "expected a JPEG with 1, 3 or 4 colors, found 2; export it in sRGB");
  EXPECT_EQ(reason(frame(0xc3, 8, 3)),
            "expected a baseline or progressive JPEG, found a lossless or hierarchical one (process 3); export it as "
            "an ordinary JPEG");
  for (const std::uint8_t code : {0xc0, 0xc1, 0xc2, 0xc9, 0xca}) EXPECT_EQ(reason(frame(code, 8, 4)), "") << code;
}

TEST(JpegHeaders, OfEachTruncatedFileLackTheEnd) {
  const Bytes whole = joined({kStart, exif_segment(6), frame(0xc0, 8, 3), kScan, kEnd});
  ASSERT_TRUE(read_jpeg_headers(whole).has_end);
  for (std::size_t size = 3; size < whole.size(); ++size)
    EXPECT_FALSE(read_jpeg_headers({whole.data(), size}).has_end) << size;
}

TEST(JpegHeaders, ReadTheOrientationOfTheFirstExifBlock) {
  EXPECT_EQ(read_jpeg_headers(joined({kStart, exif_segment(6), exif_segment(3), kEnd})).orientation, 6);
  const Bytes other{0xff, 0xe1, 0, 10, 'h', 't', 't', 'p', ':', '/', '/', 0};  // as XMP, which uses the same marker
  EXPECT_EQ(read_jpeg_headers(joined({kStart, other, exif_segment(8), kEnd})).orientation, 8);
  EXPECT_EQ(read_jpeg_headers(joined({kStart, exif_segment(9), kEnd})).orientation, 1);
}

TEST(ExifOrientation, IsReadInBothByteOrders) {
  const Bytes little = exif_block(6);
  EXPECT_EQ(orientation_in_exif(little), 6);
  const Bytes big{'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, 8, 0, 0};
  EXPECT_EQ(orientation_in_exif(big), 8);
  Bytes mixed = little;
  mixed[1] = 'M';
  EXPECT_EQ(orientation_in_exif(mixed), 1);
}

TEST(ExifOrientation, OfTruncatedOrForgedBlocksIsThatOfTheStoredImage) {
  const Bytes whole = exif_block(6);
  for (std::size_t size = 0; size + 3 < whole.size(); ++size) EXPECT_EQ(orientation_in_exif({whole.data(), size}), 1);
  Bytes far = whole;
  far[4] = far[5] = far[6] = far[7] = 0xff;  // offset of the directory
  EXPECT_EQ(orientation_in_exif(far), 1);
  for (const int value : {0, 9, 65535}) EXPECT_EQ(orientation_in_exif(exif_block(value)), 1) << value;
  Bytes text = whole;
  text[12] = 2;  // type
  EXPECT_EQ(orientation_in_exif(text), 1);
}

TEST(PngChunks, ReadTheOrientationAndTheEnd) {
  const Bytes signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, end{0, 0, 0, 0, 'I', 'E', 'N', 'D', 1, 2, 3, 4};
  const Bytes block = exif_block(3);
  const Bytes exif =
      joined({{0, 0, 0, static_cast<std::uint8_t>(block.size()), 'e', 'X', 'I', 'f'}, block, {1, 2, 3, 4}});
  const Bytes whole = joined({signature, exif, end});
  ASSERT_TRUE(looks_like_png(whole));
  EXPECT_EQ(read_png_chunks(whole).orientation, 3);
  EXPECT_TRUE(read_png_chunks(whole).has_end);
  EXPECT_TRUE(read_png_chunks(joined({whole, {'x', 'y'}})).has_end);
  for (std::size_t size = signature.size(); size < whole.size(); ++size)
    EXPECT_FALSE(read_png_chunks({whole.data(), size}).has_end) << size;
  EXPECT_FALSE(read_png_chunks(joined({signature, {0xff, 0xff, 0xff, 0xff}, end})).has_end);
}

/// An image of 3 x 2 pixels, whose pixel is its index, as it is shown.
std::vector<std::size_t> shown(int orientation) {
  const ShownImage image(3, 2, orientation);
  std::vector<std::size_t> pixels;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) pixels.push_back(image.stored(x, y));
  }
  return pixels;
}

TEST(ExifOrientation, MapsThePixelsAsTheStandardSays) {
  using Pixels = std::vector<std::size_t>;
  EXPECT_EQ(shown(1), (Pixels{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(shown(2), (Pixels{2, 1, 0, 5, 4, 3})) << "mirrored";
  EXPECT_EQ(shown(3), (Pixels{5, 4, 3, 2, 1, 0})) << "rotated by 180 degrees";
  EXPECT_EQ(shown(4), (Pixels{3, 4, 5, 0, 1, 2})) << "upside down and mirrored";
  EXPECT_EQ(shown(5), (Pixels{0, 3, 1, 4, 2, 5})) << "transposed";
  EXPECT_EQ(shown(6), (Pixels{3, 0, 4, 1, 5, 2})) << "rotated clockwise";
  EXPECT_EQ(shown(7), (Pixels{5, 2, 4, 1, 3, 0})) << "transposed about the other diagonal";
  EXPECT_EQ(shown(8), (Pixels{2, 5, 1, 4, 0, 3})) << "rotated counterclockwise";
  EXPECT_EQ(ShownImage(3, 2, 6).width(), 2);
  EXPECT_EQ(ShownImage(3, 2, 6).height(), 3);
}

}  // namespace
}  // namespace reorient
