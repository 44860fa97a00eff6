// SPDX-License-Identifier: MIT
#include "program/calibrate/footage_images.h"

#include <utility>

#include "perception/field/field_features.h"

namespace reorient {

std::vector<FootageFrame> images_for_calibration(FootageSource& source) {
  constexpr std::size_t kMost = 400;
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;
  std::vector<FootageFrame> frames;
  std::size_t every = 1, images = 0, bytes = 0;
  for (FootageFrame frame; source.next(frame); ++images) {
    if (images % every != 0) continue;
    bytes += frame.image.bytes().size();
    frames.push_back(std::move(frame));
    if (frames.size() < kMost && bytes < kMostBytes) continue;
    for (std::size_t i = 0; 2 * i < frames.size(); ++i) frames[i] = std::move(frames[2 * i]);
    frames.resize((frames.size() + 1) / 2);
    every *= 2;
    bytes = 0;
    for (const FootageFrame& kept : frames) bytes += kept.image.bytes().size();
  }
  return frames;
}

std::vector<EdgeView> edge_views(const std::vector<FootageFrame>& frames) {
  std::vector<EdgeView> views;
  views.reserve(frames.size());
  for (const FootageFrame& frame : frames) {
    views.push_back({frame.camera, frame.robot_from_camera,
                     vertical_edges(frame.image.view(), frame.camera, frame.robot_from_camera, kEdgeReach)});
  }
  return views;
}

std::vector<LineView> line_views(const std::vector<FootageFrame>& frames, const CameraOffset& offset,
                                 const FieldDimensions& field) {
  std::vector<LineView> views;
  views.reserve(frames.size());
  FieldFeatures features({}, field);
  FieldPercept percept;
  for (const FootageFrame& frame : frames) {
    LineView& view = views.emplace_back();
    view.camera = frame.camera;
    view.robot_from_camera = frame.robot_from_camera;
    view.found_from_camera = turned(frame.robot_from_camera, offset);
    features.find(frame.image.view(), view.camera, view.found_from_camera, percept);  // learns the carpet's color
    if (!frame.pose) continue;
    view.robot = *frame.pose;
    view.line_points = percept.line_points;
  }
  return views;
}

}  // namespace reorient
