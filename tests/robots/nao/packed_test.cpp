// SPDX-License-Identifier: MIT
#include "robots/nao/lola/packed.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient::nao {
namespace {

std::vector<std::byte> bytes(std::initializer_list<int> values) {
  std::vector<std::byte> all;
  for (const int value : values) all.push_back(static_cast<std::byte>(value));
  return all;
}

using State = PackedExtent::State;

TEST(Packed, ReadsNumbersOfEachType) {
  const std::vector<std::pair<std::vector<std::byte>, float>> kinds{
      {bytes({0x07}), 7.0f},
      {bytes({0xff}), -1.0f},
      {bytes({0xcc, 0xff}), 255.0f},
      {bytes({0xcd, 0x01, 0x00}), 256.0f},
      {bytes({0xce, 0x00, 0x01, 0x00, 0x00}), 65536.0f},
      {bytes({0xd0, 0x80}), -128.0f},
      {bytes({0xd1, 0x80, 0xd8}), -32552.0f},
      {bytes({0xd3, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xfe}), -2.0f},
      {bytes({0xca, 0x3f, 0x80, 0x00, 0x00}), 1.0f},
      {bytes({0xcb, 0xbf, 0xe0, 0, 0, 0, 0, 0, 0}), -0.5f},
      {bytes({0xc3}), 1.0f},
  };
  for (const auto& [packed, value] : kinds) {
    PackedReader reader(packed);
    EXPECT_EQ(reader.number(), value);
    EXPECT_TRUE(reader.rest().empty());
  }
}

TEST(Packed, ReadsADoubleBeyondTheRangeOfAFloatAsInfinite) {
  const auto packed = bytes({0xcb, 0x7f, 0xe0, 0, 0, 0, 0, 0, 0});
  PackedReader reader(packed);
  const std::optional<float> number = reader.number();
  ASSERT_TRUE(number);
  EXPECT_TRUE(std::isinf(*number));
}

TEST(Packed, FindsTheEndOfAValue) {
  const auto packed = bytes({0x82, 0xa1, 'a', 0x91, 0xc0, 0xa1, 'b', 0xc4, 0x02, 0, 0, /* the next one */ 0x05});
  EXPECT_EQ(first_packed_value(packed).size, packed.size() - 1);
  for (std::size_t size = 0; size < packed.size() - 1; ++size)
    EXPECT_EQ(first_packed_value(std::span(packed).first(size)).state, State::cut_short);
}

TEST(Packed, RejectsTooDeepNesting) {
  EXPECT_EQ(first_packed_value(bytes({0xdf, 0xff, 0xff, 0xff, 0xff})).state, State::invalid);
  EXPECT_EQ(first_packed_value(bytes({0xc1})).state, State::invalid);
  EXPECT_EQ(first_packed_value(bytes({0xd4, 0, 0})).state, State::invalid);
  const std::vector<std::byte> deep(100'000, std::byte{0x91});  // arrays in arrays
  EXPECT_EQ(first_packed_value(deep).state, State::cut_short);
}

TEST(Packed, ReaderReturnsNothingMoreAfterAnError) {
  const auto packed = bytes({0xa1, 'a', 0x05});
  PackedReader reader(packed);
  EXPECT_FALSE(reader.number());
  EXPECT_FALSE(reader.text());
  EXPECT_FALSE(reader.skip());
}

TEST(Packed, WriterReturnsTheNecessarySizeIfTheBufferIsTooSmall) {
  std::array<std::byte, 4> buffer{};
  PackedWriter writer(buffer);
  writer.text("Position");
  EXPECT_EQ(writer.size(), 9u);
}

RC_GTEST_PROP(Packed, ReadsArbitraryBytesWithoutAccessBeyondThem, (const std::vector<std::uint8_t>& noise)) {
  std::vector<std::byte> packed;
  packed.reserve(noise.size());
  for (const std::uint8_t value : noise) packed.push_back(static_cast<std::byte>(value));
  const PackedExtent extent = first_packed_value(packed);
  RC_ASSERT(extent.size <= packed.size());
  PackedReader reader(packed);
  RC_ASSERT(reader.skip() == (extent.state == State::whole));
}

}  // namespace
}  // namespace reorient::nao
