// SPDX-License-Identifier: MIT
#include "workbench/run/run_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/parameter.h"
#include "engine/parameters/utf8.h"
#include "geometry/angle.h"
#include "geometry/settable_pose.h"

namespace reorient {
namespace {

using Kind = OperatorAction::Kind;

constexpr std::string_view kMirror = "mirror";
constexpr std::array kRequestedKinds{Kind::pick_up,         Kind::put_down,     Kind::push_over,
                                     Kind::penalize,        Kind::change_light, Kind::set_exposure_compensation,
                                     Kind::set_initial_pose};

template <typename... Values>
std::string printed(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

/// Throws std::runtime_error.
double required(std::string_view name, const char* value_name, const std::optional<double>& value) {
  if (value) return *value;
  throw std::runtime_error(std::string(name) + ": " + value_name + ": expected a number, found none");
}

/// Throws std::runtime_error.
void require_within(const std::string& name, double value, double least, double most, const char* unit) {
  if (value >= least && value <= most) return;  // not for NaN
  throw std::runtime_error(name + ": expected " + to_text(least) + " to " + to_text(most) + unit + ", found " +
                           to_text(value));
}

/// Throws std::runtime_error if the place is too far beside the field.
void require_beside_field(const OperatorRequest& request, const FieldDimensions& field) {
  const Eigen::Vector2d most = carpet_half_size(field) + Eigen::Vector2d::Constant(kBelievableBeyondCarpet);
  const Eigen::Vector2d& place = request.action.pose.position;
  if ((place.cwiseAbs().array() <= most.array()).all()) return;
  throw std::runtime_error(std::string(request.name()) +
                           printed(": expected a place within %.1f m (x) and %.1f m (y) of the field's center, found "
                                   "%.1f m, %.1f m",
                                   most.x(), most.y(), place.x(), place.y()));
}

/// The pose of a request. Throws std::runtime_error.
Pose2 requested_pose(std::string_view name, const OperatorRequestValues& values) {
  const double x = required(name, "x", values.x), y = required(name, "y", values.y);
  const double rotation = from_degrees(required(name, "degrees", values.degrees));
  if (const std::string mistake = mistake_in_pose(x, y, rotation); !mistake.empty())
    throw std::runtime_error(std::string(name) + ": " + mistake);
  return Pose2(x, y, rotation);
}

}  // namespace

std::string_view OperatorRequest::name() const { return mirrors ? kMirror : to_string(action.kind); }

std::string OperatorRequest::text() const {
  std::string text(name());
  if (mirrors) return text;
  if (action.kind == Kind::put_down || action.kind == Kind::set_initial_pose)
    text += printed(" at x %.2f m, y %.2f m, %.1f degrees", action.pose.position.x(), action.pose.position.y(),
                    to_degrees(action.pose.rotation));
  if (action.kind == Kind::penalize) text += action.penalized ? " on" : " off";
  if (action.kind == Kind::set_exposure_compensation) text += printed(" %.2f stops", action.stops);
  return text;
}

const std::vector<std::string>& operator_request_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(kRequestedKinds.size() + 1);
    for (const Kind kind : kRequestedKinds) all.emplace_back(to_string(kind));
    all.emplace_back(kMirror);
    return all;
  }();
  return names;
}

OperatorRequest operator_request(std::string_view name, const OperatorRequestValues& values) {
  OperatorRequest request;
  if (name == kMirror) {
    request.action.kind = Kind::put_down;
    request.mirrors = true;
    return request;
  }
  const auto kind =
      std::find_if(kRequestedKinds.begin(), kRequestedKinds.end(), [&](Kind one) { return to_string(one) == name; });
  if (kind == kRequestedKinds.end()) {
    const std::string given = as_line(name.substr(0, 40));
    throw std::runtime_error("unknown action '" + given + "'" + did_you_mean(given, operator_request_names()));
  }
  request.action.kind = *kind;
  if (*kind == Kind::put_down || *kind == Kind::set_initial_pose) request.action.pose = requested_pose(name, values);
  if (*kind == Kind::penalize) request.action.penalized = values.penalized.value_or(true);
  if (*kind == Kind::set_exposure_compensation) {
    request.action.stops = required(name, "stops", values.stops);
    require_within(std::string(name), request.action.stops, -kMostStops, kMostStops, " stops");
  }
  return request;
}

std::uint64_t RunControls::request(OperatorRequest request, std::string_view issuer) {
  if (!has_operator_ && request.action.kind != Kind::set_initial_pose)
    throw std::runtime_error(std::string(request.name()) +
                             ": expected a robot that this program can lift and place (the simulator), found another "
                             "one; move it by hand");
  if (field_) require_beside_field(request, *field_);
  if (requests_.size() >= kMostWaiting)
    throw std::runtime_error(std::string(request.name()) + ": expected at most " + std::to_string(kMostWaiting) +
                             " actions that wait for the next frame, found more");
  requests_.push_back({std::move(request), issuer});
  return carried_out_ + requests_.size();
}

RunPace& RunControls::change_pace(std::string_view action) {
  if (!sets_pace_)
    throw std::runtime_error(std::string(action) +
                             ": expected the simulator or footage in real time, found a robot that sets its own pace");
  return pace_;
}

void RunControls::set_speed(double speed) {
  RunPace& pace = change_pace("speed");
  require_within("speed", speed, RunPace::kSlowest, RunPace::kFastest, " times real time");
  pace.set_speed(speed);
}

void RunControls::take_frames(int count) {
  RunPace& pace = change_pace("frame");
  require_within("frame", count, 1, RunPace::kMostFrames, " frames");
  pace.take_frames(count);
}

std::vector<RunControls::Issued> RunControls::take() {
  carried_out_ += requests_.size();
  return std::exchange(requests_, {});
}

}  // namespace reorient
