#include "perception/room/color/color_histogram.h"

#include <algorithm>
#include <cmath>

#ifdef __SSE4_1__
#include <smmintrin.h>
#endif

namespace reorient {
namespace {

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)); }

/// The block as far as it lies in the image.
PixelBlock within(const ImageView& image, const PixelBlock& block) {
  if (image.empty()) return {};
  return {std::max(block.left, 0), std::max(block.top, 0), std::min(block.right, image.width & ~1),
          std::min(block.bottom, image.height)};
}

void count_row(const std::uint8_t* row, int begin, int end, const ColorThresholds& thresholds, ColorCounts& counts) {
  for (int x = begin; x < end; ++x) {
    const std::uint8_t* pair = row + 4 * (x / 2);
    ++counts[static_cast<std::size_t>(color_bin({pair[2 * (x % 2)], pair[1], pair[3]}, thresholds))];
  }
}

#ifdef __SSE4_1__

/// The thresholds in every lane. Chroma lanes alternate: Cb in the even ones, Cr in the odd ones.
struct WideThresholds {
  explicit WideThresholds(const ColorThresholds& t)
      : medium(_mm_set1_epi8(static_cast<char>(t.medium))),
        bright(_mm_set1_epi8(static_cast<char>(t.bright))),
        white(_mm_set1_epi8(static_cast<char>(t.white))),
        neutral(alternating(t.cb_neutral, t.cr_neutral)),
        grey_first(alternating(t.cb_grey_first, t.cr_grey_first)),
        grey_last(alternating(t.cb_grey_last, t.cr_grey_last)) {}

  static __m128i alternating(int even, int odd) { return _mm_set1_epi16(static_cast<short>(even | (odd << 8))); }

  __m128i medium, bright, white, neutral, grey_first, grey_last;
};

__m128i at_least(__m128i values, __m128i limits) { return _mm_cmpeq_epi8(_mm_max_epu8(values, limits), values); }
__m128i at_most(__m128i values, __m128i limits) { return _mm_cmpeq_epi8(_mm_min_epu8(values, limits), values); }

/// The bins of 16 pixels, one in each byte.
__m128i bins_of_16(const std::uint8_t* pixels, const WideThresholds& t) {
  const __m128i low_byte = _mm_set1_epi16(0x00FF);
  const __m128i first = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels));
  const __m128i second = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels + 16));
  const __m128i luma = _mm_packus_epi16(_mm_and_si128(first, low_byte), _mm_and_si128(second, low_byte));
  // Cb Cr Cb Cr...: the two bytes of a pair lie where the luma of its two pixels lies.
  const __m128i chroma = _mm_packus_epi16(_mm_srli_epi16(first, 8), _mm_srli_epi16(second, 8));
  const __m128i swap = _mm_setr_epi8(1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14);

  const __m128i sign = _mm_and_si128(at_least(chroma, t.neutral), _mm_set1_epi16(0x0201));
  const __m128i quadrant = _mm_or_si128(sign, _mm_shuffle_epi8(sign, swap));
  const __m128i near = _mm_and_si128(at_least(chroma, t.grey_first), at_most(chroma, t.grey_last));
  const __m128i grey = _mm_and_si128(near, _mm_shuffle_epi8(near, swap));

  const __m128i four = _mm_set1_epi8(4);
  const __m128i slice =
      _mm_add_epi8(_mm_and_si128(at_least(luma, t.medium), four), _mm_and_si128(at_least(luma, t.bright), four));
  const __m128i colored = _mm_add_epi8(_mm_add_epi8(quadrant, slice), _mm_set1_epi8(2));
  const __m128i plain = _mm_and_si128(at_least(luma, t.white), _mm_set1_epi8(1));
  return _mm_blendv_epi8(colored, plain, grey);
}

/// Counts bins in nibbles: seven registers, in each byte two bins' counts (of at most 15) for that byte's pixels.
class NibbleCounters {
 public:
  /// A lane with its highest bit set does not count.
  void add(__m128i bins) {
    for (int pair = 0; pair < 7; ++pair) {
      nibbles_[pair] = _mm_add_epi8(nibbles_[pair], _mm_shuffle_epi8(increment(pair), bins));
    }
    if (++additions_ == 15) spill_nibbles();
  }

  void add_to(ColorCounts& counts) {
    spill_nibbles();
    spill_bytes();
    for (int bin = 0; bin < kColorBins; ++bin) {
      counts[static_cast<std::size_t>(bin)] +=
          static_cast<std::uint32_t>(_mm_extract_epi32(sums_[bin], 0) + _mm_extract_epi32(sums_[bin], 2));
    }
  }

 private:
  /// A table that turns bin 2 * pair into 0x01, the next bin into 0x10 and every other one into 0.
  static __m128i increment(int pair) {
    alignas(16) static constexpr auto kTables = [] {
      std::array<std::array<char, 16>, 7> tables{};
      for (std::size_t i = 0; i < 7; ++i) {
        tables[i][2 * i] = 0x01;
        tables[i][2 * i + 1] = 0x10;
      }
      return tables;
    }();
    return _mm_load_si128(reinterpret_cast<const __m128i*>(kTables[static_cast<std::size_t>(pair)].data()));
  }

  void spill_nibbles() {
    const __m128i low_nibble = _mm_set1_epi8(0x0F);
    for (int pair = 0; pair < 7; ++pair) {
      const __m128i both = nibbles_[pair];
      bytes_[2 * pair] = _mm_add_epi8(bytes_[2 * pair], _mm_and_si128(both, low_nibble));
      bytes_[2 * pair + 1] = _mm_add_epi8(bytes_[2 * pair + 1], _mm_and_si128(_mm_srli_epi16(both, 4), low_nibble));
      nibbles_[pair] = _mm_setzero_si128();
    }
    additions_ = 0;
    if (++spills_ == 17) spill_bytes();  // 17 * 15 = 255
  }

  void spill_bytes() {
    for (int bin = 0; bin < kColorBins; ++bin) {
      sums_[bin] = _mm_add_epi64(sums_[bin], _mm_sad_epu8(bytes_[bin], _mm_setzero_si128()));
      bytes_[bin] = _mm_setzero_si128();
    }
    spills_ = 0;
  }

  __m128i nibbles_[7] = {};
  __m128i bytes_[kColorBins] = {};
  __m128i sums_[kColorBins] = {};
  int additions_ = 0;
  int spills_ = 0;
};

/// 0xFF in the first `skipped` of 16 lanes.
__m128i first_lanes(int skipped) {
  alignas(16) static constexpr auto kRamp = [] {
    std::array<std::uint8_t, 32> ramp{};
    for (std::size_t i = 0; i < 16; ++i) ramp[i] = 0xFF;
    return ramp;
  }();
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(kRamp.data() + 16 - skipped));
}

#endif

}  // namespace

bool is_sound(const Light& light) {
  const auto is_level = [](double value) { return value >= 0.0 && value <= 255.0; };
  return is_level(light.luma) && is_level(light.cb) && is_level(light.cr);
}

RelativeLight relative(const Light& place, const Light& room) {
  return {room.luma > 0.0 ? place.luma / room.luma : 1.0, place.cb - room.cb, place.cr - room.cr};
}

ColorThresholds color_thresholds(const ColorParameters& parameters, const Light& light) {
  const double gain = light.luma / Light{}.luma;
  const double dark = std::min(parameters.dark_below, parameters.bright_above);
  ColorThresholds thresholds;
  thresholds.medium = to_byte(std::ceil(dark * gain));
  thresholds.bright = to_byte(std::ceil(parameters.bright_above * gain));
  thresholds.white = to_byte(std::ceil(0.5 * (dark + parameters.bright_above) * gain));
  thresholds.cb_neutral = to_byte(std::ceil(light.cb));
  thresholds.cr_neutral = to_byte(std::ceil(light.cr));
  thresholds.cb_grey_first = to_byte(std::floor(light.cb - parameters.grey_within) + 1.0);
  thresholds.cb_grey_last = to_byte(std::ceil(light.cb + parameters.grey_within) - 1.0);
  thresholds.cr_grey_first = to_byte(std::floor(light.cr - parameters.grey_within) + 1.0);
  thresholds.cr_grey_last = to_byte(std::ceil(light.cr + parameters.grey_within) - 1.0);
  return thresholds;
}

int color_bin(const Ycbcr& pixel, const ColorThresholds& t) {
  const bool grey = pixel.cb >= t.cb_grey_first && pixel.cb <= t.cb_grey_last && pixel.cr >= t.cr_grey_first &&
                    pixel.cr <= t.cr_grey_last;
  if (grey) return pixel.y >= t.white ? 1 : 0;
  const int slice = (pixel.y >= t.medium ? 1 : 0) + (pixel.y >= t.bright ? 1 : 0);
  const int quadrant = (pixel.cb >= t.cb_neutral ? 1 : 0) + (pixel.cr >= t.cr_neutral ? 2 : 0);
  return 2 + 4 * slice + quadrant;
}

void count_colors_one_by_one(const ImageView& image, const PixelBlock& block, int row_step,
                             const ColorThresholds& thresholds, ColorCounts& counts) {
  const PixelBlock part = within(image, block);
  for (int y = part.top; y < part.bottom; y += std::max(row_step, 1)) {
    count_row(image.row(y), part.left, part.right, thresholds, counts);
  }
}

#ifdef __SSE4_1__

void count_colors(const ImageView& image, const PixelBlock& block, int row_step, const ColorThresholds& thresholds,
                  ColorCounts& counts) {
  const PixelBlock part = within(image, block);
  if (part.right < 16) return count_colors_one_by_one(image, block, row_step, thresholds, counts);
  const WideThresholds wide(thresholds);
  const int begin = part.left + part.left % 2;  // pairs of pixels share their chroma
  const int end = part.right - part.right % 2;
  NibbleCounters counters;
  for (int y = part.top; y < part.bottom; y += std::max(row_step, 1)) {
    const std::uint8_t* row = image.row(y);
    int x = begin;
    for (; x + 16 <= end; x += 16) counters.add(bins_of_16(row + 2 * x, wide));
    if (x < end) {  // the last 16 pixels before the end, without those that were counted already
      counters.add(_mm_or_si128(bins_of_16(row + 2 * (end - 16), wide), first_lanes(16 - (end - x))));
    }
    count_row(row, part.left, std::min(begin, part.right), thresholds, counts);
    if (end >= begin) count_row(row, end, part.right, thresholds, counts);
  }
  counters.add_to(counts);
}

#else

void count_colors(const ImageView& image, const PixelBlock& block, int row_step, const ColorThresholds& thresholds,
                  ColorCounts& counts) {
  count_colors_one_by_one(image, block, row_step, thresholds, counts);
}

#endif

ColorHistogram normalized(const ColorCounts& counts) {
  std::uint64_t sum = 0;
  for (const std::uint32_t count : counts) sum += count;
  ColorHistogram histogram{};
  if (sum == 0) return histogram;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    histogram[bin] = static_cast<float>(static_cast<double>(counts[bin]) / static_cast<double>(sum));
  }
  return histogram;
}

ColorHistogram blurred(const ColorHistogram& histogram, double share) {
  const auto value = [&](int slice, int quadrant) {
    if (slice < 0) return histogram[0];
    if (slice > 2) return histogram[1];
    return histogram[static_cast<std::size_t>(2 + 4 * slice + quadrant)];
  };
  const float given = static_cast<float>(share);
  const float kept = 1.0f - 4.0f * given;
  ColorHistogram result{};
  result[0] = kept * histogram[0];
  result[1] = kept * histogram[1];
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    result[0] += given * value(0, quadrant);
    result[1] += given * value(2, quadrant);
    for (int slice = 0; slice < 3; ++slice) {
      result[static_cast<std::size_t>(2 + 4 * slice + quadrant)] =
          kept * value(slice, quadrant) + given * (value(slice - 1, quadrant) + value(slice + 1, quadrant) +
                                                   value(slice, quadrant ^ 1) + value(slice, quadrant ^ 2));
    }
  }
  return result;
}

}  // namespace reorient
