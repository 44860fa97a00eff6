// SPDX-License-Identifier: MIT
#include "workbench/footage/table_footage.h"

#include <utility>

namespace reorient {

CameraModel camera_of(const FootageCamera& camera, int width, int height) {
  CameraOptics optics = camera.optics;
  if (width * optics.height == height * optics.width) return camera_model(optics, width, height);
  // Another aspect ratio: keeps the shape of the pixels; the image is cut or extended above and below.
  const CameraModel own = camera_model(optics, width, width * optics.height / optics.width);
  CameraModel model = own;
  model.height = height;
  model.center.y() += 0.5 * (height - own.height);
  return model;
}

TableFootage::TableFootage(std::string name, std::vector<FrameRow> rows, const FootageCamera& camera,
                           ReadImage read_image)
    : name_(std::move(name)), rows_(std::move(rows)), camera_(camera), read_image_(std::move(read_image)) {}

bool TableFootage::next(FootageFrame& frame) {
  if (next_ == rows_.size()) return false;
  const FrameRow& row = rows_[next_];
  const std::string place = name_ + ":" + std::to_string(row.line) + ": ";
  frame = {};
  if (!read_image_(row, next_, frame.image))
    throw BadFootage(place + "expected an image for each of " + std::to_string(rows_.size()) + " rows, found " +
                     std::to_string(next_));
  if (next_ == 0) {
    width_ = frame.image.width();
    height_ = frame.image.height();
  }
  if (frame.image.width() != width_ || frame.image.height() != height_)
    throw BadFootage(place + "expected an image of " + std::to_string(width_) + "x" + std::to_string(height_) +
                     " pixels, as the first one, found " + std::to_string(frame.image.width()) + "x" +
                     std::to_string(frame.image.height()));
  frame.time = row.value(FrameColumn::time).value_or(static_cast<double>(next_));
  frame.name = row.image.empty() ? std::to_string(next_) : row.image;
  frame.camera = camera_of(camera_, width_, height_);
  frame.robot_from_camera = row.robot_from_camera(camera_.usual_height);
  frame.pose = row.pose();
  frame.odometry = row.odometry();
  frame.heading = row.heading();
  ++next_;
  return true;
}

}  // namespace reorient
