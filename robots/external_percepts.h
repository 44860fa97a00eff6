// SPDX-License-Identifier: MIT
// What a detector outside of the engine found in the images of a frame, for example a neural network of a team's own
// program.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/const_or.h"

namespace reorient {

enum class PerceptType {
  line,        ///< a segment; at: both ends
  line_point,  ///< a point on a line, with the direction along it
  goal_post,   ///< at: the foot; in an image also the top
  l_intersection,
  t_intersection,
  x_intersection,
  penalty_mark,
  center_circle,  ///< at: its center; direction: along the halfway line
  ball,           ///< at: where it touches the ground; in an image: its center and its radius
  robot,          ///< at: where it stands, its width and its height; in an image: left, top, right, bottom
  person          ///< as a robot
};
constexpr int enum_count(PerceptType) { return 11; }

/// "goal post": the name in messages.
std::string_view to_string(PerceptType type);

/// What the numbers of a percept refer to.
enum class PerceptSpace {
  ground,       ///< the ground in the robot frame at the time of the frame: m, rad
  upper_image,  ///< the image of the upper camera in the same frame: pixels, x to the right, y down
  lower_image
};
constexpr int enum_count(PerceptSpace) { return 3; }

struct ExternalPercept {
  PerceptType type = PerceptType::line;
  PerceptSpace space = PerceptSpace::ground;
  double confidence = 1.0;     ///< 0 to 1
  std::array<double, 4> at{};  ///< see PerceptType; numbers that the type does not use are ignored
  bool base_hidden = false;    ///< of a goal post: its foot is not in view, so the distance is rough
  std::optional<double>
      direction{};  ///< rad; of an intersection as in FieldIntersection; in an image: 0 right, pi/2 down
  std::optional<std::array<double, 3>> covariance{};  ///< xx, xy, yy of the point, m^2 or pixels^2
};
template <typename Visit, ConstOr<ExternalPercept> T>
void fields(Visit&& visit, T& percept) {
  visit(percept.type, percept.space, percept.confidence, percept.at, percept.base_hidden, percept.direction,
        percept.covariance);
}
inline constexpr std::size_t kMostExternalPercepts = 256;  // per frame; more are ignored

/// The empty text, or what was expected and found: "goal post: confidence: expected 0 to 1, found nan".
std::string mistake_in(const ExternalPercept& percept);

/// The percepts of one frame.
struct ExternalPercepts {
  bool replaces_vision = false;           ///< they are used instead of the engine's own field vision
  std::span<const ExternalPercept> list;  ///< invalid ones are ignored; valid until the next call of observe()
};

}  // namespace reorient
