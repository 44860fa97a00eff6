// SPDX-License-Identifier: MIT
// The referee of a simulated game: the states of the game, goals, and the ball that is put back when it is out. Free
// kicks, penalties and positions at the kick-off are not judged.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "geometry/field_dimensions.h"
#include "robots/referee.h"
#include "robots/simulator/ball/rolling_ball.h"

namespace reorient {

struct MatchParameters {
  double initial_time = 2.0;
  double ready_time = 5.0;
  double set_time = 3.0;
  double stuck_time = 30.0;
};

template <typename Visit>
void describe(MatchParameters& p, Visit&& visit) {
  visit("initial_time", p.initial_time, 0.0, 600.0, "s", "duration of the game state 'initial' at the start");
  visit("ready_time", p.ready_time, 0.0, 600.0, "s",
        "duration of the game state 'ready', after which the robots are placed for the kick-off");
  visit("set_time", p.set_time, 0.0, 600.0, "s", "duration of the game state 'set' before each kick-off");
  visit("stuck_time", p.stuck_time, 1.0, 3600.0, "s",
        "time in which no robot touches the ball, after which the referee puts it on the center mark");
}

enum class MatchEvent { ready, set, playing, finished, goal, touchline, goal_kick, corner_kick, stuck };

/// Team 0 attacks the goal at positive x, team 1 that at negative x.
class MatchReferee {
 public:
  /// `duration`: s, from the start of the state 'initial'. `first_kick_off`: team.
  MatchReferee(const MatchParameters& parameters, const FieldDimensions& field, double duration, int first_kick_off)
      : parameters_(parameters), field_(field), duration_(duration), kicking_team_(first_kick_off) {}

  struct Decision {
    std::optional<MatchEvent> event;
    std::optional<Eigen::Vector2d> ball;  ///< where the referee puts the ball, m
    int team = 0;                         ///< which scored or kicks next, for the event
  };
  /// Advances by `time_step` seconds. `touched_by`: team that touched the ball since the last call.
  Decision advance(double time_step, const RollingBall& ball, std::optional<int> touched_by);

  GameState state() const { return state_; }
  /// The game from the view of a team.
  RefereeState state_for(int team) const;
  const std::array<int, 2>& score() const { return score_; }

 private:
  Decision enter(GameState state, MatchEvent event);
  Decision follow_states();
  Decision judge(const RollingBall& ball);

  MatchParameters parameters_;
  FieldDimensions field_;
  double duration_;
  int kicking_team_;
  GameState state_ = GameState::initial;
  double time_ = 0.0, since_ = 0.0, untouched_for_ = 0.0;  // s; since_: in this state
  int last_touch_ = 0;                                     // team
  std::array<int, 2> score_{};
};

}  // namespace reorient
