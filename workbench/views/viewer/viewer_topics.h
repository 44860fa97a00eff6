// SPDX-License-Identifier: MIT
// The topics of a recording for viewers, one row for each topic: messages in JSON, which Foxglove, Lichtblick and
// PlotJuggler open without configuration. Recordings, live views and docs use this table.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace reorient {

struct ApplicationInterface;

enum class ViewerTopic {
  transforms,
  pose,
  pose_particles,
  truth,
  field,
  wall,
  room,
  percepts,
  upper_image,
  upper_calibration,
  upper_annotations,
  lower_image,
  lower_calibration,
  lower_annotations,
  world,
  machines,
  conditions,
  events,
  request,
  log,
  costs,
  parameters,
  decision,
  view
};
inline constexpr int kViewerTopicCount = 24;

struct ViewerTopicInfo {
  ViewerTopic topic;
  std::string_view name;
  std::string_view schema;
  std::string_view description;
  bool lasts = false;  ///< a message is valid until the next one, so a reader that starts in between needs it
};

inline constexpr std::array<ViewerTopicInfo, kViewerTopicCount> kViewerTopics{{
    {ViewerTopic::transforms, "/tf", "foxglove.FrameTransforms",
     "believed pose of the robot in the frame `field`, its true pose (`truth`), and its cameras"},
    {ViewerTopic::pose, "/belief/pose", "foxglove.PoseInFrame", "the believed pose"},
    {ViewerTopic::pose_particles, "/belief/particles", "foxglove.PosesInFrame",
     "particles of the pose filter, five times a second"},
    {ViewerTopic::truth, "/truth/pose", "foxglove.PoseInFrame", "the true pose, if it is known"},
    {ViewerTopic::field, "/field", "foxglove.SceneUpdate", "lines and goals", true},
    {ViewerTopic::wall, "/wall", "foxglove.SceneUpdate",
     "tiles of the background model in their mean color, once a second; in live views only if a color has changed",
     true},
    {ViewerTopic::room, "/room", "reorient.Room",
     "evidence of each tile of the wall, fit of the tiles in view, estimated view, five times a second", true},
    {ViewerTopic::percepts, "/percepts", "foxglove.SceneUpdate",
     "detected features of the field, on the ground; translucent: rejected at the believed pose"},
    {ViewerTopic::upper_image, "/camera/upper/image", "foxglove.CompressedImage",
     "a JPEG of the upper camera, not used by replay"},
    {ViewerTopic::upper_calibration, "/camera/upper/calibration", "foxglove.CameraCalibration",
     "calibration of the upper camera", true},
    {ViewerTopic::upper_annotations, "/camera/upper/annotations", "foxglove.ImageAnnotations",
     "detected features of the field, and its lines at the believed pose, in the image"},
    {ViewerTopic::lower_image, "/camera/lower/image", "foxglove.CompressedImage",
     "a JPEG of the lower camera, not used by replay"},
    {ViewerTopic::lower_calibration, "/camera/lower/calibration", "foxglove.CameraCalibration",
     "calibration of the lower camera", true},
    {ViewerTopic::lower_annotations, "/camera/lower/annotations", "foxglove.ImageAnnotations",
     "the same as /camera/upper/annotations, of the lower camera"},
    {ViewerTopic::world, "/world", "reorient.World",
     "world fields that behaviors read: pose, confidences, evidence, posture, game"},
    {ViewerTopic::machines, "/machines", "reorient.Machines",
     "state of each state machine, also of the scenario, and the parts of the body that it requests; published flags"},
    {ViewerTopic::conditions, "/conditions", "reorient.Conditions",
     "possible transitions of each state machine, and how long their conditions have held; in recordings five times a "
     "second"},
    {ViewerTopic::events, "/events", "reorient.Event", "a change of state or a command, with its reason and verdict"},
    {ViewerTopic::request, "/request", "reorient.Request", "requests of the behaviors to the robot"},
    {ViewerTopic::log, "/log", "foxglove.Log",
     "log lines and notes; faults and edits of scripts; changes of parameters"},
    {ViewerTopic::costs, "/costs", "reorient.Costs", "duration of each stage, and cost of each script"},
    {ViewerTopic::parameters, "/parameters", "reorient.Parameters", "every parameter and its value", true},
    {ViewerTopic::decision, "/decision", "reorient.Decision",
     "evidence at which the shipped behaviors decide, in log-odds", true},
    {ViewerTopic::view, "/view", "foxglove.SceneUpdate",
     "vertical rods near the wall that show the estimated view, five times a second", true},
}};

/// Some of the topics.
using ViewerTopics = std::bitset<kViewerTopicCount>;

/// Topics of which no message may be left out, because each is about another moment.
inline ViewerTopics moment_topics() {
  ViewerTopics topics;
  return topics.set(static_cast<std::size_t>(ViewerTopic::events)).set(static_cast<std::size_t>(ViewerTopic::log));
}

/// Frames between two messages of topics that change slowly or are large.
inline constexpr std::uint64_t kParticlesEvery = 6, kRoomEvery = 6, kWallEvery = 30, kParametersEvery = 300;
/// The same, of recordings only.
inline constexpr std::uint64_t kConditionsEvery = 6;

constexpr const ViewerTopicInfo& info(ViewerTopic topic) { return kViewerTopics[static_cast<std::size_t>(topic)]; }

/// The format of the messages of a schema as JSON Schema text. Throws std::out_of_range for an unknown schema.
/// `application`: its values and actions are in the schema of the world.
std::string schema_text(std::string_view schema, const ApplicationInterface& application);
/// The same without an application.
std::string schema_text(std::string_view schema);

}  // namespace reorient
