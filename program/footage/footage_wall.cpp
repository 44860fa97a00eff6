// SPDX-License-Identifier: MIT
#include "program/footage/footage_wall.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include <spdlog/fmt/fmt.h>

#include "engine/core_parameters.h"
#include "engine/parameters/counted.h"
#include "workbench/footage/wall_fit.h"

namespace reorient {
namespace {

constexpr std::size_t kMostViews = 400;
constexpr std::size_t kMostImages = 4000;  // decoded for the fit

/// False at the end of the footage, also at damage: the run itself reports damage after the frames before it.
bool read_next(FootageSource& source, FootageFrame& frame) {
  try {
    return source.next(frame);
  } catch (const BadFootage&) {
    return false;
  }
}

/// Images evenly spread over the part that is read.
std::vector<WallView> views_of(FootageSource& source) {
  std::vector<WallView> views;
  std::size_t every = 1, images = 0;
  for (FootageFrame frame; images < kMostImages && read_next(source, frame); ++images) {
    if (images % every != 0) continue;
    if (auto view = wall_view(frame)) views.push_back(std::move(*view));
    if (views.size() < kMostViews) continue;
    for (std::size_t i = 0; 2 * i < views.size(); ++i) views[i] = std::move(views[2 * i]);
    views.resize((views.size() + 1) / 2);
    every *= 2;
  }
  return views;
}

double radius_in(const std::string& text) {
  double radius = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), radius);
  if (error != std::errc() || stop != text.data() + text.size() || !(radius >= 1.0 && radius <= 200.0))
    throw std::runtime_error("--wall: expected auto, field or a radius of 1 to 200 m, found '" + text + "'");
  return radius;
}

std::vector<ParameterChange> changes_for(const WallParameters& wall, double nearest) {
  const auto change = [](const char* name, const ParameterValue& value) {
    return ParameterChange{name, to_text(value), ParameterOrigin::file, "the footage"};
  };
  return {change("wall.radius", wall.radius), change("wall.bottom", wall.bottom), change("wall.top", wall.top),
          change("wall.rows", wall.rows), change("perceived_tiles.min_distance", nearest)};
}

}  // namespace

FootageWall footage_wall(FootageSource& source, const std::string& choice, const FieldDimensions& field,
                         const RobotBody& body) {
  const RoomParameters usual = core_parameters_for(field, body).room;
  const std::string of_field = fmt::format("wall: that of the field, radius {:.1f} m", usual.wall.radius);
  if (choice == "field") return {{}, of_field};
  std::optional<WallFit> fit;
  double radius = choice == "auto" ? 0.0 : radius_in(choice);
  const std::vector<WallView> views = views_of(source);
  if (choice == "auto") {
    if (views.empty()) return {{}, of_field};
    fit = fit_wall(views);
    radius = fit ? fit->radius : usual.wall.radius;
  }
  if (views.empty()) throw std::runtime_error("--wall: expected images with a pose to fit the wall to, found none");
  const WallParameters wall = wall_of(radius, views, usual.wall);
  // The usual distance relative to the wall, but not a larger one.
  const double nearest =
      std::min(usual.perception.min_distance, usual.perception.min_distance * radius / usual.wall.radius);
  std::string line = fmt::format("wall: radius {:.1f} m, {:.1f} to {:.1f} m high, {} of tiles", radius, wall.bottom,
                                 wall.top, counted(wall.rows, "row"));
  if (choice == "auto" && !fit)
    line += fmt::format(" (the radius is the field's: {} with a pose cannot determine distances)",
                        counted(views.size(), "image"));
  if (fit)
    line +=
        fmt::format(" (radius {:.1f} to {:.1f} m by {} of images)", fit->low, fit->high, counted(fit->pairs, "pair"));
  return {changes_for(wall, nearest), std::move(line)};
}

}  // namespace reorient
