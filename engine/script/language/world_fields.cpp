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

namespace reorient {
namespace {

using Type = WorldField::Type;

/// A field that follows from another one.
struct Computed {
  bool (*value)(const World&);
  std::string_view source;  ///< "confidence.status"
};

/// Where a field lives in a world, or how it is computed. Only tests write through it.
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
    {"game", "What the referee says of the game."},
    {"robot", "The robot's own body."},
    {"pose", "Where the robot believes that it is, in the field's frame: x towards the opponent goal, y to the left."},
    {"confidence", "What room awareness says about the believed pose; all from 0 to 1 unless said."},
    {"views", "Which way to turn the head, as long as the body stays as it is."},
    {"training", "The background model of the room."},
    {"evaluation", "The comparison of what is seen with the background model."},
    {"seen", "What was seen of the field in this frame."},
    {"field", "The field as drawn, to the centres of its lines; the origin is its centre."},
};

const BoundField kFields[] = {
    {"clock", "time", "s", "since the robot was switched on", [](World& w) { return &w.time; }},
    {"clock", "step", "s", "since the frame before", [](World& w) { return &w.time_step; }},
    {"clock", "frame", "", "number of this frame", [](World& w) { return &w.frame; }},
    {"game", "sides_changed", "",
     "the team plays towards the end that was its own at first; where this changes, so have the field's axes",
     [](World& w) { return &w.sides_changed; }},
    {"game", "state", "", "as the rules call it; unknown: nobody has said anything",
     [](World& w) { return &w.referee.state; }},
    {"game", "stopped", "", "nobody may move: what a behaviour asks of head and legs is not carried out",
     [](World& w) { return &w.referee.stopped; }},
    {"game", "kick_off", "", "who kicks off next, or takes the free kick",
     [](World& w) { return &w.referee.kick_off; }},
    {"robot", "posture", "", "how it stands, lies or hangs in somebody's hands", [](World& w) { return &w.posture; }},
    {"robot", "posture_before", "", "the posture before the present one", [](World& w) { return &w.posture_before; }},
    {"robot", "posture_for", "s", "for how long it has had its posture", [](World& w) { return &w.posture_for; }},
    {"robot", "time_since_disturbance", "s",
     "time since the last fall, lift or penalty; 0 while the robot is not upright or is penalized",
     [](World& w) { return &w.time_since_disturbance; }},
    {"robot", "undisturbed_for", "s", "former name of robot.time_since_disturbance",
     [](World& w) { return &w.time_since_disturbance; }, "robot.time_since_disturbance"},
    {"robot", "penalized", "", "the referee has taken it out of the game",
     [](World& w) { return &w.referee.penalized; }},
    {"robot", "may_walk", "",
     "the referee lets it: it is in the game, which is ready or playing, or of which nobody has said anything; else it "
     "stands, whatever a behaviour asks",
     [](World& w) { return &w.may_walk; }},
    {"robot", "head_yaw", "rad", "measured angle of the head, to the left", [](World& w) { return &w.head.yaw; }},
    {"robot", "head_pitch", "rad", "measured angle of the head, downwards", [](World& w) { return &w.head.pitch; }},
    {"robot", "head_reach", "rad", "how far the neck turns to either side", [](World& w) { return &w.head_reach; }},
    {"robot", "torso_pitch_bias", "rad",
     "how much farther the torso leans forward than is measured, as far as the lines of the field have shown",
     [](World& w) { return &w.camera_bias.torso.pitch; }},
    {"robot", "camera_pitch_bias", "rad", "how much lower the upper camera looks in its mounting than is measured",
     [](World& w) { return &w.camera_bias.mounts[0].pitch; }},
    {"robot", "bias_deviation", "rad", "how well the sum of the two is known: a standard deviation",
     [](World& w) { return &w.camera_bias.deviation; }},
    {"robot", "can_walk", "", "this body walks", [](World& w) { return &w.can_walk; }},
    {"robot", "can_get_up", "", "this body gets up after a fall", [](World& w) { return &w.can_get_up; }},
    {"robot", "cruise", "m/s", "at which speed this body goes far; 0: it does not walk",
     [](World& w) { return &w.cruise; }},
    {"pose", "x", "m", "towards the opponent goal", [](World& w) { return &w.pose.pose.position.x(); }},
    {"pose", "y", "m", "to the left", [](World& w) { return &w.pose.pose.position.y(); }},
    {"pose", "rotation", "rad", "0 looks towards the opponent goal, positive turns left",
     [](World& w) { return &w.pose.pose.rotation; }},
    {"pose", "known", "",
     "somebody told where the robot stands, or a flip or purge has confirmed it; a reset takes it back",
     [](World& w) { return &w.pose_known; }},
    {"pose", "tracked", "",
     "what is seen of the field has fitted the believed pose, or its reflection, for seconds; false while the robot "
     "looks for its place",
     [](World& w) { return &w.pose_tracked; }},
    {"pose", "cluster_weight", "", "of all pose particles, in the cluster that is believed",
     [](World& w) { return &w.pose.cluster_weight; }},
    {"pose", "reflected_weight", "", "of all pose particles, near the reflection of the believed pose",
     [](World& w) { return &w.pose.reflected_weight; }},
    {"pose", "recovery_probability", "",
     "how much worse than usual the pose particles fit what is seen of the field: 0 as usual, 1 not at all",
     [](World& w) { return &w.recovery_probability; }},
    {"confidence", "current", "", "in the believed pose, smoothed", [](World& w) { return &w.confidence.current; }},
    {"confidence", "opposite", "", "in the reflection of the believed pose, smoothed",
     [](World& w) { return &w.confidence.opposite; }},
    {"confidence", "evidence", "log-odds",
     "how strongly the room speaks for the reflection of the believed pose: 4.6 is 99 in 100, 0 says "
     "nothing, below 0 it speaks for the believed pose",
     [](World& w) { return &w.confidence.evidence; }},
    {"confidence", "raw_current", "", "in the believed pose, this frame's",
     [](World& w) { return &w.confidence.raw_current; }},
    {"confidence", "raw_opposite", "", "in the reflection, this frame's",
     [](World& w) { return &w.confidence.raw_opposite; }},
    {"confidence", "goal_opponent", "", "that the robot looks at the wall behind the opponent goal",
     [](World& w) { return &w.confidence.goal_opponent; }},
    {"confidence", "goal_own", "", "that the robot looks at the wall behind its own goal",
     [](World& w) { return &w.confidence.goal_own; }},
    {"confidence", "coverage", "", "share of the wall that is trained well enough to be compared with",
     [](World& w) { return &w.confidence.coverage; }},
    {"confidence", "paired", "", "the same, together with what lies on the other side of the room",
     [](World& w) { return &w.confidence.paired; }},
    {"confidence", "distinctiveness", "",
     "how much the room differs from itself turned by half a turn; 0: it looks the same",
     [](World& w) { return &w.confidence.distinctiveness; }},
    {"confidence", "separability", "",
     "how probable it is that the room can tell a pose from its reflection; below 0.5 (room_status.separability) it "
     "counts as symmetric",
     [](World& w) { return &w.confidence.separability; }},
    {"confidence", "asymmetry", "", "former name of confidence.separability",
     [](World& w) { return &w.confidence.separability; }, "confidence.separability"},
    {"confidence", "age", "s",
     "for how long known tiles were in view since the confidences began anew: after a lift, a fall, a penalty, a told "
     "pose, a flip or a jump of the belief",
     [](World& w) { return &w.confidence.age; }},
    {"confidence", "status", "", "whether the confidences say something about the believed pose; if not, why not",
     [](World& w) { return &w.room_status; }},
    {"confidence", "can_tell", "",
     "whether the room can tell the believed pose from its reflection: it is known, not symmetric, and being compared; "
     "true while confidence.status is usable, lost or fresh",
     Computed{[](const World& w) { return can_tell(w.room_status); }, "confidence.status"}},
    {"confidence", "visible_tiles", "", "how many tiles of the wall counted in this frame",
     [](World& w) { return &w.confidence.visible_tiles; }},
    {"views", "best_yaw", "rad", "yaw of the head at which the room differs most from its reflection",
     [](World& w) { return &w.views.best_yaw; }},
    {"views", "best_score", "tiles", "how much it differs there, in tiles that count fully; 0: no tile is in reach",
     [](World& w) { return &w.views.best_score; }},
    {"views", "unknown_yaw", "rad", "yaw of the head at which most tiles are not learned yet",
     [](World& w) { return &w.views.unknown_yaw; }},
    {"views", "unknown_score", "tiles", "number of tiles that are not learned yet there",
     [](World& w) { return &w.views.unknown_score; }},
    {"views", "telling", "rad", "former name of views.best_yaw", [](World& w) { return &w.views.best_yaw; },
     "views.best_yaw"},
    {"views", "telling_worth", "tiles", "former name of views.best_score", [](World& w) { return &w.views.best_score; },
     "views.best_score"},
    {"views", "unknown", "rad", "former name of views.unknown_yaw", [](World& w) { return &w.views.unknown_yaw; },
     "views.unknown_yaw"},
    {"views", "unknown_worth", "tiles", "former name of views.unknown_score",
     [](World& w) { return &w.views.unknown_score; }, "views.unknown_score"},
    {"training", "seconds", "s", "how long the background model was trained so far, what was loaded of it included",
     [](World& w) { return &w.trained_seconds; }},
    {"training", "active", "", "it was trained in the frame before", [](World& w) { return &w.training; }},
    {"evaluation", "active", "", "it went on in the frame before", [](World& w) { return &w.evaluating; }},
    {"seen", "goal_posts", "", "how many goal posts", [](World& w) { return &w.goal_posts; }},
    {"seen", "line_points", "", "how many points on field lines", [](World& w) { return &w.line_points; }},
    {"seen", "intersections", "", "how many places where lines meet", [](World& w) { return &w.intersections; }},
    {"seen", "ball", "", "whether a ball is seen", [](World& w) { return &w.ball; }},
    {"seen", "ball_distance", "m", "how far away it is; 0 where none is seen",
     [](World& w) { return &w.ball_distance; }},
    {"seen", "ball_bearing", "rad", "where it is, positive to the left; 0 where none is seen",
     [](World& w) { return &w.ball_bearing; }},
    {"field", "length", "m", "between the goal lines", [](World& w) { return &w.field.length; }},
    {"field", "width", "m", "between the touchlines", [](World& w) { return &w.field.width; }},
    {"field", "border", "m", "carpet beyond the lines", [](World& w) { return &w.field.border; }},
    {"field", "penalty_mark_x", "m", "distance of both penalty marks from the centre",
     [](World& w) { return &w.field.penalty_mark_x; }},
    {"field", "penalty_area_depth", "m", "from the goal line", [](World& w) { return &w.field.penalty_area_depth; }},
    {"field", "penalty_area_width", "m", "along the goal line", [](World& w) { return &w.field.penalty_area_width; }},
    {"field", "goal_post_y", "m", "distance of a goal's posts from its middle",
     [](World& w) { return &w.field.goal_post_y; }},
    {"field", "corner_arc_radius", "m", "radius of the quarter circles at the corners; 0: there are none",
     [](World& w) { return &w.field.corner_arc_radius; }},
    {"field", "center_circle_radius", "m", "radius of the centre circle",
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

/// What a value of this C++ type is to a script.
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
  } else if (field.unit.empty()) {  // a share, a probability
    result.minimum = 0.0;
    result.maximum = 1.0;
  } else if (field.unit == "s") {
    result.minimum = 0.0;
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
  // Nothing destroys it: a thread that is still running when the program exits may read it.
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
    const char* const wanted = field.type == Type::boolean  ? " is true or false"
                               : field.type == Type::number ? " is a number"
                                                            : " is a string";
    throw std::runtime_error(field.full_name() + wanted);
  }
  if (field.type == Type::number) {
    const bool fits = std::isfinite(value.number) && value.number >= field.minimum && value.number <= field.maximum &&
                      (!field.is_integer || value.number == std::floor(value.number));
    if (fits) return value.number;
    const std::string range = field.maximum == 1.0 ? ", from 0 to 1" : field.minimum == 0.0 ? ", not negative" : "";
    throw std::runtime_error(field.full_name() + " is a " + (field.is_integer ? "whole" : "finite") + " number" +
                             range);
  }
  if (field.type == Type::boolean) return value.number;
  const auto found = std::find(field.names.begin(), field.names.end(), value.name);
  if (found != field.names.end()) return static_cast<double>(found - field.names.begin());
  const std::vector<std::string> known(field.names.begin(), field.names.end());
  throw std::runtime_error(field.full_name() + " cannot be '" + std::string(value.name) + "'" +
                           did_you_mean(value.name, known));
}

void write_world(World& world, std::string_view table, std::string_view name, const WorldValue& value) {
  const std::span<const WorldField> all = world_fields();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].table != table || all[i].name != name) continue;
    const double number = checked_value(all[i], value);
    std::visit(
        [&](auto access) {
          if constexpr (std::is_same_v<decltype(access), Computed>) {
            throw std::runtime_error(all[i].full_name() + " cannot be set: it follows from " +
                                     std::string(access.source));
          } else {
            auto* place = access(world);
            using Value = std::remove_pointer_t<decltype(place)>;
            if constexpr (std::is_enum_v<Value>) {
              *place = static_cast<Value>(static_cast<int>(number));
            } else {
              *place = static_cast<Value>(number);
            }
          }
        },
        kFields[i].access);
    return;
  }
  std::vector<std::string> known;
  for (const WorldField& field : all) known.push_back(field.full_name());
  const std::string wanted = std::string(table) + "." + std::string(name);
  throw std::runtime_error("the world has no " + wanted + did_you_mean(wanted, known));
}

}  // namespace reorient
