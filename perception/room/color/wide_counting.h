// SPDX-License-Identifier: MIT
// Counts colors many pixels at a time, for registers of any width. Only the sources of counting_kernels.h include it.
// Each defines its Lanes: a register and its operations. All names here are local to the including source.
#pragma once

#include <cstddef>
#include <cstdint>

#include "perception/room/color/counting_kernels.h"

namespace reorient {
namespace {

/// Within these sources, the code of a bin has four bits: 3 * quadrant + slice for a color, 12 for black, 14 for white.
inline constexpr int kBlack = 12;
constexpr int code_of_bin(int bin) { return bin < 2 ? kBlack + 2 * bin : 3 * ((bin - 2) % 4) + (bin - 2) / 4; }

/// Tables of 16 bytes, each in one register.
struct alignas(16) Table {
  std::uint8_t values[16] = {};
};

/// Source of masks: bytes that are set before or after a position, depending on the offset of the load.
struct Ramp {
  constexpr Ramp() {
    for (int i = 0; i < 48; ++i) values[i] = i >= 16 && i < 32 ? 0 : 0xFF;
  }
  std::uint8_t values[48] = {};
};

/// Bits for a pair of pixels from its chroma: 1: Cb is above neutral, 2: Cr is above neutral, 4: Cb is near neutral, 8:
/// Cr is near neutral. Bits 4 and 8 together mean gray.
inline constexpr int kGray = 12;
constexpr Table first_codes() {
  Table table;
  for (int chroma = 0; chroma < 16; ++chroma)
    table.values[chroma] = static_cast<std::uint8_t>(chroma >= kGray ? kBlack : 3 * (chroma % 4));
  return table;
}
constexpr Table grays() {
  Table table;
  for (int chroma = kGray; chroma < 16; ++chroma) table.values[chroma] = 0xFF;
  return table;
}
/// Maps the code of bin 2 * pair to 0x01, that of the next bin to 0x10 and every other code to 0.
constexpr Table increments(int pair) {
  Table table;
  table.values[code_of_bin(2 * pair)] = 0x01;
  table.values[code_of_bin(2 * pair + 1)] = 0x10;
  return table;
}
inline constexpr int kPairs = kColorBins / 2;
inline constexpr Table kFirstCodes = first_codes();
inline constexpr Table kGrays = grays();
inline constexpr Table kIncrements[kPairs] = {increments(0), increments(1), increments(2), increments(3),
                                              increments(4), increments(5), increments(6)};

/// Computes the codes of as many pixels as a register has bytes.
template <typename Lanes>
class Classifier {
 public:
  using Register = typename Lanes::Register;

  explicit Classifier(const ColorThresholds& t)
      : neutral_(alternating(t.cb_neutral, t.cr_neutral)),
        gray_first_(alternating(t.cb_gray_first, t.cr_gray_first)),
        gray_width_(alternating(t.cb_gray_last - t.cb_gray_first, t.cr_gray_last - t.cr_gray_first)),
        // A range with its end before its begin is empty.
        near_bits_(alternating(t.cb_gray_first <= t.cb_gray_last ? 4 : 0, t.cr_gray_first <= t.cr_gray_last ? 8 : 0)),
        first_codes_(Lanes::table(kFirstCodes.values)) {
    const Register gray = Lanes::table(kGrays.values);
    const Register white = Lanes::all(t.white);
    lower_ = Lanes::choose(Lanes::all(t.medium), white, gray);
    upper_ = Lanes::choose(Lanes::all(t.bright), white, gray);
  }

  /// Input: pixels from two positions, as many from each as half of a register has bytes. Order of the result:
  /// Lanes::packed.
  Register codes(const std::uint8_t* one, const std::uint8_t* other) const {
    const Register first = Lanes::load(one);
    const Register second = Lanes::load(other);
    const Register low_byte = Lanes::all16(0x00FF);
    const Register luma = Lanes::packed(Lanes::both(first, low_byte), Lanes::both(second, low_byte));
    // Cb Cr Cb Cr...: the two bytes of a pair are at the same positions as the luma of its two pixels.
    const Register chroma = Lanes::packed(Lanes::high_bytes(first), Lanes::high_bytes(second));
    const Register above = Lanes::both(Lanes::at_least(chroma, neutral_), Lanes::all16(0x0201));
    const Register near = Lanes::both(Lanes::at_least(gray_width_, Lanes::minus(chroma, gray_first_)), near_bits_);
    const Register half = Lanes::either(above, near);
    const Register pair = Lanes::either(half, Lanes::neighbors_swapped(half));
    // A true comparison is -1. Grays are compared with white twice.
    const Register slice = Lanes::plus(Lanes::at_least(luma, Lanes::lookup(lower_, pair)),
                                       Lanes::at_least(luma, Lanes::lookup(upper_, pair)));
    return Lanes::minus(Lanes::lookup(first_codes_, pair), slice);
  }

 private:
  static Register alternating(int even, int odd) { return Lanes::all16((even & 0xFF) | (odd & 0xFF) << 8); }

  Register neutral_, gray_first_, gray_width_, near_bits_;  // Cb in the even bytes, Cr in the odd ones
  Register first_codes_, lower_, upper_;                    // tables, indexed by the chroma bits
};

/// Counts codes in nibbles: seven registers, in which each byte has the counts (at most 15) of two bins for the pixels
/// at this byte.
template <typename Lanes>
class NibbleCounters {
 public:
  using Register = typename Lanes::Register;
  static constexpr int kMost = 15;

  explicit NibbleCounters(std::uint32_t* counts) : counts_(counts) {
#pragma GCC unroll 7
    for (Register& pair : nibbles_) pair = Lanes::all(0);
  }

  /// Must be called before more than kMost codes are added.
  void make_room_for(int additions) {
    if (additions_ + additions > kMost) widen();
    additions_ += additions;
  }

  /// A lane with its highest bit set does not count.
  void add(Register codes) {
    for (int pair = 0; pair < kPairs; ++pair)
      nibbles_[pair] = Lanes::plus(nibbles_[pair], Lanes::lookup(Lanes::table(kIncrements[pair].values), codes));
  }

  /// Same result as single calls, but each table is loaded only once.
  void add(Register codes, Register more) {
    for (int pair = 0; pair < kPairs; ++pair) {
      const Register table = Lanes::table(kIncrements[pair].values);
      const Register both = Lanes::plus(Lanes::lookup(table, codes), Lanes::lookup(table, more));
      nibbles_[pair] = Lanes::plus(nibbles_[pair], both);
    }
  }

  /// Adds the collected counts to `counts`.
  void finish() {
    widen();
    sum_up();
  }

 private:
  void widen() {
    const Register low_nibble = Lanes::all(0x0F);
    const bool first = spills_ == 0;
    for (int pair = 0; pair < kPairs; ++pair) {
      const Register low = Lanes::both(nibbles_[pair], low_nibble);
      const Register high = Lanes::both(Lanes::high_nibbles(nibbles_[pair]), low_nibble);
      bytes_[2 * pair] = first ? low : Lanes::plus(bytes_[2 * pair], low);
      bytes_[2 * pair + 1] = first ? high : Lanes::plus(bytes_[2 * pair + 1], high);
      nibbles_[pair] = Lanes::all(0);
    }
    additions_ = 0;
    if (++spills_ == 17) sum_up();  // 17 * 15 = 255
  }

  void sum_up() {
    if (spills_ == 0) return;
    for (int bin = 0; bin < 12; bin += 4)
      Lanes::add_sums(bytes_[bin], bytes_[bin + 1], bytes_[bin + 2], bytes_[bin + 3], counts_ + bin);
    const Register none = Lanes::all(0);
    Lanes::add_sums(none, none, bytes_[12], bytes_[13], counts_ + 10);
    spills_ = 0;
  }

  std::uint32_t* counts_;
  Register nibbles_[kPairs];
  Register bytes_[kColorBins];  // valid if there were spills
  int additions_ = 0;
  int spills_ = 0;
};

/// Number of pixels of a row whose halves fit into the nibbles.
template <typename Lanes>
inline constexpr int kWidest = (2 * NibbleCounters<Lanes>::kMost - 4) * Lanes::kPixels / 2;

/// Counts at most kWidest columns.
template <typename Lanes>
void count_strip(const PixelRows& rows, int begin, int end, const ColorThresholds& thresholds, std::uint32_t* counts) {
  using Register = typename Lanes::Register;
  constexpr int kHalf = Lanes::kPixels / 2;
  static constexpr Ramp kRamp;
  // The last part, which does not fill half of a register, is taken from a load that extends to where the image
  // continues.
  const int halves = (end - begin + kHalf - 1) / kHalf;
  const int rest = begin + (halves - 1) * kHalf;
  const int last = rest + kHalf <= rows.width ? rest : rows.width - kHalf;
  const std::uint8_t* before = kRamp.values + 16 - (rest - last);
  const std::uint8_t* after = kRamp.values + 32 - (end - last);
  const Register outside = Lanes::either(Lanes::halves(before, before), Lanes::halves(after, after));
  const Register second = Lanes::halves(kRamp.values + 16, kRamp.values);

  const Classifier<Lanes> classifier(thresholds);
  NibbleCounters<Lanes> counters(counts);
  const std::uint8_t* waiting = nullptr;
  for (int i = 0; i < rows.count; ++i) {
    const std::uint8_t* row = rows.first + i * rows.step;
    counters.make_room_for(halves / 2 + 1);
    int x = begin;
    for (; x + 4 * kHalf <= rest; x += 4 * kHalf) {
      const std::uint8_t* pixels = row + 2 * x;
      counters.add(classifier.codes(pixels, pixels + 2 * kHalf),
                   classifier.codes(pixels + 4 * kHalf, pixels + 6 * kHalf));
    }
    for (; x + 2 * kHalf <= rest; x += 2 * kHalf) counters.add(classifier.codes(row + 2 * x, row + 2 * (x + kHalf)));
    const std::uint8_t* tail = row + 2 * last;
    if (x < rest) {
      counters.add(Lanes::either(classifier.codes(row + 2 * x, tail), Lanes::both(outside, second)));
    } else if (waiting == nullptr) {
      waiting = tail;
    } else {
      counters.add(Lanes::either(classifier.codes(waiting, tail), outside));
      waiting = nullptr;
    }
  }
  if (waiting != nullptr)
    counters.add(Lanes::either(classifier.codes(waiting, waiting), Lanes::either(outside, second)));
  counters.finish();
}

template <typename Lanes>
void count_wide(const PixelRows& rows, int begin, int end, const ColorThresholds& thresholds, std::uint32_t* counts) {
  for (; end - begin > kWidest<Lanes>; begin += kWidest<Lanes>)
    count_strip<Lanes>(rows, begin, begin + kWidest<Lanes>, thresholds, counts);
  count_strip<Lanes>(rows, begin, end, thresholds, counts);
}

}  // namespace
}  // namespace reorient
