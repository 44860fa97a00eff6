// SPDX-License-Identifier: MIT
#include "program/robots.h"

#include <functional>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/parameter_registry.h"
#include "robots/simulator/simulator.h"

namespace reorient {
namespace {

/// All parameters of the simulator.
struct SimulatorTuning {
  explicit SimulatorTuning(const RobotOptions& options)
      : simulator(simulator_parameters_of(options.body)), room_shape(room_shape_for(options.field)) {
    simulator.width = options.width;
    simulator.cameras = options.both_cameras ? Cameras::both : Cameras::upper;
    for (const ParameterChange& change : options.parameters) registry.set_early(change);
    registry.bind("simulator", simulator);
    registry.bind("body", simulator.body);
    registry.bind("sensor", simulator.sensor);
    registry.bind("light", simulator.light);
    registry.bind("room_shape", room_shape);
    registry.bind("furniture", simulator.furniture);
    registry.bind("ball_physics", simulator.ball_physics);
    registry.bind("ball_sensor", simulator.ball_sensor);
    registry.bind("kick", simulator.kick);
    registry.bind("match", rules.match);
    registry.bind("network", rules.network);
    registry.bind("collisions", rules.collisions);
    rules.ball = simulator.ball_physics;
  }

  SimulatorParameters simulator;
  RoomShape room_shape;
  GameRules rules;
  ParameterRegistry registry;
};

std::unique_ptr<Simulator> simulator_of(const RobotOptions& options,
                                        const std::function<void(SimulatorParameters&)>& change) {
  SimulatorTuning tuning(options);
  change(tuning.simulator);
  const FieldDimensions& field = options.field;
  const Pose2 beside_the_field(-field.penalty_mark_x, -0.5 * field.width - 0.5, kPi / 2.0);
  RoomCache own;
  RoomCache& rooms = options.rooms != nullptr ? *options.rooms : own;
  const Room& room = rooms.room(options.room, options.hall_seed, tuning.room_shape);
  auto simulator =
      std::make_unique<Simulator>(tuning.simulator, options.body, field, room, beside_the_field, options.seed);
  if (!options.application.is_empty()) simulator->play_application(options.application);
  return simulator;
}

RobotInstance make_simulator(const RobotOptions& options) {
  std::unique_ptr<Simulator> simulator = simulator_of(options, [](SimulatorParameters&) {});
  Simulator* const itself = simulator.get();
  return {std::move(simulator), itself->body(), RobotInstance::Clock::simulated, itself, itself};
}

struct Maker {
  const char* name;
  const char* description;
  RobotInstance (*make)(const RobotOptions&);
  std::vector<Parameter> (*parameters)(const RobotOptions&);
};

constexpr Maker kMakers[] = {
    {kSimulator, "The simulator.", make_simulator,
     [](const RobotOptions& options) { return SimulatorTuning(options).registry.list(); }},
    {kFootage, "Recorded images instead of a robot.",
     [](const RobotOptions&) -> RobotInstance {
       throw std::runtime_error("robot 'footage': expected no scenario, since footage is recorded");
     },
     [](const RobotOptions&) { return std::vector<Parameter>(); }},
    {kCompanion, "Another program that controls the robot.",
     [](const RobotOptions&) -> RobotInstance {
       throw std::runtime_error("robot 'companion': expected no scenario, since the program cannot move the robot");
     },
     [](const RobotOptions&) { return std::vector<Parameter>(); }},
    {kNao, "This program runs on the NAO.",
     [](const RobotOptions&) -> RobotInstance {
       throw std::runtime_error("robot 'nao': expected no scenario, since the program cannot move it");
     },
     [](const RobotOptions&) { return std::vector<Parameter>(); }},
};

const Maker& maker_of(const std::string& name) {
  for (const Maker& maker : kMakers) {
    if (maker.name == name) return maker;
  }
  throw std::runtime_error("unknown robot '" + name + "'" + did_you_mean(name, robot_names()));
}

}  // namespace

const Room& RoomCache::room(const std::string& file, std::uint64_t hall_seed, const RoomShape& shape) {
  std::string source = file.empty() ? "hall " + std::to_string(hall_seed) : "file " + file;
  RoomShape copy = shape;
  ParameterRegistry registry;
  registry.bind("room_shape", copy);
  for (const Parameter& parameter : registry.list()) source.append(" ").append(to_text(parameter.value));
  if (source != made_from_) {
    made_from_.clear();
    room_ = file.empty() ? procedural_hall(hall_seed, shape) : load_room(file, shape);
    made_from_ = std::move(source);
  }
  return room_;
}

std::vector<std::string> robot_names() {
  std::vector<std::string> names;
  for (const Maker& maker : kMakers) names.emplace_back(maker.name);
  return names;
}

std::string robot_description(const std::string& name) { return maker_of(name).description; }

std::unique_ptr<Simulator> make_labeled_simulator(const RobotOptions& options) {
  return simulator_of(options, [](SimulatorParameters& parameters) { parameters.labels = true; });
}

std::unique_ptr<Simulator> make_player(const RobotOptions& options, std::uint64_t surroundings_seed) {
  return simulator_of(options, [&](SimulatorParameters& parameters) {
    parameters.other_robots = 0;
    parameters.surroundings_seed = surroundings_seed;
  });
}

GameRules game_rules(const RobotOptions& options) { return SimulatorTuning(options).rules; }

RobotInstance make_robot(const std::string& name, const RobotOptions& options) { return maker_of(name).make(options); }

std::vector<Parameter> robot_parameters(const std::string& name, const RobotOptions& options) {
  return maker_of(name).parameters(options);
}

}  // namespace reorient
