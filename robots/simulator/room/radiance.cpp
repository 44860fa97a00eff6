// SPDX-License-Identifier: MIT
#include "robots/simulator/room/radiance.h"

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "robots/simulator/room/panorama.h"

namespace reorient {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Reads bytes from the front. Throws at the end of the data.
class Reader {
 public:
  Reader(std::span<const std::uint8_t> bytes, const std::string& name) : rest_(bytes), name_(name) {}

  std::size_t left() const { return rest_.size(); }

  std::uint8_t byte() {
    if (rest_.empty()) fail("expected more data, found the end of the file; fetch or export it again");
    const std::uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }

  Rgbe pixel() { return {byte(), byte(), byte(), byte()}; }

  /// Reads up to the next line feed and skips it.
  std::string_view line() {
    constexpr std::size_t kLongest = 4096;
    for (std::size_t i = 0; i < rest_.size() && i < kLongest; ++i) {
      if (rest_[i] != '\n') continue;
      std::string_view text(reinterpret_cast<const char*>(rest_.data()), i);
      rest_ = rest_.subspan(i + 1);
      if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
      return text;
    }
    fail("expected a Radiance header, found other bytes; export it again as Radiance .hdr");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("panorama '" + name_ + "': " + what);
  }

 private:
  std::span<const std::uint8_t> rest_;
  const std::string& name_;
};

/// The layout from the resolution line: "-Y 512 +X 1024" means top row first, left pixel first.
struct Layout {
  int width = 0;
  int height = 0;
  bool bottom_first = false;
  bool right_first = false;
};

Layout read_header(Reader& reader) {
  while (true) {
    const std::string_view line = reader.line();
    if (line.empty()) break;
    if (line.starts_with("FORMAT=") && line.find("rle_rgbe") == std::string_view::npos) {
      reader.fail("expected pixels of the format 32-bit_rle_rgbe, found another format; export it again");
    }
  }
  const std::string_view resolution = reader.line();
  std::istringstream words{std::string(resolution)};
  std::string rows;
  std::string columns;
  Layout layout;
  words >> rows >> layout.height >> columns >> layout.width;
  if (!words || (rows != "-Y" && rows != "+Y") || (columns != "-X" && columns != "+X")) {
    reader.fail(
        "expected a resolution such as '-Y 512 +X 1024' after the header, found other bytes; export it again as "
        "Radiance .hdr, not rotated");
  }
  layout.bottom_first = rows == "+Y";
  layout.right_first = columns == "-X";
  return layout;
}

/// The four channels of a row one by one, as runs (a length above 128, one value) and literals (a length, its values).
void read_coded_row(Reader& reader, std::vector<Rgbe>& row) {
  constexpr int kRun = 128;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    for (std::size_t x = 0; x < row.size();) {
      const int code = reader.byte();
      const bool run = code > kRun;
      const auto count = static_cast<std::size_t>(run ? code - kRun : code);
      if (count == 0 || count > row.size() - x)
        reader.fail("expected intact rows, found a damaged one; fetch or export it again");
      if (run) {
        const std::uint8_t value = reader.byte();
        for (std::size_t i = 0; i < count; ++i) row[x + i][channel] = value;
      } else {
        for (std::size_t i = 0; i < count; ++i) row[x + i][channel] = reader.byte();
      }
      x += count;
    }
  }
}

/// Pixel by pixel; (1, 1, 1, n) repeats the previous pixel, as Radiance wrote before 1991.
void read_flat_row(Reader& reader, Rgbe first, std::vector<Rgbe>& row) {
  int shift = 0;
  Rgbe pixel = first;
  for (std::size_t x = 0; x < row.size();) {
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
      const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
      if (x == 0 || count > row.size() - x)
        reader.fail("expected intact rows, found a damaged one; fetch or export it again");
      for (std::size_t i = 0; i < count; ++i) row[x + i] = row[x - 1];
      x += count;
      constexpr int kByte = 8;
      shift = std::min(shift + kByte, 2 * kByte);
    } else {
      row[x++] = pixel;
      shift = 0;
    }
    if (x < row.size()) pixel = reader.pixel();
  }
}

void read_row(Reader& reader, std::vector<Rgbe>& row) {
  constexpr std::size_t kShortest = 8;  // smallest width that can be run-length coded
  constexpr std::size_t kLongest = 0x7fff;
  const Rgbe first = reader.pixel();
  const std::size_t announced = static_cast<std::size_t>(first[2]) << 8 | first[3];
  const bool coded =
      row.size() >= kShortest && row.size() <= kLongest && first[0] == 2 && first[1] == 2 && first[2] < 128;
  if (!coded) {
    read_flat_row(reader, first, row);
  } else if (announced == row.size()) {
    read_coded_row(reader, row);
  } else {
    reader.fail("expected intact rows, found a damaged one; fetch or export it again");
  }
}

LinearColor to_light(const Rgbe& pixel) {
  if (pixel[3] == 0) return LinearColor::Zero();
  constexpr int kBias = 128 + 8;  // bias of the exponent, and bits of the mantissa
  const float scale = std::ldexp(1.0f, static_cast<int>(pixel[3]) - kBias);
  return scale * LinearColor(pixel[0] + 0.5f, pixel[1] + 0.5f, pixel[2] + 0.5f);
}

}  // namespace

bool looks_like_radiance(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 2 && bytes[0] == '#' && bytes[1] == '?';
}

LinearImage decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name) {
  Reader reader(bytes, name);
  if (!looks_like_radiance(bytes)) reader.fail("expected a Radiance image, found other bytes");
  const Layout layout = read_header(reader);
  check_panorama_size(layout.width, layout.height, name);
  // A row has at least 4 bytes of header and 2 for each run of 127 in four channels. Reject shorter data early.
  constexpr std::size_t kLongestRun = 127;
  const std::size_t runs = (static_cast<std::size_t>(layout.width) + kLongestRun - 1) / kLongestRun;
  const std::size_t least = static_cast<std::size_t>(layout.height) * std::min<std::size_t>(4 + 8 * runs, 8);
  if (reader.left() < least) reader.fail("expected more data, found the end of the file; fetch or export it again");

  LinearImage image(layout.width, layout.height);
  std::vector<Rgbe> row(static_cast<std::size_t>(layout.width));
  for (int i = 0; i < layout.height; ++i) {
    read_row(reader, row);
    const int y = layout.bottom_first ? layout.height - 1 - i : i;
    for (int x = 0; x < layout.width; ++x) {
      image.at(layout.right_first ? layout.width - 1 - x : x, y) = to_light(row[static_cast<std::size_t>(x)]);
    }
  }
  return image;
}

}  // namespace reorient
