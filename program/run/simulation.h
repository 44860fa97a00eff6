// SPDX-License-Identifier: MIT
// A scenario with its robot, ready to run.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "geometry/field_dimensions.h"
#include "program/robots.h"
#include "program/run/run_options.h"
#include "program/run/venue.h"
#include "robots/robot_instance.h"
#include "workbench/run/run_loop.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// What a simulation uses besides the values of its options.
struct LoadedFiles {
  Venue venue;
  std::map<std::string, std::uint64_t> scripts;  ///< digests of the loaded scripts, by their names
  std::set<std::string> parameters;              ///< names of the parameters of these scripts and of the robot
  std::set<std::string> states;                  ///< of all machines, as "orientation/correcting"
  std::set<std::string> actions;                 ///< of the application
};

class Simulation {
 public:
  /// `rooms`: cache for the next simulations. Throws std::runtime_error (of scripts: ScriptError) with one
  /// line on bad input.
  explicit Simulation(const SimulationOptions& options, RoomCache* rooms = nullptr)
      : Simulation(options, rooms, true) {}
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Throws what a simulation would throw, except for mistakes in its room, which takes a while to create. Use it
  /// before many simulations.
  static LoadedFiles check(const SimulationOptions& options,
                           const std::function<void(const ScenarioHost& scenario)>& more = {});

  /// For a RunLoop, to which observers and sources are added.
  RunParts parts();

  const Venue& venue() const { return venue_; }
  const FieldDimensions& field() const { return field_; }
  /// The model at the start, in the axes of the team; nothing without a model.
  const std::optional<SavedModel>& model() const { return model_; }
  FrameLoop& engine() { return *engine_; }
  ScenarioHost& scenario() { return *scenario_; }
  /// The present parameters of the engine, the scenario and the robot, by name.
  std::vector<Parameter> parameters() const;
  /// Values in parameter files for scripts and robots that are not in this run.
  std::vector<ParameterChange> kept_parameters() const;

 private:
  Simulation(const SimulationOptions& options, RoomCache* rooms, bool makes_robot);

  RecordedBehaviors behaviors_;
  std::set<std::string> files_;  ///< scenario and behaviors
  std::unique_ptr<ScenarioHost> scenario_;
  Venue venue_;
  FieldDimensions field_;
  RobotInstance robot_;
  std::vector<Parameter> robot_parameters_;
  std::optional<SavedModel> model_;
  std::unique_ptr<FrameLoop> engine_;
  std::vector<ParameterChange> kept_parameters_;
  double longest_;  ///< s
};

/// The model in the file of the options, rotated if requested; nothing without a file. Throws std::runtime_error with
/// one line if the file is not a model, so that it is not overwritten either.
std::optional<SavedModel> model_to_begin_with(const SimulationOptions& options);

/// The parameters of several owners as one list, by name. A parameter of two owners, as of a shared library, is listed
/// once, with the value of the first owner.
std::vector<Parameter> merged(std::vector<std::vector<Parameter>> lists);

}  // namespace reorient
