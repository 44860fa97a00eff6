// SPDX-License-Identifier: MIT
// What has been learned of a room, as it outlasts the day: as a value, and as the bytes of a file.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/camera_bias.h"
#include "geometry/const_or.h"
#include "perception/room/background_model.h"
#include "perception/room/color/color_histogram.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// What gives the numbers of a model their meaning: learned with another wall, or with colours counted otherwise, they
/// say nothing.
struct ModelBasis {
  WallParameters wall;
  ColorParameters color;
  bool light_adaptation = true;  ///< LightParameters::enabled
  bool pose_light = true;        ///< PoseLightParameters::enabled
};
template <typename Visit, ConstOr<ModelBasis> T>
void fields(Visit&& visit, T& basis) {
  visit(basis.wall, basis.color.dark_below, basis.color.bright_above, basis.color.grey_within, basis.color.blur,
        basis.light_adaptation, basis.pose_light);
}

/// The parameters in which two of them differ, with what `wanted` has, as "wall.radius=8 wall.columns=48"; empty where
/// the one's numbers mean what the other's do.
std::string differences(const ModelBasis& given, const ModelBasis& wanted);

/// What is no part of it is what another day changes: the belief, the confidences, and the light of the room, against
/// which the light of each tile is told.
struct SavedModel {
  ModelBasis basis;
  double learned = 0.0;  ///< s for which it was trained
  BackgroundModel model;
  /// How the robot that learned it measures its camera's angles; nothing: that was not known, or not asked.
  std::optional<KnownBias> camera_bias{};

  /// The field's axes turn by half a turn.
  void turn_half() { model.turn_half(Wall(basis.wall)); }
};

/// A model that was learned on another basis than the one on which it should be used.
struct UnfitModel : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// No model takes more bytes than that.
inline constexpr std::size_t kLongestModel = 1 << 20;

/// Appended: magic number, version, length, content, checksum; little-endian, the same on every computer.
void write_model(const SavedModel& model, std::vector<std::byte>& bytes);

/// Throws BadBytes, which says what is wrong with them.
SavedModel read_model(std::span<const std::byte> bytes);

}  // namespace reorient
