// SPDX-License-Identifier: MIT
#include "robots/simulator/room/radiance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/random.h"

namespace reorient {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, const std::string& text) { bytes.insert(bytes.end(), text.begin(), text.end()); }

Bytes header(int width, int height) {
  Bytes bytes;
  append(bytes, "#?RADIANCE\n# a comment\nGAMMA=1\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                    std::to_string(width) + "\n");
  return bytes;
}

std::vector<std::uint8_t> to_rgbe(const LinearColor& color) {
  const float greatest = color.maxCoeff();
  if (greatest < 1e-32f) return {0, 0, 0, 0};
  int exponent = 0;
  const float scale = std::frexp(greatest, &exponent) * 256.0f / greatest;
  return {static_cast<std::uint8_t>(color.x() * scale), static_cast<std::uint8_t>(color.y() * scale),
          static_cast<std::uint8_t>(color.z() * scale), static_cast<std::uint8_t>(exponent + 128)};
}

Bytes encode_flat(const LinearImage& image) {
  Bytes bytes = header(image.width, image.height);
  for (const LinearColor& color : image.pixels) {
    for (const std::uint8_t byte : to_rgbe(color)) bytes.push_back(byte);
  }
  return bytes;
}

/// Run-length coded; a run for each pair of equal neighbors.
Bytes encode_coded(const LinearImage& image) {
  Bytes bytes = header(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (const int byte : {2, 2, image.width >> 8, image.width & 0xff})
      bytes.push_back(static_cast<std::uint8_t>(byte));
    for (std::size_t channel = 0; channel < 4; ++channel) {
      for (int x = 0; x < image.width;) {
        const std::uint8_t value = to_rgbe(image.at(x, y))[channel];
        int run = 1;
        while (x + run < image.width && run < 127 && to_rgbe(image.at(x + run, y))[channel] == value) ++run;
        if (run > 1) {
          bytes.push_back(static_cast<std::uint8_t>(128 + run));
        } else {
          bytes.push_back(1);
        }
        bytes.push_back(value);
        x += run;
      }
    }
  }
  return bytes;
}

LinearImage picture(int width, int height, std::uint64_t seed) {
  Random random(seed);
  LinearImage image(width, height);
  for (LinearColor& color : image.pixels) {
    color =
        LinearColor(static_cast<float>(random.uniform(0.1, 1.0)), static_cast<float>(random.uniform(0.1, 1.0)), 0.5f) *
        static_cast<float>(std::exp2(random.uniform(-8.0, 8.0)));
    if (random.uniform() < 0.3) color = LinearColor::Zero();
  }
  return image;
}

void expect_same(const LinearImage& read, const LinearImage& written) {
  ASSERT_EQ(read.width, written.width);
  ASSERT_EQ(read.height, written.height);
  for (std::size_t i = 0; i < read.pixels.size(); ++i) {
    const float step = written.pixels[i].maxCoeff() / 128.0f;  // the shared exponent's precision
    ASSERT_LE((read.pixels[i] - written.pixels[i]).abs().maxCoeff(), step) << "pixel " << i;
  }
}

std::string refusal_of(const Bytes& bytes) {
  try {
    decode_radiance(bytes, "hall.hdr");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

void expect_unreadable(const Bytes& bytes, const std::string& part) {
  const std::string message = refusal_of(bytes);
  EXPECT_NE(message.find("hall.hdr"), std::string::npos) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Radiance, ReadsAFlatPicture) {
  const LinearImage image = picture(64, 32, 1);
  expect_same(decode_radiance(encode_flat(image), "test"), image);
}

RC_GTEST_PROP(Radiance, ReadsARunLengthCodedPicture, ()) {
  const int height = *rc::gen::inRange(16, 40);
  const LinearImage image = picture(2 * height, height, *rc::gen::arbitrary<std::uint64_t>());
  expect_same(decode_radiance(encode_coded(image), "test"), image);
}

TEST(Radiance, ReadsRowsFromBottomToTopAndFromRightToLeft) {
  const LinearImage image = picture(32, 16, 3);
  Bytes bytes = encode_flat(image);
  const std::string usual = "-Y 16 +X 32";
  const std::string turned = "+Y 16 -X 32";
  const auto place = std::search(bytes.begin(), bytes.end(), usual.begin(), usual.end());
  std::copy(turned.begin(), turned.end(), place);
  const LinearImage read = decode_radiance(bytes, "test");
  EXPECT_EQ(read.at(31, 15).x(), decode_radiance(encode_flat(image), "test").at(0, 0).x());
}

TEST(Radiance, ToleratesCarriageReturnsAndAMissingFormatLine) {
  Bytes bytes;
  append(bytes, "#?RGBE\r\n\r\n-Y 16 +X 32\r\n");
  bytes.insert(bytes.end(), 16 * 32 * 4, 130);
  EXPECT_EQ(decode_radiance(bytes, "test").width, 32);
}

TEST(Radiance, RefusesAnEmptyFile) { expect_unreadable({}, "expected a Radiance image, found other bytes"); }

TEST(Radiance, RefusesAnIncompleteHeader) {
  Bytes bytes;
  append(bytes, "#?RADIANCE");
  bytes.insert(bytes.end(), 100000, 'x');
  expect_unreadable(bytes, "header");
}

TEST(Radiance, RefusesAnotherPixelFormat) {
  Bytes bytes;
  append(bytes, "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 16 +X 32\n");
  expect_unreadable(bytes, "32-bit_rle_rgbe");
}

TEST(Radiance, RefusesInvalidSizesBeforeItAllocatesMemory) {
  expect_unreadable(header(2000000000, 1000000000), "scale it");
  expect_unreadable(header(-64, -32), "scale it");
  expect_unreadable(header(64, 60), "twice as wide as high");
  expect_unreadable(header(8192, 4096), "found the end of the file");
  Bytes bytes;
  append(bytes, "#?RADIANCE\n\n-Y 99999999999999999999 +X 2\n");
  expect_unreadable(bytes, "resolution");
}

TEST(Radiance, RefusesEveryTruncation) {
  const Bytes whole = encode_coded(picture(32, 16, 4));
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    const std::string message = refusal_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
    ASSERT_NE(message, "") << "cut to " << length << " of " << whole.size() << " bytes";
  }
}

TEST(Radiance, RefusesARunBeyondTheRow) {
  Bytes bytes = header(32, 16);
  const std::size_t start = bytes.size();
  bytes.insert(bytes.end(), {2, 2, 0, 32, 128 + 40, 7});
  bytes.resize(start + 16 * 200, 1);
  expect_unreadable(bytes, "damaged");
}

TEST(Radiance, RefusesARowOfAnotherWidth) {
  Bytes bytes = header(32, 16);
  bytes.insert(bytes.end(), {2, 2, 0, 33});
  bytes.resize(bytes.size() + 16 * 200, 1);
  expect_unreadable(bytes, "damaged");
}

RC_GTEST_PROP(Radiance, SurvivesDamage, ()) {
  Bytes bytes = encode_coded(picture(32, 16, 5));
  for (int i = 0; i < 20; ++i) {
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<std::uint8_t>();
  }
  try {
    const LinearImage image = decode_radiance(bytes, "hall.hdr");
    RC_ASSERT(image.pixels.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  } catch (const std::runtime_error& error) {
    RC_ASSERT(std::string(error.what()).find("hall.hdr") != std::string::npos);
  }
}

}  // namespace
}  // namespace reorient
