// SPDX-License-Identifier: MIT
// Models of invented rooms, and their bytes with accidental or deliberate damage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/bytes.h"
#include "geometry/random.h"
#include "perception/room/saved_model.h"

namespace reorient::test {

using ModelBytes = std::vector<std::byte>;

/// The same seed gives the same room. `day` and `noise` vary its colors: `noise` is the fraction of a tile's colors
/// that depends on the day. Only the columns first...first + count - 1 are trained.
inline SavedModel some_model(std::uint64_t seed, std::uint64_t day = 0, double noise = 0.1, int first = 0,
                             int count = 48) {
  SavedModel model;
  model.learned = 40.0;
  const Wall wall(model.basis.wall);
  std::vector<TileModel> tiles(static_cast<std::size_t>(wall.tiles()));
  Random room(seed, 1), other(seed, 2 + day);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    TileModel tile;
    ColorCounts counts{};
    for (std::uint32_t& pixels : counts) {
      const double colors = room.uniform() < 0.25 ? 1000.0 : 0.0;  // a few colors in each
      pixels = static_cast<std::uint32_t>((1.0 - noise) * colors + noise * 1000.0 * other.uniform());
    }
    counts[0] += 1;
    tile.mean = normalized(counts);
    tile.variance.fill(0.01f);
    tile.visits = 100 + static_cast<int>(room.below(200));
    tile.trained = tile.visits / 30.0;
    tile.light = {room.uniform(0.5, 1.5), room.uniform(-10.0, 10.0), room.uniform(-10.0, 10.0)};
    tile.light_visits = tile.visits;
    const int column = (wall.column_of(static_cast<int>(i)) - first + wall.columns()) % wall.columns();
    if (column < count) tiles[i] = tile;
  }
  model.model = BackgroundModel(std::move(tiles));
  return model;
}

inline ModelBytes bytes_of(const SavedModel& model) {
  ModelBytes bytes;
  write_model(model, bytes);
  return bytes;
}

/// Offsets of values in the bytes of a model.
enum ModelOffset : std::size_t {
  kVersionAt = 8,
  kSizeAt = 12,
  kRadiusAt = 16,
  kBottomAt = 24,
  kTopAt = 32,
  kRowsAt = 40,
  kColumnsAt = 44,
  kDarkBelowAt = 48,
  kPoseLightAt = 81,
  kLearnedAt = 82,
  kTilesAt = 90,
  kMeanAt = 94,
  kVarianceAt = 150,
  kVisitsAt = 206,
  kTrainedAt = 210,
  kLumaAt = 218,
  kCbAt = 226,
  kLightVisitsAt = 242,
};

template <typename T>
ModelBytes with(ModelBytes bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(value));
  return bytes;
}

/// The same bytes with a correct checksum.
inline ModelBytes with_checksum(ModelBytes bytes) {
  std::uint64_t sum = 0xCBF29CE484222325ull;
  const std::size_t end = bytes.size() - sizeof(sum);
  for (std::size_t i = 0; i < end; ++i) sum = (sum ^ static_cast<std::uint64_t>(bytes[i])) * 0x100000001B3ull;
  return with(std::move(bytes), end, sum);
}

struct DamagedModel {
  std::string what;
  ModelBytes bytes;
  std::string complaint;  ///< a part of the error
};

inline std::vector<DamagedModel> damaged_models() {
  const ModelBytes good = bytes_of(some_model(1));
  std::vector<DamagedModel> all;
  const auto cut = [&](std::size_t size, const char* reason) {
    all.push_back({"cut to " + std::to_string(size), {good.begin(), good.begin() + static_cast<long>(size)}, reason});
  };
  cut(0, "it is empty");
  for (const std::size_t size : {1u, 4u, 7u}) cut(size, "it is not a model of a room");
  for (const std::size_t size : {8u, 11u, 12u, 15u, 16u, 23u}) cut(size, "it is truncated");
  for (const std::size_t size : {24u, 47u, 93u, 94u, 246u}) cut(size, "it is truncated");
  cut(good.size() / 2, "it is truncated");
  cut(good.size() - 8, "it is truncated");
  cut(good.size() - 1, "it is truncated");

  const auto flip = [&](const char* what, std::size_t offset, const char* reason) {
    all.push_back(
        {std::string("a bit flipped in ") + what, with(good, offset, good[offset] ^ std::byte{0x10}), reason});
  };
  flip("the magic number", 0, "it is not a model of a room");
  flip("the last byte of the magic number", 7, "it is not a model of a room");
  flip("the version", kVersionAt, "newer version");
  flip("the size", kSizeAt, "too long");
  flip("the wall", kRadiusAt + 3, "checksum");
  flip("a color", kMeanAt + 1, "checksum");
  flip("the last tile", good.size() - 20, "checksum");
  flip("the checksum", good.size() - 3, "checksum");

  const auto foreign = [&](const char* what, const std::string& text) {
    ModelBytes bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    all.push_back({what, std::move(bytes), "it is not a model of a room"});
  };
  foreign("a picture", "\x89PNG\r\n\x1A\n and so on");
  foreign("a parameter file", "[wall]\nradius = 9.0\n");
  foreign("a script", "behavior \"orientation\" {}\n");
  foreign("zeros only", std::string(good.size(), '\0'));
  foreign("ones only", std::string(good.size(), '\xFF'));
  foreign("one letter", "x");

  ModelBytes longer = good;
  longer.push_back(std::byte{0});
  all.push_back({"a byte added", longer, "too long"});
  ModelBytes twice = good;
  for (std::size_t i = 0, size = good.size(); i < size; ++i) twice.push_back(good[i]);
  all.push_back({"written twice", twice, "too long"});
  ModelBytes swapped = good;
  for (std::size_t i = 0; i < 152; ++i) std::swap(swapped[kMeanAt + i], swapped[kMeanAt + 152 + i]);
  all.push_back({"two tiles swapped", swapped, "checksum"});

  const auto forge = [&](const char* what, std::size_t offset, auto value, const char* reason) {
    all.push_back({what, with_checksum(with(good, offset, value)), reason});
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinite = std::numeric_limits<double>::infinity();
  constexpr auto kMost = std::numeric_limits<std::uint32_t>::max();
  forge("another version", kVersionAt, std::uint32_t{3}, "newer version of this program: format 3");
  forge("a version far ahead", kVersionAt, kMost, "newer version");
  forge("a version before the first", kVersionAt, std::uint32_t{0}, "unknown format");
  forge("a zero size", kSizeAt, std::uint32_t{0}, "too long");
  forge("a size larger than memory", kSizeAt, kMost, "too long");
  forge("a radius that is not a number", kRadiusAt, kNan, "a parameter is invalid");
  forge("an infinite radius", kRadiusAt, kInfinite, "a parameter is invalid");
  forge("a zero radius", kRadiusAt, 0.0, "a parameter is invalid");
  forge("a negative radius", kRadiusAt, -8.0, "a parameter is invalid");
  forge("a wall with its top below its bottom", kTopAt, 0.5, "the wall is invalid");
  forge("no rows", kRowsAt, 0, "a parameter is invalid");
  forge("too many rows", kRowsAt, std::numeric_limits<int>::max(), "a parameter is invalid");
  forge("a negative number of rows", kRowsAt, -4, "a parameter is invalid");
  forge("an odd number of columns", kColumnsAt, 47, "the wall is invalid");
  forge("fewer columns than tiles", kColumnsAt, 46, "expected one entry for each tile");
  forge("a color threshold that is not a number", kDarkBelowAt, kNan, "a parameter is invalid");
  forge("a flag that is neither 0 nor 1", kPoseLightAt, std::uint8_t{7}, "invalid value 7 (expected 0 to 1)");
  forge("a time that is not a number", kLearnedAt, kNan, "the training time is invalid");
  forge("a negative time", kLearnedAt, -1.0, "the training time is invalid");
  forge("an infinite time", kLearnedAt, kInfinite, "the training time is invalid");
  forge("no tiles", kTilesAt, std::uint32_t{0}, "expected one entry for each tile");
  forge("one tile too few", kTilesAt, std::uint32_t{191}, "expected one entry for each tile");
  forge("one tile too many", kTilesAt, std::uint32_t{193}, "too early");
  forge("more tiles than memory", kTilesAt, kMost, "does not fit");
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  forge("a mean that is not a number", kMeanAt, not_a_number, "a tile has an invalid value");
  forge("a mean of 2", kMeanAt, 2.0f, "a tile has an invalid value");
  forge("a negative mean", kMeanAt, -0.5f, "a tile has an invalid value");
  forge("means with a sum above 1", kMeanAt, 1.0f, "a tile has an invalid value");
  forge("a variance that is not a number", kVarianceAt, not_a_number, "a tile has an invalid value");
  forge("a negative variance", kVarianceAt, -0.01f, "a tile has an invalid value");
  forge("a negative number of visits", kVisitsAt, -1, "a tile has an invalid value");
  forge("a training time that is not a number", kTrainedAt, kNan, "a tile has an invalid value");
  forge("a negative training time", kTrainedAt, -3.0, "a tile has an invalid value");
  forge("an infinite luma", kLumaAt, kInfinite, "a tile has an invalid value");
  forge("a negative luma", kLumaAt, -1.0, "a tile has an invalid value");
  forge("a chroma beyond the range of a byte", kCbAt, 1e300, "a tile has an invalid value");
  forge("a negative number of visits with light", kLightVisitsAt, -7, "a tile has an invalid value");
  return all;
}

}  // namespace reorient::test
