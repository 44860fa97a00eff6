// SPDX-License-Identifier: MIT
#include "tests/program/footage/image_files.h"

#ifdef REORIENT_FOOTAGE_IMAGES
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

namespace reorient {

bool write_lossless_video(const std::vector<std::filesystem::path>& images, const std::filesystem::path& video) {
  cv::VideoWriter writer;
  for (const std::filesystem::path& file : images) {
    const cv::Mat image = cv::imread(file.string());
    if (!writer.isOpened() &&
        !writer.open(video.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 5.0, image.size()))
      return false;
    writer.write(image);
  }
  return true;
}

std::vector<std::byte> encoded(const std::filesystem::path& image, const std::string& extension) {
  std::vector<unsigned char> bytes;
  cv::imencode(extension, cv::imread(image.string()), bytes);
  const auto* const begin = reinterpret_cast<const std::byte*>(bytes.data());
  return {begin, begin + bytes.size()};
}

}  // namespace reorient
#else

namespace reorient {

bool write_lossless_video(const std::vector<std::filesystem::path>& /*images*/,
                          const std::filesystem::path& /*video*/) {
  return false;
}
std::vector<std::byte> encoded(const std::filesystem::path& /*image*/, const std::string& /*extension*/) { return {}; }

}  // namespace reorient
#endif
