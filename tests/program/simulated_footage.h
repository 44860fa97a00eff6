// Footage as somebody else would have recorded it, made with the simulator: PNG images and a table.
#pragma once

#include <filesystem>

namespace reorient {

/// A robot that walks in a circle and looks about, for so many images, five a second: images/NNNN.png and frames.csv in
/// the folder. Images of 160x120 pixels, the truth as pose.
void write_simulated_footage(const std::filesystem::path& folder, int images);

}  // namespace reorient
