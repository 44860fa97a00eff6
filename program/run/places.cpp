// SPDX-License-Identifier: MIT
#include "program/run/places.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "geometry/settable_pose.h"

namespace reorient {

std::optional<Pose2> place_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  double x = 0.0, y = 0.0, degrees = 0.0;
  char rest = 0;
  const bool is_pose = std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &x, &y, &degrees, &rest) == 3;
  if (!is_pose || !mistake_in_pose(x, y, 0.0).empty() || !(std::abs(degrees) <= 360.0))
    throw std::runtime_error("--at " + text +
                             ": expected X,Y,DEGREES in m (-100 to 100), m and degrees (-360 to 360), as in --at "
                             "-3.2,-3.5,90");
  return Pose2(x, y, from_degrees(degrees));
}

}  // namespace reorient
