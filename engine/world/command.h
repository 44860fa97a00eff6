// Commands from behaviours to the core (the paper's Section 3.1), and what became of them.
#pragma once

#include <string>
#include <string_view>

namespace reorient {

enum class Command { flip_pose, purge_reflection, reset_orientation, pause_training, pause_evaluation };

std::string_view to_string(Command command);

/// A behaviour's wish, in the frame in which it was issued.
struct CommandRequest {
  Command command = Command::flip_pose;
  std::string issuer;     ///< behaviour
  std::string state;      ///< path of its state, e.g. "watching/doubtful"
  std::string reason;     ///< the `because` of the transition that led there
  double priority = 0.0;  ///< the behaviour's; the greater wins
};

/// A pause that holds as long as the state in which it was issued.
struct Lease {
  Command command = Command::pause_training;  ///< or pause_evaluation
  std::string issuer;
  std::string state;
  std::string reason;
  double priority = 0.0;
};

enum class Verdict { granted, outranked, too_soon, not_allowed };

std::string_view to_string(Verdict verdict);

/// One line of the timeline.
struct CommandRecord {
  double time = 0.0;  ///< s
  CommandRequest request;
  Verdict verdict = Verdict::granted;
};

}  // namespace reorient
