// SPDX-License-Identifier: MIT
// Footage of the simulator in the form of recorded footage: PNG images and a table.
#pragma once

#include <cstdint>
#include <filesystem>

#include "geometry/camera_offset.h"

namespace reorient {

/// As a PNG.
void write_image(const std::filesystem::path& file, const ImageView& image);

/// Footage whose camera offset is not in the table.
struct OffsetFootageOptions {
  int images = 100;        ///< five a second
  int width = 320;         ///< pixels
  std::uint64_t seed = 1;  ///< of all noise, of the start and of the walk
  CameraOffset offset;     ///< the true camera pose is turned(recorded, offset)
};
/// A robot that walks and looks around. The simulated body measures its camera pose without error, so that the offset
/// is the only difference. The pose is that of the point below the camera, since the table has no other position.
void write_offset_footage(const std::filesystem::path& folder, const OffsetFootageOptions& options);

/// A robot that walks in a circle and looks around, for this number of images, five a second: images/NNNN.png and
/// frames.csv in the folder, with the truth as pose. `width` of the images in pixels; `head_pitch` in rad, downwards;
/// `lens_blur` in rad, its standard deviation.
void write_simulated_footage(const std::filesystem::path& folder, int images, int width = 160, double head_pitch = -0.1,
                             double lens_blur = 0.0);

}  // namespace reorient
