// Footage from a disk, whatever it is: a folder of images, a video, a log.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "workbench/footage/decoder.h"
#include "workbench/footage/table_footage.h"

namespace reorient {

/// What is read, and what a person has to say where it does not say so itself.
struct FootageRequest {
  std::filesystem::path source;  ///< a folder of images, a table (.csv), a video or a log (.mcap)
  std::filesystem::path
      table;  ///< CSV; empty: frames.csv in the folder, or the video's name with .csv, if there is one
  ColumnHeaders headers;
  FootageCamera camera;
  bool times_are_given = false;  ///< by somebody else: images without times will do
};

/// Throws BadFootage with one line.
std::unique_ptr<FootageSource> open_footage(const FootageRequest& request, const FootageDecoder& decoder);

}  // namespace reorient
