// SPDX-License-Identifier: MIT
// Time of the 14-bin histogram for a whole 640x480 image in 64 tiles on one core, compared with the lower limit
// (reading the bytes) and with OpenCV. The last benchmark prints both ratios.
#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "geometry/random.h"
#include "perception/room/color/color_counting.h"

namespace reorient {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kTileColumns = 8;
constexpr int kTileRows = 8;

/// Patches of color with grain, as in a room.
Image room_like_image() {
  Image image(kWidth, kHeight);
  Random random(1);
  std::vector<Ycbcr> patches;
  for (int i = 0; i < 40 * 30; ++i) {
    const auto level = [&random](double low, double high) {
      return static_cast<std::uint8_t>(random.uniform(low, high));
    };
    patches.push_back({level(10, 240), level(100, 156), level(100, 156)});
  }
  for (int y = 0; y < kHeight; ++y) {
    std::uint8_t* row = image.row(y);
    for (int x = 0; x < kWidth; x += 2) {
      const Ycbcr& patch = patches[static_cast<std::size_t>((y / 16) * 40 + x / 16)];
      const auto grain = [&random] { return static_cast<int>(random.below(9)) - 4; };
      row[2 * x] = static_cast<std::uint8_t>(patch.y + grain());
      row[2 * x + 1] = static_cast<std::uint8_t>(patch.cb + grain());
      row[2 * x + 2] = static_cast<std::uint8_t>(patch.y + grain());
      row[2 * x + 3] = static_cast<std::uint8_t>(patch.cr + grain());
    }
  }
  return image;
}

using Tiles = std::array<ColorCounts, kTileColumns * kTileRows>;

void count_tiles(const ImageView& image, int row_step, Instructions instructions, Tiles& tiles) {
  constexpr int kBand = 8;  // rows, as for the perceived tiles
  tiles = {};
  for (int top = 0; top < kHeight; top += kBand) {
    for (int column = 0; column < kTileColumns; ++column) {
      const PixelBlock block{column * kWidth / kTileColumns, top, (column + 1) * kWidth / kTileColumns, top + kBand};
      const int tile = top * kTileRows / kHeight * kTileColumns + column;
      count_colors(image, block, row_step, {}, tiles[static_cast<std::size_t>(tile)], instructions);
    }
  }
}

std::uint64_t sum_of_words(const Image& image) {
  const auto* words = reinterpret_cast<const std::uint64_t*>(image.bytes().data());
  const std::size_t count = image.bytes().size() / sizeof(std::uint64_t);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += words[i];
  return sum;
}

void ReadBytesOnce(benchmark::State& state) {
  const Image image = room_like_image();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(sum_of_words(image));
}
BENCHMARK(ReadBytesOnce)->Unit(benchmark::kMicrosecond);

/// Arguments: Instructions; n, if every n-th row is counted.
void CountColors(benchmark::State& state) {
  const auto instructions = static_cast<Instructions>(state.range(0));
  if (!offered(instructions)) return state.SkipWithError("this processor does not support the instructions");
  const Image image = room_like_image();
  Tiles tiles;
  for ([[maybe_unused]] auto _ : state) {
    count_tiles(image.view(), static_cast<int>(state.range(1)), instructions, tiles);
    benchmark::DoNotOptimize(tiles.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(CountColors)
    ->ArgNames({"instructions", "row_step"})
    ->ArgsProduct({{static_cast<int>(Instructions::portable), static_cast<int>(Instructions::sse4),
                    static_cast<int>(Instructions::avx2), static_cast<int>(Instructions::neon)},
                   {1, 2}})
    ->Unit(benchmark::kMicrosecond);

/// OpenCV does not have this histogram. The most similar one has 3 x 2 x 2 bins of Y, Cr, Cb, here for the whole image.
class OpenCvHistogram {
 public:
  explicit OpenCvHistogram(Image& image) : yuyv_(kHeight, kWidth, CV_8UC2, image.row(0)) { cv::setNumThreads(1); }

  void compute() {
    const int channels[] = {0, 1, 2};
    const int bins[] = {3, 2, 2};
    const float range[] = {0.0f, 256.0f};
    const float* ranges[] = {range, range, range};
    cv::cvtColor(yuyv_, bgr_, cv::COLOR_YUV2BGR_YUYV);
    cv::cvtColor(bgr_, ycrcb_, cv::COLOR_BGR2YCrCb);
    cv::calcHist(&ycrcb_, 1, channels, cv::Mat(), histogram_, 3, bins, ranges);
    benchmark::DoNotOptimize(histogram_.data);
  }

 private:
  cv::Mat yuyv_, bgr_, ycrcb_, histogram_;
};

void OpenCvCvtColorCalcHist(benchmark::State& state) {
  Image image = room_like_image();
  OpenCvHistogram histogram(image);
  for ([[maybe_unused]] auto _ : state) histogram.compute();
}
BENCHMARK(OpenCvCvtColorCalcHist)->Unit(benchmark::kMicrosecond);

/// The same without the conversion to YCbCr.
void OpenCvCvtColorBgrCalcHist(benchmark::State& state) {
  cv::setNumThreads(1);
  Image image = room_like_image();
  const cv::Mat yuyv(kHeight, kWidth, CV_8UC2, image.row(0));
  cv::Mat bgr;
  cv::Mat histogram;
  const int channels[] = {0, 1, 2};
  const int bins[] = {3, 3, 3};
  const float range[] = {0.0f, 256.0f};
  const float* ranges[] = {range, range, range};
  for ([[maybe_unused]] auto _ : state) {
    cv::cvtColor(yuyv, bgr, cv::COLOR_YUV2BGR_YUYV);
    cv::calcHist(&bgr, 1, channels, cv::Mat(), histogram, 3, bins, ranges);
    benchmark::DoNotOptimize(histogram.data);
  }
}
BENCHMARK(OpenCvCvtColorBgrCalcHist)->Unit(benchmark::kMicrosecond);

/// Wall-clock times of many calls, which other processes may disturb.
class Stopwatch {
 public:
  template <typename Work>
  void time(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    seconds_.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }

  double median() {
    const auto middle = seconds_.begin() + static_cast<std::ptrdiff_t>(seconds_.size() / 2);
    std::nth_element(seconds_.begin(), middle, seconds_.end());
    return *middle;
  }

 private:
  std::vector<double> seconds_;
};

/// The widest version with every row, in turn with reading and with OpenCV: the medians and their ratios.
void Ratios(benchmark::State& state) {
  Image image = room_like_image();
  OpenCvHistogram histogram(image);
  Tiles tiles;
  Stopwatch read, ours, opencv;
  for ([[maybe_unused]] auto _ : state) {
    for (int i = 0; i < 4; ++i) {
      read.time([&] { benchmark::DoNotOptimize(sum_of_words(image)); });
      ours.time([&] {
        count_tiles(image.view(), 1, widest_instructions(), tiles);
        benchmark::DoNotOptimize(tiles.data());
      });
    }
    opencv.time([&] { histogram.compute(); });
  }
  state.counters["read_us"] = 1e6 * read.median();
  state.counters["ours_us"] = 1e6 * ours.median();
  state.counters["opencv_us"] = 1e6 * opencv.median();
  state.counters["ours_to_read"] = ours.median() / read.median();
  state.counters["opencv_to_ours"] = opencv.median() / ours.median();
}
BENCHMARK(Ratios)->Unit(benchmark::kMicrosecond)->MinTime(2.0);

}  // namespace
}  // namespace reorient
