// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "workbench/footage/decoder_functions.h"

namespace {

/// Suppresses the output of OpenCV, because the caller reports the error in one line.
void silence() {
  static std::once_flag once;
  std::call_once(once, [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; });
  });
}

/// False: there are none of the kind.
bool hand_over(cv::Mat& pixels, reorient_pixels* to) {
  if (pixels.empty() || pixels.type() != CV_8UC3) return false;
  if (!pixels.isContinuous()) pixels = pixels.clone();
  *to = {pixels.cols, pixels.rows, pixels.data};
  return true;
}

struct Video {
  cv::VideoCapture capture;
  cv::Mat pixels;
};

}  // namespace

int reorient_decoder_version() { return REORIENT_DECODER_VERSION; }

int reorient_decode_image(const void* bytes, size_t size, reorient_pixels* pixels) {
  static thread_local cv::Mat decoded;
  silence();
  if (size == 0 || size > static_cast<size_t>(std::numeric_limits<int>::max())) return 1;
  try {
    const cv::Mat encoded(1, static_cast<int>(size), CV_8UC1, const_cast<void*>(bytes));  // read only
    decoded = cv::imdecode(encoded, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    return hand_over(decoded, pixels) ? 0 : 1;
  } catch (const std::exception&) {
    return 1;
  }
}

void* reorient_open_video(const char* file) {
  silence();
  try {
    auto video = std::make_unique<Video>();
    return video->capture.open(file, cv::CAP_FFMPEG) ? video.release() : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}

int reorient_next_frame(void* video, reorient_pixels* pixels) {
  auto* const one = static_cast<Video*>(video);
  try {
    return one->capture.read(one->pixels) && hand_over(one->pixels, pixels) ? 0 : 1;
  } catch (const std::exception&) {
    return 1;
  }
}

double reorient_frames_per_second(void* video) {
  const double rate = static_cast<Video*>(video)->capture.get(cv::CAP_PROP_FPS);
  return std::isfinite(rate) && rate > 0.0 ? rate : 0.0;
}

void reorient_close_video(void* video) { delete static_cast<Video*>(video); }
