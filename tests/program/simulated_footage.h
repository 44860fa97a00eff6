// Footage as somebody else would have recorded it, made with the simulator: PNG images and a table.
#pragma once

#include <filesystem>

namespace reorient {

/// A robot that walks in a circle and looks about, for so many images, five a second: images/NNNN.png and frames.csv in
/// the folder, with the truth as pose. `width` of the images in pixels; `head_pitch` in rad, downwards.
void write_simulated_footage(const std::filesystem::path& folder, int images, int width = 160,
                             double head_pitch = -0.1);

}  // namespace reorient
