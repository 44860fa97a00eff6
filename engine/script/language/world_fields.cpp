#include "engine/script/language/world_fields.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

double* truth_x(World& world) { return world.truth ? &world.truth->pose.position.x() : nullptr; }
double* truth_y(World& world) { return world.truth ? &world.truth->pose.position.y() : nullptr; }
double* truth_rotation(World& world) { return world.truth ? &world.truth->pose.rotation : nullptr; }
bool* truth_fallen(World& world) { return world.truth ? &world.truth->fallen : nullptr; }
bool* truth_carried(World& world) { return world.truth ? &world.truth->carried : nullptr; }

constexpr WorldTable kTables[] = {
    {"clock", "Time."},
    {"robot", "The robot's own body."},
    {"pose", "Where the robot believes that it is, in the field's frame: x towards the opponent goal, y to the left."},
    {"confidence", "What room awareness says about the believed pose; all from 0 to 1 unless said."},
    {"training", "The background model of the room."},
    {"evaluation", "The comparison of what is seen with the background model."},
    {"seen", "What was seen of the field in this frame."},
    {"field", "The field as drawn, to the centres of its lines; the origin is its centre."},
    {"truth", "Where the robot really is; only where a simulator or a tracking camera knows."},
};

#define REORIENT_FIELD(member) [](World& w) { return &w.member; }

const WorldField kFields[] = {
    {"clock", "time", "s", "since the robot was switched on", REORIENT_FIELD(time)},
    {"clock", "step", "s", "since the frame before", REORIENT_FIELD(time_step)},
    {"clock", "frame", "", "number of this frame", REORIENT_FIELD(frame)},
    {"robot", "fallen", "", "the torso lies", REORIENT_FIELD(fallen)},
    {"robot", "carried", "", "there is no load on the feet: somebody carries it", REORIENT_FIELD(carried)},
    {"robot", "penalized", "", "the referee has taken it out of the game", REORIENT_FIELD(penalized)},
    {"robot", "head_yaw", "rad", "measured angle of the head, to the left", REORIENT_FIELD(head.yaw)},
    {"robot", "head_pitch", "rad", "measured angle of the head, downwards", REORIENT_FIELD(head.pitch)},
    {"pose", "x", "m", "towards the opponent goal", REORIENT_FIELD(pose.pose.position.x())},
    {"pose", "y", "m", "to the left", REORIENT_FIELD(pose.pose.position.y())},
    {"pose", "rotation", "rad", "0 looks towards the opponent goal, positive turns left",
     REORIENT_FIELD(pose.pose.rotation)},
    {"pose", "known", "", "somebody told where the robot stands, or the pose filter has found it",
     REORIENT_FIELD(pose_known)},
    {"pose", "share", "", "of all pose particles, in the cluster that is believed", REORIENT_FIELD(pose.share)},
    {"pose", "reflected_share", "", "of all pose particles, near the reflection of the believed pose",
     REORIENT_FIELD(pose.reflected_share)},
    {"confidence", "current", "", "in the believed pose, smoothed", REORIENT_FIELD(confidence.current)},
    {"confidence", "opposite", "", "in the reflection of the believed pose, smoothed",
     REORIENT_FIELD(confidence.opposite)},
    {"confidence", "raw_current", "", "in the believed pose, this frame's", REORIENT_FIELD(confidence.raw_current)},
    {"confidence", "raw_opposite", "", "in the reflection, this frame's", REORIENT_FIELD(confidence.raw_opposite)},
    {"confidence", "goal_opponent", "", "that the robot looks at the wall behind the opponent goal",
     REORIENT_FIELD(confidence.goal_opponent)},
    {"confidence", "goal_own", "", "that the robot looks at the wall behind its own goal",
     REORIENT_FIELD(confidence.goal_own)},
    {"confidence", "coverage", "", "share of the wall that is trained well enough to be compared with",
     REORIENT_FIELD(confidence.coverage)},
    {"confidence", "informative", "",
     "how much the room differs from itself turned by half a turn; 0: it looks the same",
     REORIENT_FIELD(confidence.informative)},
    {"confidence", "visible_tiles", "", "how many tiles of the wall counted in this frame",
     REORIENT_FIELD(confidence.visible_tiles)},
    {"training", "seconds", "s", "how long the background model was trained so far", REORIENT_FIELD(trained_seconds)},
    {"training", "active", "", "it was trained in the frame before", REORIENT_FIELD(training)},
    {"evaluation", "active", "", "it went on in the frame before", REORIENT_FIELD(evaluating)},
    {"seen", "goal_posts", "", "how many goal posts", REORIENT_FIELD(goal_posts)},
    {"seen", "line_points", "", "how many points on field lines", REORIENT_FIELD(line_points)},
    {"field", "length", "m", "between the goal lines", REORIENT_FIELD(field.length)},
    {"field", "width", "m", "between the touchlines", REORIENT_FIELD(field.width)},
    {"field", "border", "m", "carpet beyond the lines", REORIENT_FIELD(field.border)},
    {"field", "penalty_mark_x", "m", "distance of both penalty marks from the centre",
     REORIENT_FIELD(field.penalty_mark_x)},
    {"field", "penalty_area_depth", "m", "from the goal line", REORIENT_FIELD(field.penalty_area_depth)},
    {"field", "penalty_area_width", "m", "along the goal line", REORIENT_FIELD(field.penalty_area_width)},
    {"field", "goal_post_y", "m", "distance of a goal's posts from its middle", REORIENT_FIELD(field.goal_post_y)},
    {"field", "center_circle_radius", "m", "radius of the centre circle", REORIENT_FIELD(field.center_circle_radius)},
    {"truth", "x", "m", "towards the opponent goal", truth_x, true},
    {"truth", "y", "m", "to the left", truth_y, true},
    {"truth", "rotation", "rad", "0 looks towards the opponent goal, positive turns left", truth_rotation, true},
    {"truth", "fallen", "", "the robot really lies", truth_fallen, true},
    {"truth", "carried", "", "the robot really hangs in the air", truth_carried, true},
};

#undef REORIENT_FIELD

double as_number(const WorldField& field, World& world) {
  return std::visit(
      [&](auto access) {
        const auto* value = access(world);
        return value == nullptr ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(*value);
      },
      field.access);
}

}  // namespace

std::span<const WorldField> world_fields() { return kFields; }

std::span<const WorldTable> world_tables() { return kTables; }

void read_world(const World& world, std::vector<double>& values) {
  values.resize(std::size(kFields));
  // The accessors only hand out addresses; nothing is written through them here.
  auto& readable = const_cast<World&>(world);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = as_number(kFields[i], readable);
}

void write_world(World& world, std::string_view table, std::string_view name, double value, bool is_boolean) {
  std::vector<std::string> known;
  for (const WorldField& field : kFields) {
    if (field.table != table || field.name != name) {
      known.push_back(field.full_name());
      continue;
    }
    if (field.is_boolean() != is_boolean) {
      throw std::runtime_error(field.full_name() + (is_boolean ? " is a number" : " is true or false"));
    }
    if (table == "truth" && !world.truth) world.truth.emplace();
    std::visit(
        [&](auto access) {
          auto* place = access(world);
          *place = static_cast<std::remove_pointer_t<decltype(place)>>(value);
        },
        field.access);
    return;
  }
  const std::string wanted = std::string(table) + "." + std::string(name);
  throw std::runtime_error("the world has no " + wanted + did_you_mean(wanted, known));
}

}  // namespace reorient
