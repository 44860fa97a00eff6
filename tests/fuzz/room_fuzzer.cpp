// SPDX-License-Identifier: MIT
// Arbitrary bytes as the panorama of a room (Radiance, PNG or JPEG): refused with one line that names the file, or read
// as a picture of limited size with finite light. Some of them are converted to rooms.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <zlib.h>

#include "robots/simulator/room/panorama.h"
#include "robots/simulator/room/room.h"
#include "tests/fuzz/promises.h"

namespace reorient {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Only small pictures, because building a room takes a thousand times longer than reading its picture.
bool is_chosen(Bytes bytes) { return crc32(0, bytes.data(), static_cast<uInt>(bytes.size())) % 512 == 0; }

void try_panorama(Bytes bytes) {
  const Haste haste(10.0);
  LinearImage image;
  try {
    image = decode_panorama(bytes, "hall.hdr");
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("panorama 'hall.hdr': "), "a refusal names the file");
    return;
  }
  require(image.width <= 8192 && image.height <= 4096, "a picture fits into memory");
  require(image.pixels.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
          "a picture has all pixels");
  for (const LinearColor& color : image.pixels)
    require(color.isFinite().all() && color.minCoeff() >= 0.0f, "light is finite and non-negative");
  if (!is_chosen(bytes)) return;
  RoomShape small;
  small.length = 11.0;
  small.width = 8.0;
  small.height = 2.5;
  const Room room = room_from(std::move(image), "hall.hdr", small);
  require(room.light.isFinite().all(), "the light on the field is finite");
}

/// Corrects the checksum of each chunk of a PNG, because mutations would never match it.
void correct_checksums(std::span<std::uint8_t> png) {
  constexpr std::size_t kSignature = 8, kWord = 4;
  const auto word = [png](std::size_t at) {
    return std::uint32_t{png[at]} << 24 | std::uint32_t{png[at + 1]} << 16 | std::uint32_t{png[at + 2]} << 8 |
           png[at + 3];
  };
  for (std::size_t at = kSignature; at + 3 * kWord <= png.size();) {
    const std::size_t length = word(at);
    if (length > png.size() - at - 3 * kWord) return;
    const std::size_t end = at + 2 * kWord + length;
    const auto sum = static_cast<std::uint32_t>(crc32(0, png.data() + at + kWord, static_cast<uInt>(kWord + length)));
    for (std::size_t i = 0; i < kWord; ++i) png[end + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at = end + kWord;
  }
}

}  // namespace
}  // namespace reorient

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t longest);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t longest,
                                               unsigned int /*seed*/) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, longest);
  if (mutated > 8 && std::equal(data, data + 4, "\x89PNG")) reorient::correct_checksums({data, mutated});
  return mutated;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_panorama({data, size});
  return 0;
}
