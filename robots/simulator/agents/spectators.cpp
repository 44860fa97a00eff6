// SPDX-License-Identifier: MIT
#include "robots/simulator/agents/spectators.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/random.h"
#include "robots/simulator/room/texture_painter.h"

namespace reorient {
namespace {

PersonLook any_look(const LinearColor& light, Random& random) {
  const LinearColor skin = LinearColor(0.42f, 0.24f, 0.16f) * static_cast<float>(random.uniform(0.3, 1.4));
  return {any_paint(Range{}, {0.0, 0.9}, {0.15, 0.85}, random) * light,
          any_paint({0.5, 0.72}, {0.1, 0.6}, {0.08, 0.45}, random) * light, skin * light,
          any_paint(0.08, {0.2, 0.7}, {0.08, 0.55}, random) * light};
}

}  // namespace

Spectators::Spectators(int count, const RoomShape& room, const FieldDimensions& field, const LinearColor& light,
                       std::uint64_t seed)
    : room_(room), field_(field), light_(light), newcomers_(seed, 0xc03e25) {
  Random random(seed, 0x9e091e);
  // In a symmetric room each person also stands on the opposite side.
  const int positions = room_.symmetry == RoomSymmetry::none ? count : count / 2;
  for (int i = 0; i < positions; ++i) {
    if (const auto spectator = draw_spectator(random)) spectators_.push_back(*spectator);
  }
}

std::optional<Spectators::Spectator> Spectators::draw_spectator(Random& random) const {
  constexpr double kFromCarpet = 0.4;  // m
  constexpr double kFromWall = 0.5;    // m
  const Eigen::Vector2d carpet = carpet_half_size(field_) + Eigen::Vector2d::Constant(kFromCarpet);
  // A position between the carpet and the wall, anywhere along the wall.
  const Eigen::Vector2d wall = wall_point(room_, random.uniform(0.0, wall_perimeter(room_)));
  const double inner =
      std::min({1.0, carpet.x() / std::max(std::abs(wall.x()), 1e-6), carpet.y() / std::max(std::abs(wall.y()), 1e-6)});
  const Eigen::Vector2d edge = inner * wall;
  const Eigen::Vector2d out = wall - edge;
  const double room_left = out.norm() - kFromWall;
  if (room_left < 0.0) return std::nullopt;
  Spectator spectator;
  spectator.position = edge + out.normalized() * random.uniform(0.0, room_left);
  const bool strolls = random.uniform() < 0.15;
  spectator.stroll = strolls
                         ? Eigen::Vector2d(random.uniform(0.3, 1.0) * Eigen::Vector2d(-out.y(), out.x()).normalized())
                         : Eigen::Vector2d::Zero();
  spectator.height =
      random.uniform() < 0.3 ? random.uniform(1.1, 1.3) : random.uniform(1.5, 1.9);  // sitting or standing
  spectator.phase = random.uniform(0.0, 2.0 * kPi);
  spectator.pace = random.uniform(0.15, 0.6);
  spectator.restless = random.uniform(0.01, 0.08);
  spectator.look = any_look(light_, random);
  return spectator;
}

void Spectators::exchange(double probability) {
  if (probability <= 0.0) return;
  for (Spectator& spectator : spectators_) {
    if (newcomers_.uniform() >= probability) continue;
    if (const auto newcomer = draw_spectator(newcomers_)) spectator = *newcomer;
  }
}

void Spectators::add_to(Scene& scene, double time) const {
  for (const Spectator& person : spectators_) {
    const double lean = person.restless * (pinned::sin(person.pace * 3.1 * time + person.phase) +
                                           0.5 * pinned::sin(person.pace * 7.3 * time + 2.0 * person.phase));
    const Eigen::Vector2d position =
        person.position + pinned::sin(0.4 * person.pace * time + person.phase) * person.stroll;
    add_person(scene, position, person.height, lean, person.look);
    if (room_.symmetry != RoomSymmetry::none) add_person(scene, -position, person.height, lean, person.look);
  }
}

}  // namespace reorient
