// SPDX-License-Identifier: MIT
#include "perception/room/color/color_counting.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/random.h"

namespace reorient {
namespace {

constexpr Instructions kVersions[] = {Instructions::portable, Instructions::sse4, Instructions::avx2,
                                      Instructions::neon};

std::vector<Instructions> offered_here() {
  std::vector<Instructions> result;
  std::copy_if(std::begin(kVersions), std::end(kVersions), std::back_inserter(result), offered);
  return result;
}

/// Random bytes in rows of any stride. No spare byte at the end, so reading too far is an error under asan.
struct Noise {
  Noise(int width, int height, int gap, std::uint64_t seed) : stride(2 * width + gap) {
    Random random(seed);
    bytes.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(height) - static_cast<std::size_t>(gap));
    // Half of the values are near the thresholds, where errors are most likely.
    for (std::uint8_t& value : bytes) {
      value = static_cast<std::uint8_t>(random.uniform() < 0.5 ? random.below(256) : 118 + random.below(20));
    }
    view = {bytes.data(), width, height, stride};
  }
  int stride;
  std::vector<std::uint8_t> bytes;
  ImageView view;
};

/// Thresholds of some light, or any nine bytes, which include empty ranges and slices in the wrong order.
ColorThresholds any_thresholds() {
  const auto byte = [] { return *rc::gen::arbitrary<std::uint8_t>(); };
  if (*rc::gen::arbitrary<bool>()) {
    const double gray_within = *rc::gen::inRange(0, 20);
    return color_thresholds(
        {.gray_within = gray_within},
        {*rc::gen::inRange(20, 250) * 1.0, *rc::gen::inRange(100, 156) / 1.1, *rc::gen::inRange(100, 156) / 1.1});
  }
  return {byte(), byte(), byte(), byte(), byte(), byte(), byte(), byte(), byte()};
}

/// The reference: counts by the definition only.
ColorCounts counts_by_definition(const ImageView& image, const PixelBlock& block, int row_step,
                                 const ColorThresholds& thresholds) {
  ColorCounts counts{};
  for (int y = std::max(block.top, 0); y < std::min(block.bottom, image.height); y += row_step) {
    for (int x = std::max(block.left, 0); x < std::min(block.right, image.width & ~1); ++x)
      ++counts[static_cast<std::size_t>(color_bin(image.at(x, y), thresholds))];
  }
  return counts;
}

TEST(ColorCounting, ThePortableVersionIsSupportedEverywhere) {
  EXPECT_TRUE(offered(Instructions::portable));
  EXPECT_TRUE(offered(widest_instructions()));
}

TEST(ColorCounting, TheWidestSupportedVersionIsSelected) {
  EXPECT_EQ(widest_instructions(), offered_here().back());
#ifdef __x86_64__
  EXPECT_TRUE(offered(Instructions::sse4)) << "the whole program requires it";
  EXPECT_EQ(offered(Instructions::avx2), __builtin_cpu_supports("avx2") != 0);
#endif
#ifdef __aarch64__
  EXPECT_TRUE(offered(Instructions::neon)) << "each 64-bit ARM processor has it";
#endif
}

RC_GTEST_PROP(ColorCounting, EveryVersionCountsByTheDefinition, ()) {
  const int width = *rc::gen::inRange(1, 180);
  const int height = *rc::gen::inRange(1, 40);
  const Noise image(width, height, *rc::gen::inRange(0, 9) + width % 2 * 2, *rc::gen::arbitrary<std::uint64_t>());
  const ColorThresholds thresholds = any_thresholds();
  const PixelBlock block{*rc::gen::inRange(-5, width + 5), *rc::gen::inRange(-5, height + 5),
                         *rc::gen::inRange(-5, width + 25), *rc::gen::inRange(-5, height + 5)};
  const int row_step = *rc::gen::inRange(1, 6);
  const ColorCounts expected = counts_by_definition(image.view, block, row_step, thresholds);
  for (const Instructions instructions : offered_here()) {
    ColorCounts counts{};
    count_colors(image.view, block, row_step, thresholds, counts, instructions);
    RC_ASSERT(counts == expected);
  }
}

/// A block may be counted in any number of parts, and existing counts remain.
RC_GTEST_PROP(ColorCounting, AddsToTheCounts, (std::uint64_t seed)) {
  const Noise image(128, 16, 0, seed);
  const int border = *rc::gen::inRange(0, 129);
  for (const Instructions instructions : offered_here()) {
    ColorCounts whole{};
    ColorCounts halves{};
    count_colors(image.view, {0, 0, 128, 16}, 1, {}, whole, instructions);
    count_colors(image.view, {0, 0, border, 16}, 1, {}, halves, instructions);
    count_colors(image.view, {border, 0, 128, 16}, 1, {}, halves, instructions);
    RC_ASSERT(whole == halves);
  }
}

TEST(ColorCounting, EveryColorHasTheSameBinInEveryVersion) {
  for (const ColorThresholds& thresholds : {ColorThresholds{}, color_thresholds({}, {57.5, 120.0, 140.5})}) {
    Image image(512, 256);  // for each luma, all Cb and Cr
    for (int luma = 0; luma < 256; luma += 5) {
      for (int cr = 0; cr < 256; ++cr) {
        for (int cb = 0; cb < 256; ++cb) {
          std::uint8_t* pair = image.row(cr) + 4 * cb;
          pair[0] = static_cast<std::uint8_t>(luma);
          pair[1] = static_cast<std::uint8_t>(cb);
          pair[2] = static_cast<std::uint8_t>(255 - luma);
          pair[3] = static_cast<std::uint8_t>(cr);
        }
      }
      const PixelBlock all{0, 0, 512, 256};
      const ColorCounts expected = counts_by_definition(image.view(), all, 1, thresholds);
      for (const Instructions instructions : offered_here()) {
        ColorCounts counts{};
        count_colors(image.view(), all, 1, thresholds, counts, instructions);
        EXPECT_EQ(counts, expected) << "luma " << luma;
      }
    }
  }
}

TEST(ColorCounting, CountsLargeImagesOfOneColorWithoutOverflow) {
  Image image(1280, 960);
  for (int y = 0; y < image.height(); ++y) std::fill_n(image.row(y), 2 * image.width(), std::uint8_t{200});
  for (const Instructions instructions : offered_here()) {
    ColorCounts counts{};
    count_colors(image.view(), {0, 0, 1280, 960}, 1, {}, counts, instructions);
    EXPECT_EQ(counts[13], 1280u * 960u);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0u), 1280u * 960u);
  }
}

TEST(ColorCounting, CountsNothingInAnEmptyImage) {
  for (const Instructions instructions : offered_here()) {
    ColorCounts counts{};
    count_colors({}, {0, 0, 100, 100}, 1, {}, counts, instructions);
    EXPECT_EQ(counts, ColorCounts{});
  }
}

}  // namespace
}  // namespace reorient
