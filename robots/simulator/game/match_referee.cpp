// SPDX-License-Identifier: MIT
#include "robots/simulator/game/match_referee.h"

#include <algorithm>
#include <cmath>

#include "robots/simulator/ball/field_exit.h"

namespace reorient {

MatchReferee::Decision MatchReferee::advance(double time_step, const RollingBall& ball, std::optional<int> touched_by) {
  if (state_ == GameState::finished) return {};
  time_ += time_step;
  since_ += time_step;
  untouched_for_ += time_step;
  if (touched_by) {
    last_touch_ = *touched_by;
    untouched_for_ = 0.0;
  }
  // The same moment for every frame rate, despite rounding.
  constexpr double kRounding = 1e-9;  // s
  if (time_ + kRounding >= duration_) return enter(GameState::finished, MatchEvent::finished);
  return state_ == GameState::playing ? judge(ball) : follow_states();
}

MatchReferee::Decision MatchReferee::enter(GameState state, MatchEvent event) {
  state_ = state;
  since_ = 0.0;
  untouched_for_ = 0.0;
  Decision decision{event, std::nullopt, kicking_team_};
  if (state == GameState::set) decision.ball = Eigen::Vector2d::Zero();
  return decision;
}

MatchReferee::Decision MatchReferee::follow_states() {
  if (state_ == GameState::initial && since_ >= parameters_.initial_time)
    return enter(GameState::ready, MatchEvent::ready);
  if (state_ == GameState::ready && since_ >= parameters_.ready_time) return enter(GameState::set, MatchEvent::set);
  if (state_ == GameState::set && since_ >= parameters_.set_time) return enter(GameState::playing, MatchEvent::playing);
  return {};
}

MatchReferee::Decision MatchReferee::judge(const RollingBall& ball) {
  const std::optional<FieldExit> exit = exit_of(ball, field_);
  if (!exit) {
    if (untouched_for_ < parameters_.stuck_time) return {};
    untouched_for_ = 0.0;
    return {MatchEvent::stuck, Eigen::Vector2d(0.0, 0.0), last_touch_};
  }
  untouched_for_ = 0.0;
  const Eigen::Vector2d half = field_half_size(field_);
  if (exit->line == FieldExit::Line::goal) {
    const int scoring = exit->side > 0.0 ? 0 : 1;
    ++score_[static_cast<std::size_t>(scoring)];
    kicking_team_ = 1 - scoring;
    Decision decision = enter(GameState::ready, MatchEvent::goal);
    decision.team = scoring;
    return decision;
  }
  if (exit->line == FieldExit::Line::touchline)
    return {MatchEvent::touchline,
            Eigen::Vector2d(std::clamp(ball.position.x(), -half.x(), half.x()), exit->side * half.y()),
            1 - last_touch_};
  const int defending = exit->side > 0.0 ? 1 : 0;
  const double left = std::copysign(1.0, ball.position.y());
  if (last_touch_ == defending)
    return {MatchEvent::corner_kick, Eigen::Vector2d(exit->side * half.x(), left * half.y()), 1 - defending};
  return {MatchEvent::goal_kick,
          Eigen::Vector2d(exit->side * (half.x() - field_.goal_area_depth), left * 0.5 * field_.goal_area_width),
          defending};
}

RefereeState MatchReferee::state_for(int team) const {
  RefereeState referee;
  referee.state = state_;
  referee.kick_off = team == kicking_team_ ? KickOff::ours : KickOff::theirs;
  return referee;
}

}  // namespace reorient
