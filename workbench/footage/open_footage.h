// SPDX-License-Identifier: MIT
// Footage from a disk: a folder of images, a video, a log.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "workbench/footage/decoder.h"
#include "workbench/footage/table_footage.h"

namespace reorient {

/// The source, and settings for values that it does not contain.
struct FootageRequest {
  std::filesystem::path source;  ///< a folder of images, a table (.csv), a video or a log (.mcap)
  std::filesystem::path
      table;  ///< CSV; empty: frames.csv in the folder, or the video's name with .csv, if there is one
  ColumnHeaders headers;
  FootageCamera camera;
  bool times_are_given = false;  ///< by the caller, so that images need no times
};

/// Whether the extension is that of an image (JPEG, PNG, ...).
bool is_image_file(const std::filesystem::path& file);
/// The images in a folder, by name. Throws BadFootage if there are none.
std::vector<std::filesystem::path> images_in(const std::filesystem::path& folder);

/// Decodes one image. Throws BadFootage if it is not a regular file, or cannot be decoded.
Image read_image(const std::filesystem::path& file, const FootageDecoder& decoder);

/// The table that open_footage() reads; empty: no table.
std::filesystem::path table_of(const FootageRequest& request);
/// Throws BadFootage with one line.
std::vector<FrameRow> read_table(const std::filesystem::path& table, const ColumnHeaders& headers);
/// Headers of the table that open_footage() does not use. Throws BadFootage with one line.
std::vector<std::string> unused_columns(const FootageRequest& request);

/// Throws BadFootage with one line.
std::unique_ptr<FootageSource> open_footage(const FootageRequest& request, const FootageDecoder& decoder);

}  // namespace reorient
