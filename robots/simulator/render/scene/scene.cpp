// SPDX-License-Identifier: MIT
#include "robots/simulator/render/scene/scene.h"

#include <array>
#include <cmath>

#include "geometry/field_landmarks.h"
#include "geometry/pinned_math.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

const LinearColor kBallWhite(0.78f, 0.77f, 0.74f);
const LinearColor kPlastic(0.66f, 0.67f, 0.68f);
const LinearColor kJoint(0.13f, 0.13f, 0.14f);

Eigen::Vector3f at(const Eigen::Vector2d& ground, double height) {
  return {static_cast<float>(ground.x()), static_cast<float>(ground.y()), static_cast<float>(height)};
}

}  // namespace

void Scene::clear() {
  capsules.clear();
  panels.clear();
  nets.clear();
  shadows.clear();
}

void add_goals(Scene& scene, const FieldDimensions& field, const LinearColor& light) {
  const LinearColor paint = field.yellow_goals ? LinearColor(0.72f, 0.52f, 0.02f) : LinearColor(0.82f, 0.82f, 0.80f);
  const LinearColor color = paint * light;
  const LinearColor string = LinearColor(0.5f, 0.5f, 0.5f) * light;
  const auto radius = static_cast<float>(0.5 * field.goal_post_diameter);
  const auto bar = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& to, float thickness, const LinearColor& tint,
                       bool flat_ends) {
    scene.capsules.push_back({from, to, thickness, tint, Label::goal, flat_ends, false});
  };
  for (const double end : {1.0, -1.0}) {
    const auto outline = goal_outline(field, end);
    const auto front = static_cast<float>(outline[0].x()), back = static_cast<float>(outline[1].x());
    const auto half = static_cast<float>(outline[0].y());
    const auto top = static_cast<float>(field.goal_height);
    const float roof = 0.55f * top;  // height of the net at the back of the goal
    for (const float side : {half, -half}) {
      bar({front, side, 0.0f}, {front, side, top}, radius, color, true);
      bar({front, side, 0.015f}, {back, side, 0.015f}, 0.015f, color, false);
      scene.shadows.push_back({{front, side}, 2.5f * radius, 0.35f});
    }
    bar({front, -half, top}, {front, half, top}, radius, color, false);
    bar({back, -half, 0.015f}, {back, half, 0.015f}, 0.015f, color, false);
    scene.nets.push_back({{back, -half, 0.0f}, {0.0f, 2.0f * half, 0.0f}, {0.0f, 0.0f, roof}, string});
    scene.nets.push_back({{back, -half, roof}, {0.0f, 2.0f * half, 0.0f}, {front - back, 0.0f, top - roof}, string});
    for (const float side : {half, -half}) {
      scene.nets.push_back({{back, side, 0.0f}, {front - back, 0.0f, 0.0f}, {0.0f, 0.0f, roof}, string});
    }
  }
}

void add_furniture(Scene& scene, const FurniturePiece& piece, double perimeter) {
  const Eigen::Vector2d along = piece.length * unit_vector(piece.rotation);
  const Eigen::Vector2d across = piece.depth * unit_vector(piece.rotation + 0.5 * kPi);
  const Eigen::Vector2d first = piece.center - 0.5 * (along + across);
  const std::array<Eigen::Vector2d, 4> corners{first, first + along, first + along + across, first + across};
  double picture = piece.picture;
  const auto add = [&](const Eigen::Vector3f& corner, const Eigen::Vector3f& side, const Eigen::Vector3f& up) {
    const double width = side.norm();
    if (picture + width > perimeter) picture = 0.0;
    scene.panels.push_back({corner, side, up, static_cast<float>(picture), 0.0f});
    picture += width;
  };
  const Eigen::Vector3f upright(0.0f, 0.0f, static_cast<float>(piece.height));
  for (std::size_t i = 0; i < corners.size(); ++i)
    add(at(corners[i], 0.0), at(corners[(i + 1) % corners.size()] - corners[i], 0.0), upright);
  add(at(first, piece.height), at(along, 0.0), at(across, 0.0));
}

void add_robot(Scene& scene, const Pose2& pose, double stride, double size, const LinearColor& jersey,
               const LinearColor& light, bool is_lying) {
  constexpr double kBack = 0.07;  // m, from the axis of a NAO to its back
  const double swing = 0.06 * pinned::sin(stride);
  const double lift = 0.012 * std::abs(pinned::sin(stride));
  const double rock = 0.012 * pinned::cos(stride);
  const auto point = [&](double forward, double left, double height) {
    if (is_lying) return at(pose * Eigen::Vector2d(size * height, size * left), size * (kBack + forward));
    return at(pose * Eigen::Vector2d(size * forward, size * left), size * height);
  };
  const auto limb = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius,
                        const LinearColor& color) {
    scene.capsules.push_back({from, to, static_cast<float>(size) * radius, color * light, Label::robot, false, false});
  };
  for (const double side : {1.0, -1.0}) {
    const double foot = side * swing;
    limb(point(foot - 0.03, side * 0.05, 0.025), point(foot + 0.07, side * 0.05, 0.02), 0.03f, kPlastic);
    limb(point(foot, side * 0.05, 0.06), point(0.02 + 0.5 * foot, side * 0.05, 0.14 + lift), 0.038f, kPlastic);
    limb(point(0.02 + 0.5 * foot, side * 0.05, 0.14 + lift), point(0.0, side * 0.05 + rock, 0.24), 0.042f, kPlastic);
    limb(point(-0.01, side * 0.105 + rock, 0.425), point(-0.04 - foot, side * 0.125, 0.32), 0.028f, jersey);
    limb(point(-0.04 - foot, side * 0.125, 0.32), point(0.05 - foot, side * 0.12, 0.25), 0.025f, kPlastic);
  }
  limb(point(0.0, rock - 0.03, 0.29), point(0.0, rock - 0.04, 0.42), 0.062f, jersey);
  limb(point(0.0, rock + 0.03, 0.29), point(0.0, rock + 0.04, 0.42), 0.062f, jersey);
  limb(point(0.0, rock, 0.45), point(0.0, rock, 0.47), 0.03f, kJoint);
  limb(point(0.015, rock, 0.515), point(-0.005, rock, 0.525), 0.055f, kPlastic);
  limb(point(0.0, rock - 0.062, 0.52), point(0.0, rock + 0.062, 0.52), 0.024f, kJoint);
  scene.shadows.push_back({pose.position.cast<float>(), static_cast<float>(0.24 * size), 0.6f});
}

void add_ball(Scene& scene, const Eigen::Vector2d& position, double diameter, const LinearColor& light) {
  const auto radius = static_cast<float>(0.5 * diameter);
  const Eigen::Vector3f center = at(position, radius);
  scene.capsules.push_back({center, center, radius, kBallWhite * light, Label::ball, false, true});
  scene.shadows.push_back({position.cast<float>(), 1.5f * radius, 0.65f});
}

void add_person(Scene& scene, const Eigen::Vector2d& where, double height, double lean, const PersonLook& look) {
  const Eigen::Vector2d across = Eigen::Vector2d(-where.y(), where.x()).normalized();
  const auto point = [&](double side, double level) {
    return at(where + (side * height + lean * level) * across, level * height);
  };
  const auto part = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& to, double radius,
                        const LinearColor& color) {
    scene.capsules.push_back({from, to, static_cast<float>(radius * height), color, Label::person, false, false});
  };
  for (const double side : {0.055, -0.055}) {
    part(point(side, 0.03), point(side, 0.46), 0.05, look.trousers);
    part(point(side * 2.6, 0.50), point(side * 2.2, 0.76), 0.03, look.shirt);
    part(point(side * 0.9, 0.54), point(side, 0.76), 0.065, look.shirt);
  }
  part(point(0.0, 0.83), point(0.0, 0.86), 0.028, look.skin);
  part(point(0.0, 0.915), point(0.0, 0.925), 0.062, look.hair);
  part(point(0.0, 0.905) - 0.02f * point(0.0, 0.0).normalized(),
       point(0.0, 0.92) - 0.02f * point(0.0, 0.0).normalized(), 0.055, look.skin);
  scene.shadows.push_back({where.cast<float>(), static_cast<float>(0.2 * height), 0.45f});
}

}  // namespace reorient
