#include "workbench/footage/table_footage.h"

#include <utility>

#include "geometry/pinned_math.h"

namespace reorient {

CameraModel camera_of(const FootageCamera& camera, int width, int height) {
  const CameraOptics& optics = camera.optics;
  const double half = pinned::tan(0.5 * optics.field_of_view_horizontal);
  // Square pixels, where the image has another shape than the camera's own.
  const bool same_shape = width * optics.height == height * optics.width;
  const double vertical = same_shape ? optics.field_of_view_vertical : 2.0 * pinned::atan2(half * height, 1.0 * width);
  CameraModel model = CameraModel::from_fields_of_view(width, height, optics.field_of_view_horizontal, vertical);
  model.k1 = optics.k1;
  model.k2 = optics.k2;
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
