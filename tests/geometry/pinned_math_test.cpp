// SPDX-License-Identifier: MIT
// Pinned functions: their accuracy, and the equality of single and vectorized calls.
#include "geometry/pinned_math.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/random.h"

namespace reorient {
namespace {

/// Distance in units of the last place of `value`.
double units_off(double value, long double truth) {
  const double unit = std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) - std::abs(value);
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth) / unit);
}

TEST(PinnedMath, IsWithinOneUnitInTheLastPlace) {
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const double x = random.uniform(-7.0, 7.0);
    const double y = random.uniform(-7.0, 7.0);
    const double positive = std::abs(x) + 1e-9;
    const double unit = x / 7.0;
    EXPECT_LE(units_off(pinned::sin(x), std::sin(static_cast<long double>(x))), 1.01) << x;
    EXPECT_LE(units_off(pinned::cos(x), std::cos(static_cast<long double>(x))), 1.01) << x;
    EXPECT_LE(units_off(pinned::tan(x), std::tan(static_cast<long double>(x))), 1.01) << x;
    EXPECT_LE(units_off(pinned::asin(unit), std::asin(static_cast<long double>(unit))), 1.01) << x;
    EXPECT_LE(units_off(pinned::acos(unit), std::acos(static_cast<long double>(unit))), 1.01) << x;
    EXPECT_LE(units_off(pinned::atan(x), std::atan(static_cast<long double>(x))), 1.01) << x;
    EXPECT_LE(units_off(pinned::atan2(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))),
              1.01)
        << y << " " << x;
    EXPECT_LE(units_off(pinned::exp(x), std::exp(static_cast<long double>(x))), 1.01) << x;
    EXPECT_LE(units_off(pinned::exp2(x), std::exp2(static_cast<long double>(x))), 1.01) << x;
    EXPECT_LE(units_off(pinned::expm1(x), std::expm1(static_cast<long double>(x))), 1.01) << x;
    EXPECT_LE(units_off(pinned::log(positive), std::log(static_cast<long double>(positive))), 1.01) << x;
    EXPECT_LE(units_off(pinned::log2(positive), std::log2(static_cast<long double>(positive))), 1.01) << x;
    EXPECT_LE(units_off(pinned::log10(positive), std::log10(static_cast<long double>(positive))), 1.01) << x;
    EXPECT_LE(
        units_off(pinned::pow(positive, y), std::pow(static_cast<long double>(positive), static_cast<long double>(y))),
        1.01)
        << positive << " " << y;
    EXPECT_LE(units_off(pinned::hypot(x, y), std::hypot(static_cast<long double>(x), static_cast<long double>(y))),
              2.0);
  }
}

TEST(PinnedMath, HandlesTheLimitsOfTheNumberRange) {
  const double infinite = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pinned::exp(-infinite), 0.0);
  EXPECT_EQ(pinned::exp(-1e4), 0.0);
  EXPECT_EQ(pinned::exp(0.0), 1.0);
  EXPECT_EQ(pinned::exp(infinite), infinite);
  EXPECT_EQ(pinned::log(0.0), -infinite);
  EXPECT_TRUE(std::isnan(pinned::log(-1.0)));
  EXPECT_EQ(pinned::pow(0.0, 0.0), 1.0);
  EXPECT_EQ(pinned::pow(2.0, -infinite), 0.0);
  EXPECT_EQ(pinned::atan2(0.0, -1.0), std::atan2(0.0, -1.0));
  EXPECT_EQ(pinned::atan2(-0.0, -1.0), std::atan2(-0.0, -1.0));
  EXPECT_EQ(pinned::atan2(0.0, 0.0), 0.0);
  for (const double bad : {nan, infinite, -infinite}) {
    EXPECT_TRUE(std::isnan(pinned::sin(bad)));
    EXPECT_TRUE(std::isnan(pinned::cos(bad)));
    EXPECT_TRUE(std::isnan(pinned::tan(bad)));
  }
  EXPECT_TRUE(std::isnan(pinned::exp(nan)));
  EXPECT_TRUE(std::isnan(pinned::atan2(nan, 1.0)));
}

TEST(PinnedMath, GivesTheSameBitsForVectorsAsForSingleNumbers) {
  Random random(2);
  for (const std::size_t size : {0, 1, 2, 3, 4, 5, 6, 7, 8, 33, 300}) {
    std::vector<double> values(size), sines(size), cosines(size);
    std::vector<float> floats(size), across(size), angles(size);
    for (std::size_t i = 0; i < size; ++i) {
      values[i] = random.uniform(-20.0, 20.0);
      floats[i] = static_cast<float>(random.uniform(-20.0, 20.0));
      across[i] = static_cast<float>(random.uniform(-20.0, 20.0));
    }
    pinned::sincos(values, sines, cosines);
    pinned::atan2(floats, across, angles);
    const std::vector<double> up(floats.begin(), floats.end()), along(across.begin(), across.end());
    std::vector<double> directions(up.size());
    pinned::atan2(up, along, directions);
    for (std::size_t i = 0; i < up.size(); ++i) EXPECT_EQ(directions[i], pinned::atan2(up[i], along[i]));
    std::vector<double> exponentials = values;
    std::vector<float> float_exponentials = floats;
    pinned::exp(exponentials);
    pinned::exp(float_exponentials);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(sines[i], pinned::sin(values[i]));
      EXPECT_EQ(cosines[i], pinned::cos(values[i]));
      EXPECT_EQ(sines[i], pinned::sincos(values[i]).sin);
      EXPECT_EQ(cosines[i], pinned::sincos(values[i]).cos);
      EXPECT_EQ(exponentials[i], pinned::exp(values[i]));
      EXPECT_NEAR(float_exponentials[i] / std::exp(floats[i]), 1.0, 2e-7);
      EXPECT_NEAR(angles[i], std::atan2(floats[i], across[i]), 5e-7);
      std::vector<float> alone{floats[i]}, alone_across{across[i]}, alone_angle(1);
      pinned::atan2(alone, alone_across, alone_angle);
      pinned::exp(alone);
      EXPECT_EQ(alone_angle[0], angles[i]);
      EXPECT_EQ(alone[0], float_exponentials[i]);
    }
  }
}

/// If this number differs on a machine, every digest differs, too.
TEST(PinnedMath, GivesTheSameBitsOnEveryMachine) {
  Random random(3);
  std::uint64_t hash = 0;
  const auto add = [&hash](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 29;
  };
  for (int i = 0; i < 10'000; ++i) {
    const double x = random.uniform(-30.0, 30.0);
    const double y = random.uniform(0.0, 9.0);
    for (const double value :
         {pinned::sin(x), pinned::cos(x), pinned::tan(x), pinned::asin(x / 30.0), pinned::acos(x / 30.0),
          pinned::atan(x), pinned::atan2(x, y - 4.0), pinned::exp(x), pinned::exp2(x), pinned::expm1(x), pinned::log(y),
          pinned::log2(y), pinned::log10(y), pinned::pow(y, x), pinned::hypot(x, y), random.normal()}) {
      add(value);
    }
  }
  EXPECT_EQ(hash, 14457869275248252442u);
}

}  // namespace
}  // namespace reorient
