// SPDX-License-Identifier: MIT
#include "robots/simulator/room/panorama.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <png.h>
#include <turbojpeg.h>

#include "geometry/pinned_math.h"
#include "robots/image_files/exif_orientation.h"
#include "robots/image_files/jpeg_headers.h"
#include "robots/image_files/png_chunks.h"
#include "robots/simulator/room/radiance.h"

namespace reorient {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw std::runtime_error("panorama '" + name + "': " + what);
}

std::vector<std::uint8_t> read_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail(path, "expected an image file, found none; check the path");
  if (!std::filesystem::is_regular_file(status))
    fail(path, "expected a .hdr, .png or .jpg file, found something that is not a file");
  const auto size = std::filesystem::file_size(path, error);
  constexpr std::uintmax_t kLargest = 256u << 20;
  if (error) fail(path, "cannot be read: " + error.message());
  if (size == 0) fail(path, "expected an image, found an empty file; fetch or export it again");
  if (size > kLargest)
    fail(path, "expected at most 256 MB, found a larger file; scale it down to at most 8192x4096 pixels");
  std::vector<std::uint8_t> bytes(size);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) fail(path, std::string("cannot be read: ") + std::strerror(errno));
  return bytes;
}

/// `color_of`: the light of a stored pixel, by its index.
template <typename ColorOf>
LinearImage as_shown(const ShownImage& shown, ColorOf&& color_of) {
  LinearImage image(shown.width(), shown.height());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) image.at(x, y) = color_of(shown.stored(x, y));
  }
  return image;
}

/// Least number of bytes of the inflated rows of a PNG. `bytes` begins with a valid IHDR chunk.
std::size_t inflated_size(const png_image& png, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kDepth = 24, kColorType = 25;  // offsets in the file
  constexpr std::array<std::size_t, 7> kChannels{1, 0, 3, 1, 2, 0, 4};
  const std::size_t bits = std::size_t{bytes[kDepth]} * kChannels.at(bytes[kColorType]);
  return png.height * (1 + (png.width * bits + 7) / 8);
}

LinearImage decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&png, png_image_free);
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    fail(name, std::string("expected a readable PNG, found damaged data (") + png.message + "); export it again");
  }
  constexpr png_uint_32 kSane = 1u << 20;
  const ShownImage shown(static_cast<int>(std::min(png.width, kSane)), static_cast<int>(std::min(png.height, kSane)),
                         read_png_chunks(bytes).orientation);
  check_panorama_size(shown.width(), shown.height(), name);
  // Deflate makes at most 1032 bytes of one. So reject a file that is too short before memory is allocated.
  constexpr std::size_t kMostOfOne = 1032;
  if (inflated_size(png, bytes) / kMostOfOne > bytes.size())
    fail(name, "expected more data, found the end of the file; fetch or export it again");
  png.format = PNG_FORMAT_LINEAR_RGB;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // as viewers do: 16 bits without a gamma in the file are not linear
  std::vector<png_uint_16> light(3 * static_cast<std::size_t>(png.width) * png.height);
  if (png_image_finish_read(&png, nullptr, light.data(), 0, nullptr) == 0) {
    fail(name, std::string("expected intact image data, found damage (") + png.message + "); fetch or export it again");
  }
  constexpr float kFull = 65535.0f;
  return as_shown(shown, [&](std::size_t i) -> LinearColor {
    return LinearColor(light[3 * i], light[3 * i + 1], light[3 * i + 2]) / kFull;
  });
}

/// From sRGB's gamma (IEC 61966-2-1) to linear light.
std::array<float, 256> linear_from_srgb() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = static_cast<double>(i) / 255.0;
    table[i] = static_cast<float>(value <= 0.04045 ? value / 12.92 : pinned::pow((value + 0.055) / 1.055, 2.4));
  }
  return table;
}

/// Whether a decoder only skipped bytes that belong to no segment, which changes no pixel. It reports its first
/// warning.
bool only_skipped_bytes(tjhandle decoder) {
  return tjGetErrorCode(decoder) == TJERR_WARNING &&
         std::string_view(tjGetErrorStr2(decoder)).find("extraneous bytes") != std::string_view::npos;
}

/// Multiplies inks by black. Writers store them inverted, so 255 is no ink (Adobe Technical Note 5116).
std::vector<std::uint8_t> rgb_of_inks(const std::vector<std::uint8_t>& cmyk) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(cmyk.size() / 4 * 3);
  for (std::size_t i = 0; i < cmyk.size(); i += 4) {
    for (std::size_t ink = 0; ink < 3; ++ink)
      rgb.push_back(static_cast<std::uint8_t>((cmyk[i + ink] * cmyk[i + 3] + 127) / 255));
  }
  return rgb;
}

LinearImage decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name) {
  const JpegHeaders headers = read_jpeg_headers(bytes);
  if (const std::string reason = undecodable(headers); !reason.empty()) fail(name, reason);
  const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), tjDestroy);
  if (!decoder) fail(name, "cannot be decoded: out of memory");
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colors = 0;
  const auto size = static_cast<unsigned long>(bytes.size());
  // This also fails for a rare subsampling, such as 4:1:0, which is decoded nevertheless.
  tjDecompressHeader3(decoder.get(), bytes.data(), size, &width, &height, &subsampling, &colors);
  if (width <= 0 || height <= 0) {
    fail(name, std::string("expected a readable JPEG, found damaged data (") + tjGetErrorStr2(decoder.get()) +
                   "); export it again");
  }
  const ShownImage shown(width, height, headers.orientation);
  check_panorama_size(shown.width(), shown.height(), name);
  const bool has_inks = headers.colors == 4;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint8_t> rgb((has_inks ? 4 : 3) * pixels);
  if (tjDecompress2(decoder.get(), bytes.data(), size, rgb.data(), width, 0, height, has_inks ? TJPF_CMYK : TJPF_RGB,
                    TJFLAG_ACCURATEDCT) != 0 &&
      !only_skipped_bytes(decoder.get())) {
    fail(name, std::string("expected intact image data, found damage (") + tjGetErrorStr2(decoder.get()) +
                   "); fetch or export it again");
  }
  if (has_inks) rgb = rgb_of_inks(rgb);
  static const std::array<float, 256> linear = linear_from_srgb();
  return as_shown(shown, [&](std::size_t i) -> LinearColor {
    return {linear[rgb[3 * i]], linear[rgb[3 * i + 1]], linear[rgb[3 * i + 2]]};
  });
}

}  // namespace

void check_panorama_size(int width, int height, const std::string& name) {
  constexpr int kSmallest = 32;
  constexpr int kLargest = 8192;
  constexpr double kTolerance = 0.1;
  const std::string found = ", found " + std::to_string(width) + " x " + std::to_string(height) + " pixels; ";
  if (width < kSmallest || height < kSmallest / 2 || width > kLargest || height > kLargest / 2) {
    fail(name, "expected 32 x 16 to 8192 x 4096 pixels" + found + "scale it");
  }
  if (std::abs(static_cast<double>(width) / height - 2.0) > kTolerance) {
    fail(name, "expected an equirectangular panorama, twice as wide as high" + found + "export it again");
  }
}

LinearImage decode_panorama(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (looks_like_radiance(bytes)) return decode_radiance(bytes, name);
  if (looks_like_png(bytes)) return decode_png(bytes, name);
  if (looks_like_jpeg(bytes)) return decode_jpeg(bytes, name);
  fail(name, "expected Radiance .hdr, .png or .jpg, found an unknown format; convert it");
}

LinearImage read_panorama(const std::string& path) { return decode_panorama(read_file(path), path); }

}  // namespace reorient
