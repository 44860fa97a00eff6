// SPDX-License-Identifier: MIT
// The recordings of a game: `reorient game --record FOLDER` writes a file for each robot.
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "program/game/game_options.h"
#include "program/game/soccer_game.h"
#include "program/run/run_recording.h"

namespace reorient {

/// "blue_1": of its recording.
std::string file_stem_of(const GameRobot& robot);

class GameRecording {
 public:
  /// Begins a recording of each robot, if the options name a folder. The game must not be stepped after the end of this
  /// object. Throws std::runtime_error with one line.
  GameRecording(const GameOptions& options, SoccerGame& game);

  /// Call it after each step: prints what the recorders report. A game has no real time, so it waits here for recorders
  /// that are slower than the game. A disk that does not respond delays it once.
  void keep_up(std::ostream& err);
  /// Ends all files, and prints what they contain.
  void end(std::ostream& out, std::ostream& err);

 private:
  struct OfRobot {
    std::vector<std::string> reports;  // written on the thread of the robot's frame
    std::unique_ptr<RunRecording> recording;
    bool is_waited_for = true;
  };
  static void print_reports(OfRobot& robot, std::ostream& err);

  const SoccerGame& game_;
  std::vector<std::unique_ptr<OfRobot>> robots_;  // in the order of the game; empty: nothing is recorded
};

}  // namespace reorient
