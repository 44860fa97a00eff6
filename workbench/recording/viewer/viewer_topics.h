// SPDX-License-Identifier: MIT
// What a recording holds for people to look at, one row a topic: messages in JSON, which Foxglove, Lichtblick and
// PlotJuggler open without being told how. The one table that recordings, live views and docs name them by.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace reorient {

enum class ViewerTopic {
  transforms,
  pose,
  pose_particles,
  truth,
  field,
  wall,
  percepts,
  upper_image,
  upper_calibration,
  upper_annotations,
  lower_image,
  lower_calibration,
  lower_annotations,
  world,
  machines,
  events,
  request,
  log,
  costs,
  parameters
};
inline constexpr int kViewerTopicCount = 20;

struct ViewerTopicInfo {
  ViewerTopic topic;
  std::string_view name;
  std::string_view schema;
  std::string_view description;
  bool lasts = false;  ///< a message holds until the next one: whoever begins in the middle needs the one before
};

inline constexpr std::array<ViewerTopicInfo, kViewerTopicCount> kViewerTopics{{
    {ViewerTopic::transforms, "/tf", "foxglove.FrameTransforms",
     "where the robot believes to be in the frame `field`, and really is (`truth`), and its cameras"},
    {ViewerTopic::pose, "/belief/pose", "foxglove.PoseInFrame", "the believed pose"},
    {ViewerTopic::pose_particles, "/belief/particles", "foxglove.PosesInFrame",
     "the pose filter's particles, five times a second"},
    {ViewerTopic::truth, "/truth/pose", "foxglove.PoseInFrame", "where the robot really is, if it is known"},
    {ViewerTopic::field, "/field", "foxglove.SceneUpdate", "lines and goals", true},
    {ViewerTopic::wall, "/wall", "foxglove.SceneUpdate",
     "the background model's tiles in their mean color, once a second; rods on the ground: the belief of the view",
     true},
    {ViewerTopic::percepts, "/percepts", "foxglove.SceneUpdate", "what was seen of the field, on the ground"},
    {ViewerTopic::upper_image, "/camera/upper/image", "foxglove.CompressedImage", "a JPEG, not what is replayed"},
    {ViewerTopic::upper_calibration, "/camera/upper/calibration", "foxglove.CameraCalibration", "its camera", true},
    {ViewerTopic::upper_annotations, "/camera/upper/annotations", "foxglove.ImageAnnotations",
     "what was seen of the field, and its lines as believed, in the image"},
    {ViewerTopic::lower_image, "/camera/lower/image", "foxglove.CompressedImage", "the same, of the lower camera"},
    {ViewerTopic::lower_calibration, "/camera/lower/calibration", "foxglove.CameraCalibration", "the same", true},
    {ViewerTopic::lower_annotations, "/camera/lower/annotations", "foxglove.ImageAnnotations", "the same"},
    {ViewerTopic::world, "/world", "reorient.World", "what behaviors see: pose, confidences, evidence, posture, game"},
    {ViewerTopic::machines, "/machines", "reorient.Machines", "each machine and its state; flags that are published"},
    {ViewerTopic::events, "/events", "reorient.Event", "a change of state or a command, with its reason and verdict"},
    {ViewerTopic::request, "/request", "reorient.Request", "what the robot was asked for"},
    {ViewerTopic::log, "/log", "foxglove.Log",
     "log lines and notes; faults and edits of scripts; parameters that were changed"},
    {ViewerTopic::costs, "/costs", "reorient.Costs", "how long each stage took, and what each script costs"},
    {ViewerTopic::parameters, "/parameters", "reorient.Parameters", "every parameter and its value", true},
}};

constexpr const ViewerTopicInfo& info(ViewerTopic topic) { return kViewerTopics[static_cast<std::size_t>(topic)]; }

/// How the messages of a schema look: JSON Schema, as text. Throws std::out_of_range where there is no such schema.
std::string schema_text(std::string_view schema);

}  // namespace reorient
