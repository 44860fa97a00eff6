// What the 14-bin histogram costs for a whole 640x480 image in 64 tiles, beside the limit (reading the bytes) and what
// OpenCV offers. One core.
#include <vector>

#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "geometry/random.h"
#include "perception/room/color/color_histogram.h"

namespace reorient {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kTileColumns = 8;
constexpr int kTileRows = 8;

/// Patches of colour with grain, as a room has them.
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

template <typename Count>
void count_tiles(benchmark::State& state, const Count& count) {
  const Image image = room_like_image();
  const ColorThresholds thresholds;
  const auto row_step = static_cast<int>(state.range(0));
  std::vector<ColorCounts> tiles(kTileColumns * kTileRows);
  constexpr int kBand = 8;  // rows, as the perceived tiles come
  for ([[maybe_unused]] auto _ : state) {
    for (ColorCounts& tile : tiles) tile.fill(0);
    for (int top = 0; top < kHeight; top += kBand) {
      for (int column = 0; column < kTileColumns; ++column) {
        const PixelBlock block{column * kWidth / kTileColumns, top, (column + 1) * kWidth / kTileColumns, top + kBand};
        const int tile = top * kTileRows / kHeight * kTileColumns + column;
        count(image.view(), block, row_step, thresholds, tiles[static_cast<std::size_t>(tile)]);
      }
    }
    benchmark::DoNotOptimize(tiles.data());
    benchmark::ClobberMemory();
  }
}

void ReadBytesOnce(benchmark::State& state) {
  const Image image = room_like_image();
  const auto* words = reinterpret_cast<const std::uint64_t*>(image.bytes().data());
  const std::size_t count = image.bytes().size() / sizeof(std::uint64_t);
  for ([[maybe_unused]] auto _ : state) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += words[i];
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(ReadBytesOnce)->Unit(benchmark::kMicrosecond);

/// Argument: every how manieth row is counted.
void CountColors(benchmark::State& state) { count_tiles(state, count_colors); }
BENCHMARK(CountColors)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

void CountColorsOneByOne(benchmark::State& state) { count_tiles(state, count_colors_one_by_one); }
BENCHMARK(CountColorsOneByOne)->Arg(1)->Unit(benchmark::kMicrosecond);

/// OpenCV has no such histogram; the nearest is 3 x 2 x 2 bins of Y, Cr, Cb, here for the whole image at once.
void OpenCvCvtColorCalcHist(benchmark::State& state) {
  cv::setNumThreads(1);
  Image image = room_like_image();
  const cv::Mat yuyv(kHeight, kWidth, CV_8UC2, image.row(0));
  cv::Mat bgr;
  cv::Mat ycrcb;
  cv::Mat histogram;
  const int channels[] = {0, 1, 2};
  const int bins[] = {3, 2, 2};
  const float range[] = {0.0f, 256.0f};
  const float* ranges[] = {range, range, range};
  for ([[maybe_unused]] auto _ : state) {
    cv::cvtColor(yuyv, bgr, cv::COLOR_YUV2BGR_YUYV);
    cv::cvtColor(bgr, ycrcb, cv::COLOR_BGR2YCrCb);
    cv::calcHist(&ycrcb, 1, channels, cv::Mat(), histogram, 3, bins, ranges);
    benchmark::DoNotOptimize(histogram.data);
  }
}
BENCHMARK(OpenCvCvtColorCalcHist)->Unit(benchmark::kMicrosecond);

/// The same without the way back to YCbCr.
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

}  // namespace
}  // namespace reorient
