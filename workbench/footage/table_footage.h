// SPDX-License-Identifier: MIT
// Footage of a table (robots/footage/frames_table.h) and of the images that belong to its rows.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "robots/footage/frames_table.h"
#include "robots/robot_body.h"

namespace reorient {

/// The camera of a footage, for values that the table does not contain.
struct FootageCamera {
  CameraOptics optics;  ///< fields of view for images of this aspect ratio; for others, the horizontal one is used
  double usual_height = 0.5;  ///< m above the ground
};
/// The camera at the resolution of an image.
CameraModel camera_of(const FootageCamera& camera, int width, int height);

class TableFootage : public FootageSource {
 public:
  /// Called for each row in order. False: no image is left. Throws BadFootage.
  using ReadImage = std::function<bool(const FrameRow& row, std::size_t index, Image& image)>;

  /// `name`: of the table, for messages. Rows without times are a second apart: the caller then gives images per
  /// second.
  TableFootage(std::string name, std::vector<FrameRow> rows, const FootageCamera& camera, ReadImage read_image);

  bool next(FootageFrame& frame) override;

 private:
  std::string name_;
  std::vector<FrameRow> rows_;
  FootageCamera camera_;
  ReadImage read_image_;
  std::size_t next_ = 0;
  int width_ = 0, height_ = 0;  ///< of the first image
};

}  // namespace reorient
