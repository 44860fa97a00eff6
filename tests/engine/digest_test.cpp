// SPDX-License-Identifier: MIT
#include "engine/record/digest.h"

#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

Digest digest_of(const std::vector<unsigned char>& bytes) {
  Digest digest;
  digest.add(std::as_bytes(std::span(bytes)));
  return digest;
}

RC_GTEST_PROP(Digest, ChangesWithAnySingleByte, (std::vector<unsigned char> bytes)) {
  RC_PRE(!bytes.empty());
  const auto before = digest_of(bytes).value();
  RC_ASSERT(before == digest_of(bytes).value());
  bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] ^= 1;
  RC_ASSERT(before != digest_of(bytes).value());
}

TEST(Digest, DependsOnTheNumberOfTrailingZeros) {
  EXPECT_NE(digest_of({1}).value(), digest_of({1, 0}).value());
  EXPECT_NE(digest_of({}).value(), digest_of({0}).value());
}

TEST(Digest, DependsOnTheOrder) {
  Digest forwards, backwards;
  forwards.add(1.0);
  forwards.add(2.0);
  backwards.add(2.0);
  backwards.add(1.0);
  EXPECT_NE(forwards.value(), backwards.value());
}

TEST(Digest, IsWrittenWithSixteenHexadecimalDigits) { EXPECT_EQ(Digest().hex(), "cbf29ce484222325"); }

}  // namespace
}  // namespace reorient
