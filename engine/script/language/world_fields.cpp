#include "engine/script/language/world_fields.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

using Type = WorldField::Type;

/// Where a field lives in a world. Only tests write through it.
using Access = std::variant<double* (*)(World&), bool* (*)(World&), int* (*)(World&), std::uint64_t* (*)(World&)>;

struct BoundField {
  std::string_view table;
  std::string_view name;
  std::string_view unit;
  std::string_view description;
  Access access;
};

constexpr WorldTable kTables[] = {
    {"clock", "Time."},
    {"robot", "The robot's own body."},
    {"pose", "Where the robot believes that it is, in the field's frame: x towards the opponent goal, y to the left."},
    {"confidence", "What room awareness says about the believed pose; all from 0 to 1 unless said."},
    {"training", "The background model of the room."},
    {"evaluation", "The comparison of what is seen with the background model."},
    {"seen", "What was seen of the field in this frame."},
    {"field", "The field as drawn, to the centres of its lines; the origin is its centre."},
};

const BoundField kFields[] = {
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
};

Type type_of(const BoundField& field) {
  return std::holds_alternative<bool* (*)(World&)>(field.access) ? Type::boolean : Type::number;
}

std::vector<WorldField> make_fields() {
  std::vector<WorldField> fields;
  for (const BoundField& field : kFields)
    fields.push_back({field.table, field.name, field.unit, field.description, type_of(field), {}});
  return fields;
}

}  // namespace

std::span<const WorldField> world_fields() {
  static const std::vector<WorldField> fields = make_fields();
  return fields;
}

std::span<const WorldTable> world_tables() { return kTables; }

void append_world(const World& world, std::vector<double>& values) {
  // The accessors only hand out addresses; nothing is written through them here.
  auto& readable = const_cast<World&>(world);
  for (const BoundField& field : kFields) {
    values.push_back(std::visit([&](auto access) { return static_cast<double>(*access(readable)); }, field.access));
  }
}

double checked_value(const WorldField& field, const WorldValue& value) {
  if (field.type != value.type) {
    const char* const wanted = field.type == Type::boolean  ? " is true or false"
                               : field.type == Type::number ? " is a number"
                                                            : " is a string";
    throw std::runtime_error(field.full_name() + wanted);
  }
  if (field.type != Type::name) return value.number;
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
          auto* place = access(world);
          *place = static_cast<std::remove_pointer_t<decltype(place)>>(number);
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
