// SPDX-License-Identifier: MIT
// The input images of `reorient look`, with the known values of each.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "program/run/footage_arguments.h"
#include "robots/footage/footage.h"
#include "robots/robot_body.h"

namespace reorient {

struct LookImage {
  std::string file;              ///< the image, or the file that contains it
  FootageFrame frame;            ///< with the name of the image in the file
  bool pitch_is_known = false;   ///< recorded; else the frame's pitch is 0
  bool roll_is_known = false;    ///< recorded; else 0
  bool height_is_known = false;  ///< recorded; else the body's
};

class LookSource {
 public:
  virtual ~LookSource() = default;
  /// False at the end of the images. Throws BadFootage with one line.
  virtual bool next(LookImage& image) = 0;
};

/// Several image files, or one folder, table, video, log or recording. Images of a folder without a table may be of
/// different sizes. Throws BadFootage with one line.
std::unique_ptr<LookSource> open_look_source(const std::vector<std::filesystem::path>& sources,
                                             FootageArguments arguments, const RobotBody& body);

}  // namespace reorient
