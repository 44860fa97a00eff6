// SPDX-License-Identifier: MIT
// Models of rooms that nobody has seen, and their bytes as a bad disk, a bad cable or a bad person leaves them.
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

/// The same seed is the same room; `noise` is another day: how far the colours of a tile are from those of the room, as
/// a share. Only columns first...first + count - 1 were looked at.
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
      const double colors = room.uniform() < 0.25 ? 1000.0 : 0.0;  // a few colours in each
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

/// Where things lie in the bytes of a model.
enum ModelPlace : std::size_t {
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
ModelBytes with(ModelBytes bytes, std::size_t place, T value) {
  std::memcpy(bytes.data() + place, &value, sizeof(value));
  return bytes;
}

/// With the checksum that its bytes should have.
inline ModelBytes signed_anew(ModelBytes bytes) {
  std::uint64_t sum = 0xCBF29CE484222325ull;
  const std::size_t end = bytes.size() - sizeof(sum);
  for (std::size_t i = 0; i < end; ++i) sum = (sum ^ static_cast<std::uint64_t>(bytes[i])) * 0x100000001B3ull;
  return with(std::move(bytes), end, sum);
}

struct DamagedModel {
  std::string what;
  ModelBytes bytes;
  std::string complaint;  ///< what the refusal says, among other words
};

inline std::vector<DamagedModel> damaged_models() {
  const ModelBytes good = bytes_of(some_model(1));
  std::vector<DamagedModel> all;
  const auto cut = [&](std::size_t size, const char* complaint) {
    all.push_back(
        {"cut to " + std::to_string(size), {good.begin(), good.begin() + static_cast<long>(size)}, complaint});
  };
  cut(0, "it is empty");
  for (const std::size_t size : {1u, 4u, 7u}) cut(size, "it is no model of a room");
  for (const std::size_t size : {8u, 11u, 12u, 15u, 16u, 23u}) cut(size, "it is cut short");
  for (const std::size_t size : {24u, 47u, 93u, 94u, 246u}) cut(size, "it is cut short");
  cut(good.size() / 2, "it is cut short");
  cut(good.size() - 8, "it is cut short");
  cut(good.size() - 1, "it is cut short");

  const auto flip = [&](const char* what, std::size_t place, const char* complaint) {
    all.push_back(
        {std::string("a bit flipped in ") + what, with(good, place, good[place] ^ std::byte{0x10}), complaint});
  };
  flip("the magic number", 0, "it is no model of a room");
  flip("the end of the magic number", 7, "it is no model of a room");
  flip("the version", kVersionAt, "newer version");
  flip("the size", kSizeAt, "bytes instead of");
  flip("the wall", kRadiusAt + 3, "checksum");
  flip("a colour", kMeanAt + 1, "checksum");
  flip("the last tile", good.size() - 20, "checksum");
  flip("the checksum", good.size() - 3, "checksum");

  const auto foreign = [&](const char* what, const std::string& text) {
    ModelBytes bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    all.push_back({what, std::move(bytes), "it is no model of a room"});
  };
  foreign("a picture", "\x89PNG\r\n\x1A\n and so on");
  foreign("a parameter file", "[wall]\nradius = 9.0\n");
  foreign("a script", "behavior \"orientation\" {}\n");
  foreign("a disk's zeros", std::string(good.size(), '\0'));
  foreign("a worn-out disk's ones", std::string(good.size(), '\xFF'));
  foreign("one letter", "x");

  ModelBytes longer = good;
  longer.push_back(std::byte{0});
  all.push_back({"a byte added", longer, "bytes instead of"});
  ModelBytes twice = good;
  for (std::size_t i = 0, size = good.size(); i < size; ++i) twice.push_back(good[i]);
  all.push_back({"written twice", twice, "bytes instead of"});
  ModelBytes swapped = good;
  for (std::size_t i = 0; i < 152; ++i) std::swap(swapped[kMeanAt + i], swapped[kMeanAt + 152 + i]);
  all.push_back({"two tiles swapped", swapped, "checksum"});

  const auto lie = [&](const char* what, std::size_t place, auto value, const char* complaint) {
    all.push_back({what, signed_anew(with(good, place, value)), complaint});
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinite = std::numeric_limits<double>::infinity();
  constexpr auto kMost = std::numeric_limits<std::uint32_t>::max();
  lie("another version", kVersionAt, std::uint32_t{3}, "newer version of this program: format 3");
  lie("a version far ahead", kVersionAt, kMost, "newer version");
  lie("a version before the first", kVersionAt, std::uint32_t{0}, "there never was such a format");
  lie("a size of nothing", kSizeAt, std::uint32_t{0}, "bytes instead of");
  lie("a size beyond all memory", kSizeAt, kMost, "bytes instead of");
  lie("a radius that is none", kRadiusAt, kNan, "a parameter is none");
  lie("an endless radius", kRadiusAt, kInfinite, "a parameter is none");
  lie("a radius of nothing", kRadiusAt, 0.0, "a parameter is none");
  lie("a radius below nothing", kRadiusAt, -8.0, "a parameter is none");
  lie("a wall that ends before it begins", kTopAt, 0.5, "its wall is none");
  lie("no rows", kRowsAt, 0, "a parameter is none");
  lie("rows without end", kRowsAt, std::numeric_limits<int>::max(), "a parameter is none");
  lie("rows below nothing", kRowsAt, -4, "a parameter is none");
  lie("an odd number of columns", kColumnsAt, 47, "its wall is none");
  lie("fewer columns than tiles", kColumnsAt, 46, "another number of tiles");
  lie("a colour threshold that is none", kDarkBelowAt, kNan, "a parameter is none");
  lie("a flag that is neither on nor off", kPoseLightAt, std::uint8_t{7}, "none of those that it can be");
  lie("a time that is none", kLearnedAt, kNan, "a time is none");
  lie("a time below nothing", kLearnedAt, -1.0, "a time is none");
  lie("a time without end", kLearnedAt, kInfinite, "a time is none");
  lie("no tiles", kTilesAt, std::uint32_t{0}, "another number of tiles");
  lie("a tile too few", kTilesAt, std::uint32_t{191}, "another number of tiles");
  lie("a tile too many", kTilesAt, std::uint32_t{193}, "too early");
  lie("tiles beyond all memory", kTilesAt, kMost, "longer than its bytes");
  const float no_share = std::numeric_limits<float>::quiet_NaN();
  lie("a share that is none", kMeanAt, no_share, "a tile of the model is none");
  lie("a share of two", kMeanAt, 2.0f, "a tile of the model is none");
  lie("a share below nothing", kMeanAt, -0.5f, "a tile of the model is none");
  lie("shares that are more than all", kMeanAt, 1.0f, "a tile of the model is none");
  lie("a variance that is none", kVarianceAt, no_share, "a tile of the model is none");
  lie("a variance below nothing", kVarianceAt, -0.01f, "a tile of the model is none");
  lie("fewer visits than none", kVisitsAt, -1, "a tile of the model is none");
  lie("training that is no time", kTrainedAt, kNan, "a tile of the model is none");
  lie("training before it began", kTrainedAt, -3.0, "a tile of the model is none");
  lie("light that is none", kLumaAt, kInfinite, "a tile of the model is none");
  lie("light below nothing", kLumaAt, -1.0, "a tile of the model is none");
  lie("a chroma beyond a byte", kCbAt, 1e300, "a tile of the model is none");
  lie("fewer looks at the light than none", kLightVisitsAt, -7, "a tile of the model is none");
  return all;
}

}  // namespace reorient::test
