// SPDX-License-Identifier: MIT
#include "geometry/bytes.h"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/pose2.h"

namespace reorient {
namespace {

enum class Color { red, green, blue };
constexpr int enum_count(Color) { return 3; }

struct Part {
  double length = 0.0;
  Color color = Color::red;
  bool operator==(const Part&) const = default;
};
template <typename Visit, ConstOr<Part> T>
void fields(Visit&& visit, T& part) {
  visit(part.length, part.color);
}

class Counter {
 public:
  void add(int value) { sum_ += value; }
  int sum() const { return sum_; }
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.sum_);
  }

 private:
  int sum_ = 0;
};

struct Everything {
  bool flag = true;
  std::int8_t small = -3;
  std::uint64_t large = std::numeric_limits<std::uint64_t>::max();
  float share = 0.1f;
  std::string text{"two\0words", 9};
  std::vector<Part> parts{{0.1, Color::green}, {std::numeric_limits<double>::infinity(), Color::blue}};
  std::vector<std::uint16_t> numbers{1, 2, 65535};
  std::optional<Part> none;
  std::optional<Part> some = Part{3.0, Color::blue};
  std::map<std::string, int> map{{"b", 2}, {"a", 1}};
  std::variant<int, std::string, Part> variant = std::string("word");
  std::array<std::pair<int, bool>, 2> pairs{{{1, true}, {2, false}}};
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Random();
  Isometry3 pose = to_isometry({1.0, 2.0, 0.5});
  Counter counter;
};
template <typename Visit, ConstOr<Everything> T>
void fields(Visit&& visit, T& e) {
  visit(e.flag, e.small, e.large, e.share, e.text, e.parts, e.numbers, e.none, e.some, e.map, e.variant, e.pairs,
        e.matrix, e.pose, e.counter);
}

std::vector<std::byte> bytes_of(const Everything& value) {
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(value);
  return bytes;
}

TEST(Bytes, AreReadBackAsTheSameValues) {
  Everything before;
  before.counter.add(7);
  const std::vector<std::byte> bytes = bytes_of(before);
  Everything after;
  after.flag = false;
  after.none = Part{};
  after.numbers.clear();
  ByteReader reader(bytes);
  reader(after);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_TRUE(after.flag);
  EXPECT_EQ(after.large, before.large);
  EXPECT_EQ(after.text, before.text);
  EXPECT_EQ(after.parts, before.parts);
  EXPECT_EQ(after.numbers, before.numbers);
  EXPECT_FALSE(after.none);
  EXPECT_EQ(after.some, before.some);
  EXPECT_EQ(after.map, before.map);
  EXPECT_EQ(after.variant, before.variant);
  EXPECT_EQ(after.pairs, before.pairs);
  EXPECT_EQ(after.matrix, before.matrix);
  EXPECT_EQ(after.pose.matrix(), before.pose.matrix());
  EXPECT_EQ(after.counter.sum(), 7);
  EXPECT_EQ(bytes_of(after), bytes);
}

TEST(Bytes, AreRefusedIfTruncatedAtAnyPosition) {
  const std::vector<std::byte> bytes = bytes_of({});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Everything value;
    ByteReader reader(std::span<const std::byte>(bytes).first(size));
    EXPECT_THROW(reader(value), BadBytes) << size;
  }
}

TEST(Bytes, AreRefusedIfBytesRemain) {
  std::vector<std::byte> bytes = bytes_of({});
  bytes.push_back({});
  Everything value;
  ByteReader reader(bytes);
  reader(value);
  EXPECT_THROW(reader.finish(), BadBytes);
}

TEST(Bytes, AreRefusedWithAnUnknownEnumValueOrAnImpossibleLength) {
  const std::array<std::byte, 1> three{std::byte{3}};
  Color color{};
  EXPECT_THROW(ByteReader{three}(color), BadBytes);
  const std::vector<std::byte> huge(4, std::byte{0xFF});
  std::vector<std::string> strings;
  EXPECT_THROW(ByteReader{huge}(strings), BadBytes);
  std::vector<double> doubles;
  EXPECT_THROW(ByteReader{huge}(doubles), BadBytes);
}

RC_GTEST_PROP(Bytes, ThatAreRandomNeverCrashTheReader, (const std::vector<std::uint8_t>& noise)) {
  Everything value;
  ByteReader reader(std::as_bytes(std::span(noise)));
  try {
    reader(value);
  } catch (const BadBytes&) {
  }
}

}  // namespace
}  // namespace reorient
