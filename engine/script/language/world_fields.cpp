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

const WorldField kFields[] = {
    {"clock", "time", "s", "since the robot was switched on", [](World& w) { return &w.time; }},
    {"clock", "step", "s", "since the frame before", [](World& w) { return &w.time_step; }},
    {"clock", "frame", "", "number of this frame", [](World& w) { return &w.frame; }},
    {"robot", "fallen", "", "the torso lies", [](World& w) { return &w.fallen; }},
    {"robot", "carried", "", "there is no load on the feet: somebody carries it", [](World& w) { return &w.carried; }},
    {"robot", "penalized", "", "the referee has taken it out of the game", [](World& w) { return &w.penalized; }},
    {"robot", "head_yaw", "rad", "measured angle of the head, to the left", [](World& w) { return &w.head.yaw; }},
    {"robot", "head_pitch", "rad", "measured angle of the head, downwards", [](World& w) { return &w.head.pitch; }},
    {"pose", "x", "m", "towards the opponent goal", [](World& w) { return &w.pose.pose.position.x(); }},
    {"pose", "y", "m", "to the left", [](World& w) { return &w.pose.pose.position.y(); }},
    {"pose", "rotation", "rad", "0 looks towards the opponent goal, positive turns left",
     [](World& w) { return &w.pose.pose.rotation; }},
    {"pose", "known", "", "somebody told where the robot stands, or the pose filter has found it",
     [](World& w) { return &w.pose_known; }},
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
    {"confidence", "distinctiveness", "",
     "how much the room differs from itself turned by half a turn; 0: it looks the same",
     [](World& w) { return &w.confidence.distinctiveness; }},
    {"confidence", "visible_tiles", "", "how many tiles of the wall counted in this frame",
     [](World& w) { return &w.confidence.visible_tiles; }},
    {"training", "seconds", "s", "how long the background model was trained so far",
     [](World& w) { return &w.trained_seconds; }},
    {"training", "active", "", "it was trained in the frame before", [](World& w) { return &w.training; }},
    {"evaluation", "active", "", "it went on in the frame before", [](World& w) { return &w.evaluating; }},
    {"seen", "goal_posts", "", "how many goal posts", [](World& w) { return &w.goal_posts; }},
    {"seen", "line_points", "", "how many points on field lines", [](World& w) { return &w.line_points; }},
    {"field", "length", "m", "between the goal lines", [](World& w) { return &w.field.length; }},
    {"field", "width", "m", "between the touchlines", [](World& w) { return &w.field.width; }},
    {"field", "border", "m", "carpet beyond the lines", [](World& w) { return &w.field.border; }},
    {"field", "penalty_mark_x", "m", "distance of both penalty marks from the centre",
     [](World& w) { return &w.field.penalty_mark_x; }},
    {"field", "penalty_area_depth", "m", "from the goal line", [](World& w) { return &w.field.penalty_area_depth; }},
    {"field", "penalty_area_width", "m", "along the goal line", [](World& w) { return &w.field.penalty_area_width; }},
    {"field", "goal_post_y", "m", "distance of a goal's posts from its middle",
     [](World& w) { return &w.field.goal_post_y; }},
    {"field", "center_circle_radius", "m", "radius of the centre circle",
     [](World& w) { return &w.field.center_circle_radius; }},
    {"truth", "x", "m", "towards the opponent goal", truth_x, true},
    {"truth", "y", "m", "to the left", truth_y, true},
    {"truth", "rotation", "rad", "0 looks towards the opponent goal, positive turns left", truth_rotation, true},
    {"truth", "fallen", "", "the robot really lies", truth_fallen, true},
    {"truth", "carried", "", "the robot really hangs in the air", truth_carried, true},
};

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
