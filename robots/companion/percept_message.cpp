// SPDX-License-Identifier: MIT
#include "robots/companion/percept_message.h"

#include <algorithm>
#include <iterator>

namespace reorient {
namespace {

static_assert(static_cast<int>(PerceptType::line) == REORIENT_PERCEPT_LINE &&
              static_cast<int>(PerceptType::line_point) == REORIENT_PERCEPT_LINE_POINT &&
              static_cast<int>(PerceptType::goal_post) == REORIENT_PERCEPT_GOAL_POST &&
              static_cast<int>(PerceptType::l_intersection) == REORIENT_PERCEPT_L &&
              static_cast<int>(PerceptType::t_intersection) == REORIENT_PERCEPT_T &&
              static_cast<int>(PerceptType::x_intersection) == REORIENT_PERCEPT_X &&
              static_cast<int>(PerceptType::penalty_mark) == REORIENT_PERCEPT_PENALTY_MARK &&
              static_cast<int>(PerceptType::center_circle) == REORIENT_PERCEPT_CENTER_CIRCLE &&
              static_cast<int>(PerceptType::ball) == REORIENT_PERCEPT_BALL &&
              static_cast<int>(PerceptType::robot) == REORIENT_PERCEPT_ROBOT &&
              static_cast<int>(PerceptType::person) == REORIENT_PERCEPT_PERSON);
static_assert(static_cast<int>(PerceptSpace::ground) == REORIENT_ON_GROUND &&
              static_cast<int>(PerceptSpace::upper_image) == REORIENT_IN_UPPER_IMAGE &&
              static_cast<int>(PerceptSpace::lower_image) == REORIENT_IN_LOWER_IMAGE);
static_assert(kMostExternalPercepts == REORIENT_MOST_PERCEPTS);

ExternalPercept percept_of(const reorient_percept& sent) {
  ExternalPercept percept;
  percept.type = static_cast<PerceptType>(sent.what);
  percept.space = static_cast<PerceptSpace>(sent.space);
  percept.confidence = static_cast<double>(sent.confidence);
  std::copy(std::begin(sent.at), std::end(sent.at), percept.at.begin());
  percept.base_hidden = (sent.has & REORIENT_PERCEPT_BASE_HIDDEN) != 0;
  if ((sent.has & REORIENT_PERCEPT_DIRECTION) != 0) percept.direction = static_cast<double>(sent.direction);
  if ((sent.has & REORIENT_PERCEPT_COVARIANCE) != 0) {
    std::array<double, 3>& covariance = percept.covariance.emplace();
    std::copy(std::begin(sent.covariance), std::end(sent.covariance), covariance.begin());
  }
  return percept;
}

}  // namespace

void read_percepts(std::span<const std::byte>& bytes, PerceptMessage& message) {
  message.clear();
  const auto header = take_message<reorient_percepts>(bytes, "frame: percepts");
  if (header.count > REORIENT_MOST_PERCEPTS)
    throw BadMessage("frame: " + std::to_string(header.count) + " percepts (expected at most 256)");
  for (std::uint32_t i = 0; i < header.count; ++i) {
    const auto sent = take_message<reorient_percept>(bytes, "frame: percept");
    const std::string where = "frame: percepts[" + std::to_string(i) + "].";
    check_choice(sent.what, REORIENT_PERCEPT_PERSON, (where + "what").c_str());
    check_choice(sent.space, REORIENT_IN_LOWER_IMAGE, (where + "space").c_str());
    check_bits(sent.has, REORIENT_PERCEPT_DIRECTION | REORIENT_PERCEPT_COVARIANCE | REORIENT_PERCEPT_BASE_HIDDEN,
               (where + "has").c_str());
    const ExternalPercept percept = percept_of(sent);
    if (const std::string mistake = mistake_in(percept); mistake.empty()) {
      message.list.push_back(percept);
    } else if (message.dropped++ == 0) {
      message.mistake = "percepts[" + std::to_string(i) + "]: " + mistake;
    }
  }
}

}  // namespace reorient
