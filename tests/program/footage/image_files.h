// SPDX-License-Identifier: MIT
// Images as files of other kinds, for tests. Built only if OpenCV's imgcodecs and videoio are available.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace reorient {

/// FFV1 in Matroska, which is lossless; five frames a second. False: it cannot be written here.
bool write_lossless_video(const std::vector<std::filesystem::path>& images, const std::filesystem::path& video);

/// An image as a file of another kind: ".png", ".jpg". Empty: it cannot be written here.
std::vector<std::byte> encoded(const std::filesystem::path& image, const std::string& extension);

}  // namespace reorient
