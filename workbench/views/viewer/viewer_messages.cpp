// SPDX-License-Identifier: MIT
#include "workbench/views/viewer/viewer_messages.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/script/language/world_fields.h"
#include "workbench/run/application_values.h"
#include "workbench/run/decision_threshold.h"
#include "workbench/run/log_lines.h"
#include "workbench/run/timeline.h"
#include "workbench/views/scene/camera_overlay.h"
#include "workbench/views/scene/field_scene.h"
#include "workbench/views/viewer/foxglove.h"

namespace reorient {
namespace {

using foxglove::Json;

constexpr std::string_view kField = "field", kRobot = "robot", kTruth = "truth";
constexpr std::array<std::string_view, 2> kCameras{"camera_upper", "camera_lower"};

/// "input.ball.x" as the field x of the object ball of the object input.
void add_application(const FrameRecord& frame, Json& json) {
  for (const NamedScalar& scalar : application_values(frame.application, frame.world.time)) {
    const double* const number = std::get_if<double>(&scalar.value);
    if (number != nullptr && !std::isfinite(*number)) continue;
    Json* place = &json;
    std::size_t begin = 0;
    for (std::size_t dot = scalar.name.find('.'); dot != std::string::npos; dot = scalar.name.find('.', begin)) {
      place = &(*place)[scalar.name.substr(begin, dot - begin)];
      begin = dot + 1;
    }
    std::visit([&](const auto& value) { (*place)[scalar.name.substr(begin)] = value; }, scalar.value);
  }
}

Json world_json(const FrameRecord& frame) {
  const World& world = frame.world;
  std::vector<double> values;
  append_world(world, values);
  Json json = Json::object();
  const std::span<const WorldField> all = world_fields();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const WorldField& field = all[i];
    if (!std::isfinite(values[i])) continue;
    Json& value = json[std::string(field.table)][std::string(field.name)];
    const auto index = static_cast<std::size_t>(values[i]);
    if (field.type == WorldField::Type::boolean) {
      value = values[i] != 0.0;
    } else if (field.type == WorldField::Type::name) {
      value = index < field.names.size() ? field.names[index] : std::string();
    } else {
      value = values[i];
    }
  }
  add_application(frame, json);
  return json;
}

/// The parts of the body that the machine requested: nothing, or the machine that has it instead.
Json parts_json(const FrameRecord& frame, NameId machine, const std::vector<std::string>& names) {
  Json parts = Json::array();
  for (const PartClaim& claim : frame.claims) {
    if (claim.issuer.machine == machine && claim.part < names.size())
      parts.push_back({{"part", names[claim.part]}, {"outranked_by", frame.name(claim.outranked_by)}});
  }
  return parts;
}

Json machines_json(const FrameRecord& frame, const ScenarioRecord& scenario) {
  const std::vector<std::string> parts = body_parts(*frame.application.declared);
  Json machines = Json::array(), published = Json::array();
  const auto add = [&](const std::vector<MachineStatus>& all, const NameTable& names, bool of_scenario) {
    for (const MachineStatus& machine : all) {
      machines.push_back({{"name", names[machine.machine]},
                          {"state", names[machine.state]},
                          {"seconds", frame.world.time - machine.entered_at},
                          {"stopped", machine.stopped},
                          {"errors", machine.errors},
                          {"scenario", of_scenario},
                          {"parts", of_scenario ? Json::array() : parts_json(frame, machine.machine, parts)}});
    }
  };
  add(frame.machines, *frame.names, false);
  add(scenario.machines, *scenario.names, true);
  for (const NameId flag : frame.published) published.push_back(frame.name(flag));
  return {{"machines", std::move(machines)}, {"published", std::move(published)}};
}

/// Seconds, to the millisecond.
double short_seconds(double seconds) { return 1e-3 * std::round(1e3 * seconds); }

Json condition_json(const OpenCondition& condition, const FrameRecord& extra) {
  constexpr const char* kResults[] = {"none", "not evaluated", "no", "yes", "failed"};
  static_assert(std::size(kResults) == enum_count(WhenValue()));
  Json json{{"machine", extra.name(condition.machine)},
            {"from", extra.name(condition.from)},
            {"target", extra.name(condition.target)},
            {"reason", extra.name(condition.reason)},
            {"line", condition.line},
            {"when", kResults[static_cast<std::size_t>(condition.when)]}};
  const auto add_dwell = [&](const char* so_far_name, double so_far, const char* needed_name, double needed) {
    if (needed == 0.0) return;
    json[so_far_name] = short_seconds(so_far);
    if (std::isfinite(needed)) json[needed_name] = short_seconds(needed);
  };
  add_dwell("held", condition.held, "lasting", condition.lasting);
  add_dwell("waited", condition.waited, "after", condition.after);
  return json;
}

Json conditions_json(const FrameRecord& extra) {
  Json all = Json::array();
  for (const OpenCondition& condition : extra.conditions) all.push_back(condition_json(condition, extra));
  return {{"conditions", std::move(all)}};
}

Json event_json(const TimelineEvent& event) {
  return {{"machine", event.machine},
          {"state", event.state},
          {"command", event.command},
          {"verdict", event.verdict},
          {"reason", event.reason}};
}

Json request_json(const FrameRecord& frame) {
  const Request& request = frame.answer.request;
  Json head = Json::object();
  if (request.head) {
    head = {{"yaw", request.head->angles.yaw}, {"pitch", request.head->angles.pitch}, {"speed", request.head->speed}};
  }
  return {{"walk", {{"forward", request.walk.forward}, {"left", request.walk.left}, {"turn", request.walk.turn}}},
          {"head", std::move(head)},
          {"get_up", request.get_up},
          {"command", frame.reorientation ? to_string(frame.reorientation->reorientation) : std::string_view()}};
}

Json costs_json(const FrameRecord& extra, const SceneTruth& scene_truth) {
  Json stages = Json::object(), machines = Json::array();
  for (int i = 0; i < kStageCount; ++i) {
    stages[std::string(to_string(static_cast<Stage>(i)))] = 1e3 * extra.costs.seconds[static_cast<std::size_t>(i)];
  }
  for (const MachineCost& machine : extra.costs.machines) {
    machines.push_back({{"name", extra.name(machine.machine)},
                        {"microseconds", machine.microseconds},
                        {"instructions", machine.instructions},
                        {"memory", machine.memory}});
  }
  return {{"milliseconds", std::move(stages)},
          {"frame_milliseconds", 1e3 * scene_truth.stepping},
          {"machines", std::move(machines)}};
}

Json room_json(const RoomRecord& room) {
  const auto rounded = [](double value) { return std::isfinite(value) ? std::round(1e4 * value) / 1e4 : 0.0; };
  Json evidence = Json::array(), in_view = Json::array(), view = Json::array();
  double sum = 0.0;
  for (const double log_odds : room.evidence) {
    evidence.push_back(rounded(log_odds));
    sum += log_odds;
  }
  for (const PerceivedTile& perceived : room.perceived) {
    if (!perceived.counts) continue;
    Json tile{{"tile", perceived.tile}};
    const auto place = std::find_if(room.compared.begin(), room.compared.end(),
                                    [&](const ComparedPlace& one) { return one.tile == perceived.tile; });
    if (place != room.compared.end() && place->believed_known) tile["believed"] = rounded(place->as_believed);
    if (place != room.compared.end() && place->reflected_known) tile["mirrored"] = rounded(place->as_reflected);
    in_view.push_back(std::move(tile));
  }
  for (const auto& [azimuth, share] : scene::view_shares(room))
    view.push_back({{"azimuth", rounded(azimuth)}, {"share", rounded(share)}});
  return {{"rows", room.basis.wall.rows},    {"columns", room.basis.wall.columns}, {"sum", rounded(sum)},
          {"evidence", std::move(evidence)}, {"in_view", std::move(in_view)},      {"view", std::move(view)}};
}

/// Thresholds of the evidence; nothing: the run does not have their parameters.
std::optional<Json> decision_json(const std::vector<Parameter>& parameters) {
  const double confirmed = confirmed_threshold(parameters), unconfirmed = unconfirmed_threshold(parameters);
  if (confirmed == 0.0 || unconfirmed == 0.0) return std::nullopt;
  return Json{{"confirmed", confirmed}, {"unconfirmed", unconfirmed}};
}

Json parameters_json(const std::vector<Parameter>& parameters) {
  Json all = Json::array();
  for (const Parameter& parameter : parameters)
    all.push_back({{"name", parameter.name}, {"value", to_text(parameter.value)}, {"unit", parameter.unit}});
  return {{"parameters", std::move(all)}};
}

Json transforms_json(const FrameRecord& frame, const SceneTruth& scene_truth) {
  const double time = frame.world.time;
  Json all = Json::array();
  all.push_back(foxglove::transform(time, kField, kRobot, foxglove::on_the_ground(frame.world.pose.pose)));
  const std::optional<CameraRecord>* const cameras[] = {&frame.inputs.upper, &frame.inputs.lower};
  for (std::size_t i = 0; i < kCameras.size(); ++i) {
    if (const std::optional<CameraRecord>& camera = *cameras[i]) {
      all.push_back(
          foxglove::transform(time, kRobot, kCameras[i], camera->robot_from_camera * foxglove::camera_from_optical()));
    }
  }
  if (scene_truth.truth)
    all.push_back(foxglove::transform(time, kField, kTruth, foxglove::on_the_ground(scene_truth.truth->pose)));
  return {{"transforms", std::move(all)}};
}

Json log_json(double time, const LogLine& line) {
  using foxglove::Level;
  const Level level = line.level == LogLine::Level::info      ? Level::info
                      : line.level == LogLine::Level::warning ? Level::warning
                                                              : Level::error;
  const std::string& name = line.source.empty() ? line.file : line.source;
  return foxglove::log(time, level, name.empty() ? "note" : name, line.text, line.file, line.line);
}

Json log_json(double time, const ParameterOutcome& change) {
  const bool taken = change.refusal.empty();
  return foxglove::log(time, taken ? foxglove::Level::info : foxglove::Level::warning, "parameters",
                       change.name + " = " + change.value + (taken ? "" : ": " + change.refusal));
}

}  // namespace

void copy_pixels(const ImageView& from, Image& to) {
  if (to.width() != from.width || to.height() != from.height) to = Image(from.width, from.height);
  for (int y = 0; y < from.height; ++y) std::memcpy(to.row(y), from.row(y), 2 * static_cast<std::size_t>(from.width));
}

void ViewerMessages::add(const ViewedFrame& viewed, const Sink& sink) {
  const FrameRecord& frame = viewed.frame;
  const SceneTruth& scene_truth = viewed.scene;
  const double time = frame.world.time;
  const auto is_wanted = [&](ViewerTopic topic) { return viewed.topics.test(static_cast<std::size_t>(topic)); };
  /// `make` makes the message, if it is wanted.
  const auto send = [&](ViewerTopic topic, const auto& make) {
    if (!is_wanted(topic)) return;
    const Json message = make();
    // Scripts may log invalid UTF-8.
    sink(topic, message.dump(-1, ' ', false, Json::error_handler_t::replace));
  };
  const auto send_scene = [&](ViewerTopic topic, std::string_view frame_id, std::string_view id, const auto& make) {
    send(topic, [&] { return foxglove::scene_update(time, frame_id, id, make()); });
  };

  if (viewed.begins)
    send_scene(ViewerTopic::field, kField, "field", [&] { return scene::field_scene(frame.world.field); });
  if (viewed.extra.filled.has(Topic::room) && !viewed.extra.room.model.empty()) {
    send_scene(ViewerTopic::wall, kField, "wall", [&] { return scene::wall_scene(viewed.extra.room); });
    send_scene(ViewerTopic::view, kField, "view", [&] { return scene::view_scene(viewed.extra.room); });
    send(ViewerTopic::room, [&] { return room_json(viewed.extra.room); });
  }
  if (viewed.extra.filled.has(Topic::parameters)) {
    send(ViewerTopic::parameters, [&] { return parameters_json(viewed.extra.parameters); });
    if (const std::optional<Json> decision = decision_json(viewed.extra.parameters))
      send(ViewerTopic::decision, [&] { return *decision; });
  }
  if (viewed.extra.filled.has(Topic::pose_particles)) {
    send(ViewerTopic::pose_particles,
         [&] { return foxglove::poses_in_frame(time, kField, viewed.extra.pose_particles.particles); });
  }
  if (viewed.extra.filled.has(Topic::conditions))
    send(ViewerTopic::conditions, [&] { return conditions_json(viewed.extra); });
  if (viewed.extra.filled.has(Topic::costs))
    send(ViewerTopic::costs, [&] { return costs_json(viewed.extra, scene_truth); });

  send(ViewerTopic::transforms, [&] { return transforms_json(frame, scene_truth); });
  send(ViewerTopic::pose, [&] { return foxglove::pose_in_frame(time, kField, frame.world.pose.pose); });
  if (scene_truth.truth)
    send(ViewerTopic::truth, [&] { return foxglove::pose_in_frame(time, kField, scene_truth.truth->pose); });
  send_scene(ViewerTopic::percepts, kRobot, "percepts", [&] {
    const bool has_fits = viewed.extra.filled.has(Topic::feature_fits);
    return scene::percept_scene(frame.percepts, has_fits ? std::span<const FeatureFits>(viewed.extra.feature_fits)
                                                         : std::span<const FeatureFits>());
  });
  send(ViewerTopic::world, [&] { return world_json(frame); });
  send(ViewerTopic::machines, [&] { return machines_json(frame, scene_truth.scenario); });
  send(ViewerTopic::request, [&] { return request_json(frame); });
  if (is_wanted(ViewerTopic::events)) {
    for (const TimelineEvent& event : timeline_events(frame, scene_truth))
      send(ViewerTopic::events, [&] { return event_json(event); });
  }
  if (is_wanted(ViewerTopic::log)) {
    for (const ParameterOutcome& change : frame.parameter_changes)
      send(ViewerTopic::log, [&] { return log_json(time, change); });
    for (const LogLine& line : log_lines(frame, scene_truth))
      send(ViewerTopic::log, [&] { return log_json(time, line); });
  }

  struct CameraTopics {
    const std::optional<CameraRecord>& camera;
    ViewerTopic image, calibration, annotations;
  };
  const CameraTopics cameras[] = {
      {frame.inputs.upper, ViewerTopic::upper_image, ViewerTopic::upper_calibration, ViewerTopic::upper_annotations},
      {frame.inputs.lower, ViewerTopic::lower_image, ViewerTopic::lower_calibration, ViewerTopic::lower_annotations}};
  for (std::size_t i = 0; i < kCameras.size(); ++i) {
    if (!cameras[i].camera) continue;
    const CameraRecord& camera = *cameras[i].camera;
    if (viewed.begins) {
      send(cameras[i].calibration,
           [&] { return foxglove::camera_calibration(camera.time, kCameras[i], camera.camera); });
    }
    if (viewed.images[i].empty()) continue;
    send(cameras[i].image,
         [&] { return foxglove::compressed_image(camera.time, kCameras[i], encoder_.encode(viewed.images[i])); });
    send(cameras[i].annotations, [&] {
      return foxglove::image_annotations(camera.time, scene::field_overlay(frame, static_cast<HeadCamera>(i)));
    });
  }
}

}  // namespace reorient
