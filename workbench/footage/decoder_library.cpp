// SPDX-License-Identifier: MIT
#include "workbench/footage/decoder_library.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <dlfcn.h>

#include "robots/footage/footage.h"
#include "robots/image_files/exif_orientation.h"
#include "robots/image_files/jpeg_headers.h"
#include "robots/image_files/png_chunks.h"
#include "robots/image_formats.h"
#include "workbench/footage/decoder_functions.h"

namespace reorient {
namespace {

constexpr const char* kName = "reorient_decoder.so";

struct Functions {
  decltype(&reorient_decode_image) decode_image = nullptr;
  decltype(&reorient_open_video) open_video = nullptr;
  decltype(&reorient_next_frame) next_frame = nullptr;
  decltype(&reorient_frames_per_second) frames_per_second = nullptr;
  decltype(&reorient_close_video) close_video = nullptr;
};

/// `orientation`: of EXIF, in which the image is shown.
Image image_of(const reorient_pixels& pixels, const std::string& where, int orientation = 1) {
  constexpr int kLeast = 8, kMost = 16384;  // pixels a side
  if (std::min(pixels.width, pixels.height) < kLeast || std::max(pixels.width, pixels.height) > kMost)
    throw BadFootage(where + ": expected an image of " + std::to_string(kLeast) + " to " + std::to_string(kMost) +
                     " pixels a side, found " + std::to_string(pixels.width) + "x" + std::to_string(pixels.height));
  const ShownImage shown(pixels.width, pixels.height, orientation);
  Image image(shown.width() & ~1, shown.height() & ~1);
  std::vector<std::uint8_t> even;
  even.reserve(3 * static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y) {
    if (orientation == 1) {  // whole rows are copied faster
      const unsigned char* const from = pixels.bgr + 3 * shown.stored(0, y);
      even.insert(even.end(), from, from + 3 * static_cast<std::size_t>(image.width()));
      continue;
    }
    for (int x = 0; x < image.width(); ++x) {
      const unsigned char* const from = pixels.bgr + 3 * shown.stored(x, y);
      even.insert(even.end(), from, from + 3);
    }
  }
  convert_image(even, PixelFormat::bgr, image);
  return image;
}

/// Throws BadFootage with the reason for which the library would refuse the image, or show it with gray parts.
int checked_orientation(std::span<const std::uint8_t> bytes, const std::string& where) {
  const auto require_end = [&](bool has_end, const char* format) {
    if (!has_end)
      throw BadFootage(where + ": expected a whole " + format + ", found " + std::to_string(bytes.size()) +
                       " bytes without its end");
  };
  if (looks_like_png(bytes)) {
    const PngChunks png = read_png_chunks(bytes);
    require_end(png.has_end, "PNG");
    return png.orientation;
  }
  if (!looks_like_jpeg(bytes)) return 1;
  const JpegHeaders jpeg = read_jpeg_headers(bytes);
  require_end(jpeg.has_end, "JPEG");
  if (const std::string reason = undecodable(jpeg); !reason.empty()) throw BadFootage(where + ": " + reason);
  return jpeg.orientation;
}

class VideoFile : public FrameReader {
 public:
  VideoFile(const Functions& functions, const std::filesystem::path& file)
      : functions_(functions), name_(file.string()), video_(functions.open_video(file.c_str())) {
    if (video_ == nullptr) throw BadFootage(name_ + ": expected a video that FFmpeg can read, found another file");
  }
  ~VideoFile() override { functions_.close_video(video_); }
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  bool next(Image& image) override {
    reorient_pixels pixels{};
    if (functions_.next_frame(video_, &pixels) != 0) return false;
    image = image_of(pixels, name_);
    return true;
  }
  double frames_per_second() const override { return functions_.frames_per_second(video_); }

 private:
  Functions functions_;
  std::string name_;
  void* video_;
};

/// Stays loaded as long as the program runs.
Functions functions_of(void* library, const std::filesystem::path& file) {
  const auto find = [&]<typename Function>(const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(dlsym(library, name));
    if (function == nullptr)
      throw BadFootage(file.string() + ": expected a library with " + name + ", found none in it");
  };
  decltype(&reorient_decoder_version) version = nullptr;
  find("reorient_decoder_version", version);
  if (const int found = version(); found != REORIENT_DECODER_VERSION)
    throw BadFootage(file.string() + ": expected a decoder of version " + std::to_string(REORIENT_DECODER_VERSION) +
                     ", found " + std::to_string(found));
  Functions functions;
  find("reorient_decode_image", functions.decode_image);
  find("reorient_open_video", functions.open_video);
  find("reorient_next_frame", functions.next_frame);
  find("reorient_frames_per_second", functions.frames_per_second);
  find("reorient_close_video", functions.close_video);
  return functions;
}

/// Possible locations.
std::vector<std::filesystem::path> decoder_places() {
  std::vector<std::filesystem::path> places;
  if (const char* const named = std::getenv("REORIENT_DECODER"); named != nullptr && *named != '\0') return {named};
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const std::filesystem::path folder = program.parent_path();
  return {folder / kName, folder.parent_path() / "lib" / "reorient" / kName};
}

Functions load() {
  std::string missing;
  for (const std::filesystem::path& file : decoder_places()) {
    if (void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return functions_of(library, file);
    const char* const reason = dlerror();
    missing.append(missing.empty() ? "" : "; ").append(reason != nullptr ? reason : file.string());
  }
  throw BadFootage("decoding images and videos needs " + std::string(kName) +
                   ", which is built if libopencv-imgcodecs-dev and libopencv-videoio-dev are installed (" + missing +
                   ")");
}

const Functions& functions() {
  static const Functions loaded = load();
  return loaded;
}

}  // namespace

FootageDecoder decoder_library() {
  return {[](std::span<const std::byte> bytes, const std::string& where) {
            reorient_pixels pixels{};
            const int orientation =
                checked_orientation({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, where);
            if (functions().decode_image(bytes.data(), bytes.size(), &pixels) != 0)
              throw BadFootage(where + ": expected an image, found " + std::to_string(bytes.size()) +
                               " bytes that are not an image, or a damaged image");
            return image_of(pixels, where, orientation);
          },
          [](const std::filesystem::path& file) { return std::make_unique<VideoFile>(functions(), file); }};
}

}  // namespace reorient
