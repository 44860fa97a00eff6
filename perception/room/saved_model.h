// SPDX-License-Identifier: MIT
// A model of a room that is saved for later days: as a value, and as the bytes of a file.
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

/// The parameters that define the meaning of a model's numbers. With another wall, or with colors counted differently,
/// the numbers have no meaning.
struct ModelBasis {
  WallParameters wall;
  ColorParameters color;
  bool light_adaptation = true;  ///< LightParameters::enabled
  bool pose_light = true;        ///< PoseLightParameters::enabled
};
template <typename Visit, ConstOr<ModelBasis> T>
void fields(Visit&& visit, T& basis) {
  visit(basis.wall, basis.color.dark_below, basis.color.bright_above, basis.color.gray_within, basis.color.blur,
        basis.light_adaptation, basis.pose_light);
}

/// The parameters in which two bases differ, with the values of `expected`, as "wall.radius=8 wall.columns=48". Empty
/// if the numbers of both have the same meaning.
std::string differences(const ModelBasis& given, const ModelBasis& expected);

/// Does not contain what differs on another day: the belief, the confidences, and the light of the room, relative to
/// which the light of each tile is stored.
struct SavedModel {
  ModelBasis basis;
  double learned = 0.0;  ///< s, training time
  BackgroundModel model;
  /// Errors of the camera angles of the robot that learned the model. Empty if they were unknown or not requested.
  std::optional<KnownBias> camera_bias{};

  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees() { model.rotate_by_180_degrees(Wall(basis.wall)); }
};

/// The error for a model that was learned on another basis than the required one.
struct UnfitModel : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Largest size of a model, bytes.
inline constexpr std::size_t kLongestModel = 1 << 20;

/// Appends magic number, version, length, content, checksum. Little-endian, the same on every computer.
void write_model(const SavedModel& model, std::vector<std::byte>& bytes);

/// Throws BadBytes with the reason.
SavedModel read_model(std::span<const std::byte> bytes);

}  // namespace reorient
