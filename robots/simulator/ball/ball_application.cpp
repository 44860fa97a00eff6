// SPDX-License-Identifier: MIT
#include "robots/simulator/ball/ball_application.h"

#include <algorithm>
#include <string_view>

namespace reorient {
namespace {

std::optional<std::uint16_t> value_of(const ApplicationInterface& declared, std::string_view name, FieldType type) {
  for (std::size_t i = 0; i < declared.values.size(); ++i) {
    const DeclaredValue& value = declared.values[i];
    if (value.name == name && !value.is_list() && value.fields.size() == 1 && value.fields[0].type == type)
      return static_cast<std::uint16_t>(i);
  }
  return std::nullopt;
}

}  // namespace

BallApplication::BallApplication(const ApplicationInterface& declared)
    : seen_(value_of(declared, "ball.seen", FieldType::boolean)),
      position_(value_of(declared, "ball.position", FieldType::point)),
      distance_(value_of(declared, "ball.distance", FieldType::number)) {
  if (distance_) {
    least_ = declared.values[*distance_].fields[0].minimum;
    most_ = declared.values[*distance_].fields[0].maximum;
  }
  for (std::size_t i = 0; i < declared.actions.size(); ++i) {
    if (declared.actions[i].name != "kick") continue;
    kick_ = static_cast<std::uint16_t>(i);
    std::size_t numbers = 0, texts = 0;
    for (const DeclaredField& argument : declared.actions[i].arguments) {
      if (argument.name == "foot" && argument.type == FieldType::text) foot_ = {true, texts};
      if (argument.name == "direction" && argument.type == FieldType::number) direction_ = {true, numbers};
      numbers += numbers_of(argument.type);
      texts += texts_of(argument.type);
    }
  }
}

void BallApplication::report_ball(const std::optional<Eigen::Vector2d>& ball, ExternalInputs& external) const {
  if (seen_) external.values.push_back({*seen_, 1, {{ball ? 1.0 : 0.0}, {}}});
  if (!ball) return;
  if (position_) external.values.push_back({*position_, 1, {{ball->x(), ball->y()}, {}}});
  if (distance_) external.values.push_back({*distance_, 1, {{std::clamp(ball->norm(), least_, most_)}, {}}});
}

void BallApplication::begin(std::span<const StartedAction> actions, Kick& kick) {
  for (const StartedAction& action : actions) {
    if (kick_ != action.action) continue;
    id_ = action.id;
    Foot foot = Foot::nearest;
    if (foot_.is_declared && action.arguments.texts.at(foot_.offset) == "left") foot = Foot::left;
    if (foot_.is_declared && action.arguments.texts.at(foot_.offset) == "right") foot = Foot::right;
    kick.begin(foot, direction_.is_declared ? action.arguments.numbers.at(direction_.offset) : 0.0);
  }
}

void BallApplication::take(const Kick::Progress& progress) {
  if (progress.state) reports_.push_back({id_, *progress.state, progress.reason});
}

void BallApplication::report_kick(ExternalInputs& external) {
  external.reports.insert(external.reports.end(), reports_.begin(), reports_.end());
  reports_.clear();
}

}  // namespace reorient
