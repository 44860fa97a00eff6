// SPDX-License-Identifier: MIT
#include "program/calibrate/look_about.h"

#include <algorithm>
#include <cmath>

#include "perception/field/field_features.h"

namespace reorient {
namespace {

constexpr double kSpeed = 1.0;     // rad/s
constexpr double kThere = 0.03;    // rad
constexpr double kStill = 0.4;     // s at a direction before its images count
constexpr double kPatience = 6.0;  // s for each direction
constexpr int kImages = 4;         // at each direction

/// Both sides, and at each pitches from far away down to the feet.
std::vector<HeadAngles> places(const NeckReach& neck) {
  std::vector<HeadAngles> all;
  for (const double yaw : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (const double pitch : {-0.1, 0.1, 0.3}) all.push_back(neck.clamp({yaw, pitch}));
  }
  return all;
}

void keep(const CameraFrame& frame, const FieldPercept& percept, CalibrationShots& shots) {
  shots.views.push_back({frame.camera, frame.robot_from_camera, percept.line_points});
  if (shots.views.size() > 1 && percept.line_points.size() <= shots.views[shots.pictured].line_points.size()) return;
  shots.pictured = shots.views.size() - 1;
  const ImageView& image = frame.image;
  shots.picture = Image(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.row(y), 2 * static_cast<std::size_t>(image.width), shots.picture.row(y));
}

}  // namespace

std::array<CalibrationShots, 2> look_about(Robot& robot, const RobotBody& body, const FieldDimensions& field) {
  std::array<CalibrationShots, 2> shots;
  std::array<FieldFeatures, 2> features{FieldFeatures({}, field), FieldFeatures({}, field)};
  Observation observation;
  FieldPercept percept;
  for (const HeadAngles& place : places(body.neck)) {
    Answer answer;
    answer.request.head = HeadRequest{place, kSpeed};
    double begun = -1.0, still_since = -1.0;
    for (int taken = 0; taken < kImages;) {
      if (!robot.observe(observation)) return shots;
      robot.answer(answer);
      const double time = observation.time;
      if (begun < 0.0) begun = time;
      const HeadAngles& head = observation.body.head;
      const bool is_there = std::hypot(head.yaw - place.yaw, head.pitch - place.pitch) < kThere;
      const bool stands = observation.reported_posture != ReportedPosture::getting_up;
      if (!stands) begun = time;
      if (!is_there || !stands) still_since = -1.0;
      if (is_there && stands && still_since < 0.0) still_since = time;
      if (time - begun > kPatience) break;
      const bool counts = still_since >= 0.0 && time - still_since > kStill;
      const std::array<const std::optional<CameraFrame>*, 2> frames{&observation.upper, &observation.lower};
      for (std::size_t i = 0; i < frames.size(); ++i) {
        if (!*frames[i]) continue;
        const CameraFrame& frame = **frames[i];
        features[i].find(frame.image, frame.camera, frame.robot_from_camera, percept);  // learns the carpet's color
        if (counts && !percept.line_points.empty()) keep(frame, percept, shots[i]);
      }
      if (counts) ++taken;
    }
  }
  return shots;
}

}  // namespace reorient
