// SPDX-License-Identifier: MIT
// What a user requests of a run while it runs, at the prompt or in a viewer: actions of the operator, and the pace. The
// run loop carries the actions out between two frames. Not synchronized: all calls come from the thread of the frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/field_dimensions.h"
#include "workbench/run/run_pace.h"
#include "workbench/scenario/scenario_language.h"

namespace reorient {

/// The names of who requests an action, in timelines and recordings.
inline constexpr std::string_view kOperatorName = "operator";  ///< at the prompt
inline constexpr std::string_view kViewerName = "viewer";

struct OperatorRequest {
  /// Its pose is in the axes of the robot's team, as the poses of a scenario.
  OperatorAction action{};
  bool mirrors = false;  ///< lifts the robot and places it at its mirrored true pose; `action` is put_down

  /// "put_down", "mirror"
  std::string_view name() const;
  /// "put_down at x 1.00 m, y -2.00 m, 90.0 degrees"
  std::string text() const;
};

/// The actions that a user may request, as scenarios name them, and `mirror`.
const std::vector<std::string>& operator_request_names();

/// The values of a request as a user gives them.
struct OperatorRequestValues {
  std::optional<double> x, y;     ///< m
  std::optional<double> degrees;  ///< rotation
  std::optional<double> stops;    ///< powers of two
  std::optional<bool> penalized;  ///< nothing: true
};

inline constexpr double kMostStops = 8.0;

/// Throws std::runtime_error with one line if the name is unknown, or if a value is missing or out of range.
OperatorRequest operator_request(std::string_view name, const OperatorRequestValues& values);

class RunControls {
 public:
  /// `has_operator`: this program can lift and place the robot, and knows its true pose. `sets_pace`: this program sets
  /// the pace of the run.
  RunControls(bool has_operator, bool sets_pace) : has_operator_(has_operator), sets_pace_(sets_pace) {}

  /// Limits the poses of later requests to this field and what is around it.
  void set_field(const FieldDimensions& field) { field_ = field; }

  bool has_operator() const { return has_operator_; }
  bool sets_pace() const { return sets_pace_; }

  /// Adds an action, which is carried out just before the next frame. `issuer`: kOperatorName or kViewerName. Returns
  /// its number. Throws std::runtime_error with one line if the robot has no operator, if its place is far beside the
  /// field, or if too many actions wait.
  std::uint64_t request(OperatorRequest request, std::string_view issuer);
  bool is_carried_out(std::uint64_t number) const { return number <= carried_out_; }
  std::size_t waiting() const { return requests_.size(); }

  /// The pace, to change it; `action`: the user's word for the change. Throws std::runtime_error with one line if this
  /// program does not set the pace of the run.
  RunPace& change_pace(std::string_view action);
  void set_speed(double speed);  ///< also throws for a number from outside the range
  void take_frames(int count);   ///< the same

  // Of the run loop:

  struct Issued {
    OperatorRequest request;
    std::string_view issuer;
  };
  std::vector<Issued> take();
  RunPace& pace() { return pace_; }
  const RunPace& pace() const { return pace_; }

 private:
  static constexpr std::size_t kMostWaiting = 100;

  bool has_operator_, sets_pace_;
  std::optional<FieldDimensions> field_;
  RunPace pace_;
  std::vector<Issued> requests_;
  std::uint64_t carried_out_ = 0;  ///< the number of the last action that was
};

}  // namespace reorient
