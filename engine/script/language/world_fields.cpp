// SPDX-License-Identifier: MIT
#include "engine/script/language/world_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

#include "engine/parameters/nearest_name.h"
#include "engine/world/room_status.h"
#include "geometry/settable_pose.h"

namespace reorient {
namespace {

using Type = WorldField::Type;

/// A field that is computed from another field.
struct Computed {
  bool (*value)(const World&);
  std::string_view source;  ///< "confidence.status"
};

/// Address of a field in a world, or how it is computed. Only tests write through it.
using Access =
    std::variant<double* (*)(World&), bool* (*)(World&), int* (*)(World&), std::uint64_t* (*)(World&),
                 Posture* (*)(World&), RoomStatus* (*)(World&), GameState* (*)(World&), KickOff* (*)(World&), Computed>;

struct BoundField {
  std::string_view table;
  std::string_view name;
  std::string_view unit;
  std::string_view description;
  Access access;
  std::string_view replacement = {};  ///< of a former name
};

constexpr WorldTable kTables[] = {
    {"clock", "Time."},
    {"game", "State of the game as the referee reports it."},
    {"robot", "The robot's own body."},
    {"pose", "The believed pose in the field's frame: x toward the opponents' goal, y to the left."},
    {"confidence", "Results of room awareness for the believed pose, from 0 to 1 unless a unit is given."},
    {"views", "Head directions with the most information while the body does not turn."},
    {"training", "The background model of the room."},
    {"evaluation", "The comparison of the view with the background model."},
    {"seen", "Observations of the field in this frame."},
    {"field", "Dimensions of the field, measured between centers of lines; the origin is the center of the field."},
};

const BoundField kFields[] = {
    {"clock", "time", "s", "time since the robot was switched on", [](World& w) { return &w.time; }},
    {"clock", "step", "s", "time since the previous frame", [](World& w) { return &w.time_step; }},
    {"clock", "frame", "", "number of this frame", [](World& w) { return &w.frame; }},
    {"game", "sides_changed", "",
     "whether the teams have changed sides; a change rotates the field's axes by 180 degrees",
     [](World& w) { return &w.sides_changed; }},
    {"game", "state", "", "state of the game as named in the rules; unknown: the referee has not reported a state",
     [](World& w) { return &w.referee.state; }},
    {"game", "stopped", "",
     "whether all robots must stand still; requests of behaviors to head and legs have no effect then",
     [](World& w) { return &w.referee.stopped; }},
    {"game", "kick_off", "",
     "team that takes the kick-off or the free kick; it stays set while the ball is in play, until the next one",
     [](World& w) { return &w.referee.kick_off; }},
    {"robot", "posture", "", "current posture of the robot", [](World& w) { return &w.posture; }},
    {"robot", "posture_before", "", "previous posture", [](World& w) { return &w.posture_before; }},
    {"robot", "posture_for", "s", "time since the posture changed", [](World& w) { return &w.posture_for; }},
    {"robot", "time_since_disturbance", "s",
     "time since the last fall, lift or penalty; 0 while the robot is not upright or is penalized",
     [](World& w) { return &w.time_since_disturbance; }},
    {"robot", "undisturbed_for", "s", "former name of robot.time_since_disturbance",
     [](World& w) { return &w.time_since_disturbance; }, "robot.time_since_disturbance"},
    {"robot", "penalized", "", "whether the robot is penalized by the referee",
     [](World& w) { return &w.referee.penalized; }},
    {"robot", "may_walk", "",
     "whether the rules permit walking: not penalized, and the game is ready, playing or unknown; otherwise the robot "
     "stands, and walk requests have no effect",
     [](World& w) { return &w.may_walk; }},
    {"robot", "head_yaw", "rad", "measured yaw of the head, positive to the left",
     [](World& w) { return &w.head.yaw; }},
    {"robot", "head_pitch", "rad", "measured pitch of the head, positive downward",
     [](World& w) { return &w.head.pitch; }},
    {"robot", "head_reach", "rad", "largest yaw of the head to either side", [](World& w) { return &w.head_reach; }},
    {"robot", "torso_pitch_bias", "rad",
     "estimated error of the torso's measured pitch, from the lines of the field, positive forward",
     [](World& w) { return &w.camera_bias.torso.pitch; }},
    {"robot", "camera_pitch_bias", "rad",
     "estimated error of the upper camera's pitch in its mounting, positive downward",
     [](World& w) { return &w.camera_bias.mounts[0].pitch; }},
    {"robot", "bias_deviation", "rad", "standard deviation of the sum of torso_pitch_bias and camera_pitch_bias",
     [](World& w) { return &w.camera_bias.deviation; }},
    {"robot", "walking", "", "whether the robot walks or turns: it was requested, or the odometry measures it",
     Computed{[](const World& w) { return is_walking(w.motion); }, "robot.speed"}},
    {"robot", "speed", "m/s", "measured speed along the ground, smoothed over 0.3 s",
     [](World& w) { return &w.motion.speed; }},
    {"robot", "turn_speed", "rad/s", "measured speed of rotation, positive to the left, smoothed over 0.3 s",
     [](World& w) { return &w.motion.measured.turn; }},
    {"robot", "requested_speed", "m/s", "speed of the walk request that the robot got in the previous frame",
     [](World& w) { return &w.motion.requested_speed; }},
    {"robot", "head_moving", "", "whether the head turns faster than 0.1 rad/s",
     Computed{[](const World& w) { return is_head_moving(w.motion); }, "robot.head_speed"}},
    {"robot", "head_speed", "rad/s", "measured speed of the faster joint of the neck, smoothed over 0.1 s",
     [](World& w) { return &w.motion.head_speed; }},
    {"robot", "can_walk", "", "whether this body can walk", [](World& w) { return &w.can_walk; }},
    {"robot", "can_get_up", "", "whether this body can get up after a fall", [](World& w) { return &w.can_get_up; }},
    {"robot", "cruise", "m/s", "walking speed of this body over long distances; 0: it cannot walk",
     [](World& w) { return &w.cruise; }},
    {"pose", "x", "m", "position toward the opponents' goal", [](World& w) { return &w.pose.pose.position.x(); }},
    {"pose", "y", "m", "position to the left", [](World& w) { return &w.pose.pose.position.y(); }},
    {"pose", "rotation", "rad", "direction: 0 toward the opponents' goal, positive to the left",
     [](World& w) { return &w.pose.pose.rotation; }},
    {"pose", "known", "",
     "whether an initial pose was set, or a flip or purge has confirmed the pose; false after a reset",
     [](World& w) { return &w.pose_known; }},
    {"pose", "tracked", "",
     "whether the observed field has fitted the believed pose or the mirrored pose for some seconds; false while "
     "the robot searches for its position",
     [](World& w) { return &w.pose_tracked; }},
    {"pose", "cluster_weight", "", "fraction of the pose particles' weight in the believed cluster",
     [](World& w) { return &w.pose.cluster_weight; }},
    {"pose", "reflected_weight", "", "fraction of the pose particles' weight near the mirrored pose",
     [](World& w) { return &w.pose.reflected_weight; }},
    {"pose", "recovery_probability", "",
     "how much worse than usual the pose particles fit the observed field, from 0 (as usual) to 1 (not at all)",
     [](World& w) { return &w.recovery_probability; }},
    {"confidence", "current", "", "smoothed confidence in the believed pose",
     [](World& w) { return &w.confidence.current; }},
    {"confidence", "opposite", "", "smoothed confidence in the mirrored pose",
     [](World& w) { return &w.confidence.opposite; }},
    {"confidence", "evidence", "log-odds",
     "evidence of the room for the mirrored pose: 4.6 means 99 in 100, 0 means undecided, negative values support "
     "the believed pose",
     [](World& w) { return &w.confidence.evidence; }},
    {"confidence", "raw_current", "", "confidence in the believed pose from this frame alone",
     [](World& w) { return &w.confidence.raw_current; }},
    {"confidence", "raw_opposite", "", "confidence in the mirrored pose from this frame alone",
     [](World& w) { return &w.confidence.raw_opposite; }},
    {"confidence", "goal_opponent", "", "confidence that the robot looks at the wall behind the opponents' goal",
     [](World& w) { return &w.confidence.goal_opponent; }},
    {"confidence", "goal_own", "", "confidence that the robot looks at the wall behind its own goal",
     [](World& w) { return &w.confidence.goal_own; }},
    {"confidence", "coverage", "", "fraction of the wall whose tiles are trained enough for the comparison",
     [](World& w) { return &w.confidence.coverage; }},
    {"confidence", "paired", "",
     "fraction of the wall that is trained enough together with the mirrored tiles on the opposite side",
     [](World& w) { return &w.confidence.paired; }},
    {"confidence", "distinctiveness", "",
     "how much the room differs from itself rotated by 180 degrees; 0: no difference",
     [](World& w) { return &w.confidence.distinctiveness; }},
    {"confidence", "separability", "",
     "probability that the room distinguishes a pose from its mirrored pose; below 0.5 (room_status.separability) "
     "the room counts as symmetric",
     [](World& w) { return &w.confidence.separability; }},
    {"confidence", "asymmetry", "", "former name of confidence.separability",
     [](World& w) { return &w.confidence.separability; }, "confidence.separability"},
    {"confidence", "age", "s",
     "time for which known tiles were in view since the confidences restarted: after a lift, a fall, a penalty, a set "
     "pose, a flip or a jump of the belief",
     [](World& w) { return &w.confidence.age; }},
    {"confidence", "status", "", "whether the confidences are valid for the believed pose, or the reason why not",
     [](World& w) { return &w.room_status; }},
    {"confidence", "can_tell", "",
     "whether the room can distinguish the believed pose from the mirrored pose: learned, not symmetric, evaluated; "
     "true while confidence.status is usable, lost or fresh; right after a fall or a lift it is resting",
     Computed{[](const World& w) { return can_tell(w.room_status); }, "confidence.status"}},
    {"confidence", "visible_tiles", "", "number of tiles of the wall that were used in this frame",
     [](World& w) { return &w.confidence.visible_tiles; }},
    {"views", "best_yaw", "rad", "yaw of the head at which the room differs most from itself rotated by 180 degrees",
     [](World& w) { return &w.views.best_yaw; }},
    {"views", "best_score", "tiles",
     "difference of the room from itself rotated by 180 degrees at best_yaw, in fully counted tiles; 0: no tile is "
     "in reach",
     [](World& w) { return &w.views.best_score; }},
    {"views", "unknown_yaw", "rad", "yaw of the head at which most tiles are not learned yet",
     [](World& w) { return &w.views.unknown_yaw; }},
    {"views", "unknown_score", "tiles", "number of tiles at unknown_yaw that are not learned yet",
     [](World& w) { return &w.views.unknown_score; }},
    {"views", "telling", "rad", "former name of views.best_yaw", [](World& w) { return &w.views.best_yaw; },
     "views.best_yaw"},
    {"views", "telling_worth", "tiles", "former name of views.best_score", [](World& w) { return &w.views.best_score; },
     "views.best_score"},
    {"views", "unknown", "rad", "former name of views.unknown_yaw", [](World& w) { return &w.views.unknown_yaw; },
     "views.unknown_yaw"},
    {"views", "unknown_worth", "tiles", "former name of views.unknown_score",
     [](World& w) { return &w.views.unknown_score; }, "views.unknown_score"},
    {"training", "seconds", "s",
     "total training time of the background model, including the training of a loaded model",
     [](World& w) { return &w.trained_seconds; }},
    {"training", "active", "", "whether the background model was trained in the previous frame",
     [](World& w) { return &w.training; }},
    {"evaluation", "active", "", "whether the confidences were evaluated in the previous frame",
     [](World& w) { return &w.evaluating; }},
    {"seen", "goal_posts", "", "number of goal posts in view", [](World& w) { return &w.goal_posts; }},
    {"seen", "line_points", "", "number of points on field lines in view", [](World& w) { return &w.line_points; }},
    {"seen", "intersections", "", "number of line intersections in view", [](World& w) { return &w.intersections; }},
    {"seen", "ball", "", "whether a ball is in view", [](World& w) { return &w.ball; }},
    {"seen", "ball_distance", "m", "distance of the ball; 0 if no ball is in view",
     [](World& w) { return &w.ball_distance; }},
    {"seen", "ball_bearing", "rad", "direction of the ball, positive to the left; 0 if no ball is in view",
     [](World& w) { return &w.ball_bearing; }},
    {"field", "length", "m", "distance between the goal lines", [](World& w) { return &w.field.length; }},
    {"field", "width", "m", "distance between the touchlines", [](World& w) { return &w.field.width; }},
    {"field", "border", "m", "width of the carpet outside the lines", [](World& w) { return &w.field.border; }},
    {"field", "penalty_mark_x", "m", "distance of both penalty marks from the center",
     [](World& w) { return &w.field.penalty_mark_x; }},
    {"field", "penalty_area_depth", "m", "depth of the penalty area from the goal line",
     [](World& w) { return &w.field.penalty_area_depth; }},
    {"field", "penalty_area_width", "m", "width of the penalty area along the goal line",
     [](World& w) { return &w.field.penalty_area_width; }},
    {"field", "goal_post_y", "m", "distance of a goal post from the middle of the goal",
     [](World& w) { return &w.field.goal_post_y; }},
    {"field", "corner_arc_radius", "m", "radius of the quarter circles at the corners; 0: the field has none",
     [](World& w) { return &w.field.corner_arc_radius; }},
    {"field", "center_circle_radius", "m", "radius of the center circle",
     [](World& w) { return &w.field.center_circle_radius; }},
};

template <typename Enum>
std::span<const std::string_view> names_of() {
  static const auto names = [] {
    std::array<std::string_view, static_cast<std::size_t>(enum_count(Enum{}))> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = to_string(static_cast<Enum>(i));
    return all;
  }();
  return names;
}

/// Describes a field whose value has this C++ type.
template <typename Value>
WorldField described(const BoundField& field, Value* (*)(World&)) {
  WorldField result;
  result.table = field.table;
  result.name = field.name;
  result.unit = field.unit;
  result.description = field.description;
  result.replacement = field.replacement;
  if constexpr (std::is_same_v<Value, bool>) {
    result.type = Type::boolean;
  } else if constexpr (std::is_integral_v<Value>) {  // a count
    result.minimum = 0.0;
    result.maximum = std::numeric_limits<int>::max();
    result.is_integer = true;
  } else if (field.unit.empty()) {  // a fraction or a probability
    result.minimum = 0.0;
    result.maximum = 1.0;
  } else if (field.unit == "s") {
    result.minimum = 0.0;
  } else if (field.table == "pose" && field.unit == "m") {
    result.minimum = -kFarthestPose;
    result.maximum = kFarthestPose;
  }
  if constexpr (std::is_enum_v<Value>) {
    result.type = Type::name;
    result.names = names_of<Value>();
  }
  return result;
}

WorldField described(const BoundField& field, const Computed&) {
  return described(field, static_cast<bool* (*)(World&)>(nullptr));
}

auto make_fields() {
  std::array<WorldField, std::size(kFields)> fields;
  for (std::size_t i = 0; i < fields.size(); ++i)
    fields[i] = std::visit([&](auto access) { return described(kFields[i], access); }, kFields[i].access);
  return fields;
}

}  // namespace

std::span<const WorldField> world_fields() {
  // Never destroyed: a thread that still runs when the program exits may read it.
  static const auto fields = make_fields();
  static_assert(std::is_trivially_destructible_v<decltype(fields)>);
  return fields;
}

std::span<const WorldTable> world_tables() { return kTables; }

void append_world(const World& world, std::vector<double>& values) {
  World readable = world;  // the accessors give addresses that can be written
  const auto value = [&](auto access) {
    if constexpr (std::is_same_v<decltype(access), Computed>) {
      return static_cast<double>(access.value(world));
    } else {
      return static_cast<double>(*access(readable));
    }
  };
  for (const BoundField& field : kFields) values.push_back(std::visit(value, field.access));
}

double checked_value(const WorldField& field, const WorldValue& value) {
  if (field.type != value.type) {
    const char* const expected = field.type == Type::boolean  ? ": expected true or false"
                                 : field.type == Type::number ? ": expected a number"
                                                              : ": expected a string";
    throw std::runtime_error(field.full_name() + expected);
  }
  if (field.type == Type::number) {
    const bool fits = std::isfinite(value.number) && value.number >= field.minimum && value.number <= field.maximum &&
                      (!field.is_integer || value.number == std::floor(value.number));
    if (fits) return value.number;
    const std::string range = field.maximum == 1.0             ? ", from 0 to 1"
                              : field.minimum == 0.0           ? ", not negative"
                              : field.maximum == kFarthestPose ? ", from -100 to 100"
                                                               : "";
    throw std::runtime_error(field.full_name() + ": expected a " + (field.is_integer ? "whole" : "finite") + " number" +
                             range);
  }
  if (field.type == Type::boolean) return value.number;
  const auto found = std::find(field.names.begin(), field.names.end(), value.name);
  if (found != field.names.end()) return static_cast<double>(found - field.names.begin());
  const std::vector<std::string> known(field.names.begin(), field.names.end());
  throw std::runtime_error(field.full_name() + ": unknown value '" + std::string(value.name) + "'" +
                           did_you_mean(value.name, known));
}

const WorldField& write_world(World& world, std::string_view table, std::string_view name, const WorldValue& value) {
  const std::span<const WorldField> all = world_fields();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].table != table || all[i].name != name) continue;
    const double number = checked_value(all[i], value);
    std::visit(
        [&](auto access) {
          if constexpr (std::is_same_v<decltype(access), Computed>) {
            throw std::runtime_error(all[i].full_name() + " cannot be set: it is computed from " +
                                     std::string(access.source));
          } else {
            auto* target = access(world);
            using Value = std::remove_pointer_t<decltype(target)>;
            if constexpr (std::is_enum_v<Value>) {
              *target = static_cast<Value>(static_cast<int>(number));
            } else {
              *target = static_cast<Value>(number);
            }
          }
        },
        kFields[i].access);
    return all[i];
  }
  std::vector<std::string> known;
  for (const WorldField& field : all) known.push_back(field.full_name());
  const std::string requested = std::string(table) + "." + std::string(name);
  throw std::runtime_error("unknown world field '" + requested + "'" + did_you_mean(requested, known));
}

}  // namespace reorient
