// SPDX-License-Identifier: MIT
#include "robots/simulator/render/surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/pinned_math.h"
#include "geometry/random.h"
#include "geometry/wide.h"
#include "robots/simulator/room/texture_painter.h"

namespace reorient {
namespace {

constexpr float kLineAlbedo = 0.8f;

/// Artificial turf: fibers, patches of wear, and brighter areas below the lamps (in the light channel, for the lines).
Texture make_carpet(double length, double width, const LinearColor& light) {
  constexpr double kTexelsPerMeter = 64.0;
  constexpr std::uint64_t kSeed = 0xca47e7;
  Random random(kSeed);
  const Area all{0.0, 0.0, length, width};
  TexturePainter lit(length, width, kTexelsPerMeter, LinearColor::Ones());
  lit.mottle(all, 0.10, 1.7, random);
  TexturePainter turf(length, width, kTexelsPerMeter, LinearColor(0.016f, 0.150f, 0.066f));
  turf.mottle(all, 0.06, 0.45, random);
  turf.mottle(all, 0.07, 0.06, random);
  turf.mottle(all, 0.12, 0.02, random);
  LinearImage image = turf.image();
  std::vector<float> shine(image.pixels.size());
  for (std::size_t i = 0; i < shine.size(); ++i) {
    shine[i] = lit.image().pixels[i].x();
    image.pixels[i] *= light * shine[i];
  }
  return {image, shine, {length, width}, Texture::Edge::clamp};
}

}  // namespace

Surfaces::Hits::Hits(int width)
    : x(width),
      y(width),
      half_x(width),
      half_y(width),
      u(width),
      v(width),
      azimuth(width),
      footprint(width),
      coverage(width),
      on_wall(width),
      gain(width),
      surface(width),
      level(width) {}

Surfaces::Surfaces(const FieldDimensions& field, Room room, int image_width, double worn_lines)
    : room_(std::move(room)),
      lines_(field, worn_lines),
      carpet_(make_carpet(2.0 * carpet_half_size(field).x(), 2.0 * carpet_half_size(field).y(), room_.light)),
      carpet_half_length_(static_cast<float>(carpet_half_size(field).x())),
      carpet_half_width_(static_cast<float>(carpet_half_size(field).y())),
      hits_(image_width) {}

void Surfaces::render(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, const Changes& changes,
                      Frame& frame) {
  for (int row = 0; row < frame.height; ++row) {
    intersect(rays, field_from_camera, row, frame);
    shade(rays, field_from_camera, row, frame);
    if (!changes.patches.empty()) patch(row, changes.patches, frame);
    if (!changes.illumination.as_usual()) relight(row, changes.illumination, frame);
    if (!frame.labels.empty()) label(row, frame);
  }
}

void Surfaces::intersect(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row, Frame& frame) {
  const bool round = room_.shape.form == RoomForm::cylinder;
  if (rays.is_perspective()) {
    round ? intersect_round(rays, field_from_camera, row, frame) : intersect_box(rays, field_from_camera, row, frame);
  } else {
    round ? intersect_round_through_any_lens(rays, field_from_camera, row, frame)
          : intersect_box_through_any_lens(rays, field_from_camera, row, frame);
  }
}

REORIENT_WIDE void Surfaces::intersect_box(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                           Frame& frame) {
  intersect_with<false, true>(rays, field_from_camera, row, frame);
}

REORIENT_WIDE void Surfaces::intersect_box_through_any_lens(const RayTable& rays,
                                                            const Eigen::Isometry3f& field_from_camera, int row,
                                                            Frame& frame) {
  intersect_with<false, false>(rays, field_from_camera, row, frame);
}

REORIENT_WIDE void Surfaces::intersect_round(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                             Frame& frame) {
  intersect_with<true, true>(rays, field_from_camera, row, frame);
}

REORIENT_WIDE void Surfaces::intersect_round_through_any_lens(const RayTable& rays,
                                                              const Eigen::Isometry3f& field_from_camera, int row,
                                                              Frame& frame) {
  intersect_with<true, false>(rays, field_from_camera, row, frame);
}

template <bool round, bool perspective>
inline void Surfaces::intersect_with(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                     Frame& frame) {
  const Eigen::Matrix3f rotation = field_from_camera.linear();
  const float r00 = rotation(0, 0), r01 = rotation(0, 1), r02 = rotation(0, 2);
  const float r10 = rotation(1, 0), r11 = rotation(1, 1), r12 = rotation(1, 2);
  const float r20 = rotation(2, 0), r21 = rotation(2, 1), r22 = rotation(2, 2);
  const float camera_x = field_from_camera.translation().x();
  const float camera_y = field_from_camera.translation().y();
  const float camera_z = field_from_camera.translation().z();
  const Eigen::Vector2f half_room = 0.5f * floor_extent(room_.shape).cast<float>();
  const float half_length = half_room.x();
  const float half_width = half_room.y();
  const float height = static_cast<float>(room_.shape.height);
  const float carpet_x = carpet_half_length_;
  const float carpet_y = carpet_half_width_;
  const float pixel_angle = rays.pixel_angle;
  const float radius2 = half_length * half_length;
  const float beyond = radius2 - camera_x * camera_x - camera_y * camera_y;

  const std::size_t first = frame.row(row);
  const int width = frame.width;
  const float* __restrict forward = perspective ? nullptr : rays.forward.data() + first;
  const float* __restrict left = rays.left.data() + first;
  const float* __restrict up = rays.up.data() + first;
  const float* __restrict length = rays.length.data() + first;
  float* __restrict depth = frame.depth.data() + first;
  float* __restrict hit_x = hits_.x.data();
  float* __restrict hit_y = hits_.y.data();
  float* __restrict hit_u = hits_.u.data();
  float* __restrict hit_v = hits_.v.data();
  float* __restrict footprint = hits_.footprint.data();
  int* __restrict surface = hits_.surface.data();

#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    const float dx = (perspective ? r00 : r00 * forward[i]) + r01 * left[i] + r02 * up[i];
    const float dy = (perspective ? r10 : r10 * forward[i]) + r11 * left[i] + r12 * up[i];
    const float dz = (perspective ? r20 : r20 * forward[i]) + r21 * left[i] + r22 * up[i];
    // The wall.
    const float far_x = dx > 0.0f ? half_length : -half_length;
    const float far_y = dy > 0.0f ? half_width : -half_width;
    const float to_x = (far_x - camera_x) / dx;
    const float to_y = (far_y - camera_y) / dy;
    const bool at_end = to_x < to_y;
    const float across = dx * dx + dy * dy + 1e-12f;
    const float along = camera_x * dx + camera_y * dy;
    const float to_arc = (std::sqrt(along * along + across * beyond) - along) / across;
    const float to_wall = round ? to_arc : (at_end ? to_x : to_y);
    // Floor and ceiling.
    const float to_level = (dz < 0.0f ? -camera_z : height - camera_z) / dz;
    const bool level = to_level < to_wall;
    const float t = level ? to_level : to_wall;
    const float x = camera_x + t * dx;
    const float y = camera_y + t * dy;
    const float z = camera_z + t * dz;
    const bool on_carpet = std::fabs(x) <= carpet_x && std::fabs(y) <= carpet_y;
    const int below = on_carpet ? kCarpet : kFloor;
    const int flat = dz < 0.0f ? below : kCeiling;
    surface[i] = level ? flat : kWall;
    depth[i] = t;
    hit_x[i] = x;
    hit_y[i] = y;
    // The point in the surface's texture (a separate loop computes the coordinate of a round wall).
    const float at_ends = dx > 0.0f ? y + half_width : 3.0f * half_width + 2.0f * half_length - y;
    const float at_sides = dy > 0.0f ? 2.0f * half_width + half_length - x : 4.0f * half_width + 3.0f * half_length + x;
    const float wall_u = at_end ? at_ends : at_sides;
    const float margin_x = on_carpet ? carpet_x : half_length;
    const float margin_y = on_carpet ? carpet_y : half_width;
    const float level_x = dz < 0.0f ? margin_x : half_length;
    const float level_y = dz < 0.0f ? margin_y : half_width;
    hit_u[i] = level ? x + level_x : wall_u;
    hit_v[i] = level ? y + level_y : z;
    // The size of the area that the pixel sees.
    const float lateral = t * length[i] * pixel_angle;
    const float facing_wall =
        round ? (to_arc * across + along) / half_length : (at_end ? std::fabs(dx) : std::fabs(dy));
    const float facing = (level ? std::fabs(dz) : facing_wall) / length[i] + 1e-4f;
    footprint[i] = lateral / std::sqrt(facing);
  }
  if constexpr (!round) return;
  constexpr float kStart = static_cast<float>(-kPi / 4.0);
  constexpr float kTurn = static_cast<float>(2.0 * kPi);
  pinned::atan2(hits_.y, hits_.x, hits_.azimuth);
  for (int i = 0; i < width; ++i) {
    if (surface[i] != kWall) continue;
    const float azimuth = hits_.azimuth[static_cast<std::size_t>(i)] - kStart;
    hit_u[i] = half_length * (azimuth < 0.0f ? azimuth + kTurn : azimuth);
  }
}

template <bool perspective>
inline void Surfaces::spread_with(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                  const Columns& columns, const Frame& frame) {
  const Eigen::Matrix3f rotation = field_from_camera.linear();
  const float r00 = rotation(0, 0), r01 = rotation(0, 1), r02 = rotation(0, 2);
  const float r10 = rotation(1, 0), r11 = rotation(1, 1), r12 = rotation(1, 2);
  const float r20 = rotation(2, 0), r21 = rotation(2, 1), r22 = rotation(2, 2);
  const float pixel_angle = rays.pixel_angle;
  const std::size_t first = frame.row(row);
  const float* __restrict forward = perspective ? nullptr : rays.forward.data() + first;
  const float* __restrict left = rays.left.data() + first;
  const float* __restrict up = rays.up.data() + first;
  const float* __restrict length = rays.length.data() + first;
  const float* __restrict depth = frame.depth.data() + first;
  float* __restrict half_x = hits_.half_x.data();
  float* __restrict half_y = hits_.half_y.data();
#pragma GCC ivdep
  for (int i = columns.first; i < columns.end; ++i) {
    const float dx = (perspective ? r00 : r00 * forward[i]) + r01 * left[i] + r02 * up[i];
    const float dy = (perspective ? r10 : r10 * forward[i]) + r11 * left[i] + r12 * up[i];
    const float dz = (perspective ? r20 : r20 * forward[i]) + r21 * left[i] + r22 * up[i];
    const float across = dx * dx + dy * dy + 1e-12f;
    const float facing = std::fabs(dz) / length[i] + 1e-4f;
    const float side = 0.5f * (depth[i] * length[i] * pixel_angle) / std::sqrt(across);
    const float ahead = side / facing;
    half_x[i] = std::sqrt(dx * dx * ahead * ahead + dy * dy * side * side);
    half_y[i] = std::sqrt(dy * dy * ahead * ahead + dx * dx * side * side);
  }
}

REORIENT_WIDE void Surfaces::spread(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                    const Columns& columns, const Frame& frame) {
  spread_with<true>(rays, field_from_camera, row, columns, frame);
}

REORIENT_WIDE void Surfaces::spread_through_any_lens(const RayTable& rays, const Eigen::Isometry3f& field_from_camera,
                                                     int row, const Columns& columns, const Frame& frame) {
  spread_with<false>(rays, field_from_camera, row, columns, frame);
}

REORIENT_WIDE void Surfaces::shade(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                   Frame& frame) {
  const Texture* const textures[kSurfaces] = {&room_.walls, &room_.ceiling, &room_.floor, &carpet_};
  float texels_per_meter[kSurfaces];
  for (int i = 0; i < kSurfaces; ++i) texels_per_meter[i] = textures[i]->texels_per_meter();

  const int width = frame.width;
  const int* __restrict surfaces = hits_.surface.data();
  int first_carpet = width;
  int last_carpet = -1;
  for (int i = 0; i < width; ++i) {
    const bool carpet = surfaces[i] == kCarpet;
    first_carpet = std::min(first_carpet, carpet ? i : width);
    last_carpet = std::max(last_carpet, carpet ? i : -1);
  }
  const Columns on_carpet{first_carpet, last_carpet + 1};
  rays.is_perspective() ? spread(rays, field_from_camera, row, on_carpet, frame)
                        : spread_through_any_lens(rays, field_from_camera, row, on_carpet, frame);
  lines_.cover({hits_.x.data() + first_carpet, hits_.y.data() + first_carpet, hits_.half_x.data() + first_carpet,
                hits_.half_y.data() + first_carpet, last_carpet - first_carpet + 1},
               hits_.coverage.data() + first_carpet);

  float* __restrict red = frame.red.data() + frame.row(row);
  float* __restrict green = frame.green.data() + frame.row(row);
  float* __restrict blue = frame.blue.data() + frame.row(row);
  const LinearColor line = kLineAlbedo * room_.light;
  const Texture::Color white{line.x(), line.y(), line.z(), 0.0f};
  const float* __restrict footprint = hits_.footprint.data();
  int* __restrict levels = hits_.level.data();
  for (int i = 0; i < width; ++i) levels[i] = Texture::level_for(footprint[i] * texels_per_meter[surfaces[i]]);
  // A row shows few surfaces at few levels, each in many pixels.
  for (int begin = 0, end = 0; begin < width; begin = end) {
    const int surface = surfaces[begin];
    const int level = levels[begin];
    while (end < width && surfaces[end] == surface && levels[end] == level) ++end;
    const float* coverage = hits_.coverage.data() + begin;
    const auto take = [&](int i, Texture::Color color) __attribute__((always_inline)) {
      if (surface == kCarpet) color += coverage[i] * (white * color[3] - color);
      red[begin + i] = color[0];
      green[begin + i] = color[1];
      blue[begin + i] = color[2];
    };
    textures[surface]->sample(hits_.u.data() + begin, hits_.v.data() + begin, end - begin, level, take);
  }
}

void Surfaces::patch(int row, const WallPatches& patches, Frame& frame) {
  for (int i = 0; i < frame.width; ++i) hits_.on_wall[i] = hits_.surface[i] == kWall ? 1.0f : 0.0f;
  const std::size_t first = frame.row(row);
  patches.paint({hits_.u.data(), hits_.v.data(), hits_.footprint.data(), hits_.on_wall.data(), frame.width},
                frame.red.data() + first, frame.green.data() + first, frame.blue.data() + first);
}

REORIENT_WIDE void Surfaces::relight(int row, const Illumination& illumination, Frame& frame) {
  constexpr float kLampOff = 0.03f;  // brightness of a lamp that is off, relative to one that is on
  illumination.gains(hits_.x, hits_.y, hits_.gain);
  const float dark_x = illumination.toward_dark.x();
  const float dark_y = illumination.toward_dark.y();
  const bool lamps_off = illumination.fraction_off > 0.0f;
  const int width = frame.width;
  const float* __restrict x = hits_.x.data();
  const float* __restrict y = hits_.y.data();
  const int* __restrict surface = hits_.surface.data();
  const float* __restrict gains = hits_.gain.data();
  float* __restrict red = frame.red.data() + frame.row(row);
  float* __restrict green = frame.green.data() + frame.row(row);
  float* __restrict blue = frame.blue.data() + frame.row(row);
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    // Things brighter than white paper emit light: on walls these are windows, which stay bright, and on the ceiling
    // lamps, some of which are off.
    const float excess = 0.299f * red[i] + 0.587f * green[i] + 0.114f * blue[i] - 1.0f;
    const float positive = excess > 0.0f ? excess : 0.0f;
    const float shines = positive < 1.0f ? positive : 1.0f;
    const float gain = gains[i];
    const float window = gain < 1.0f ? gain + shines * (1.0f - gain) : gain;
    const bool off = lamps_off && dark_x * x[i] + dark_y * y[i] > 0.0f;
    const float lamp = off ? gain + shines * (kLampOff - gain) : window;
    const float factor = surface[i] == kWall ? window : (surface[i] == kCeiling ? lamp : gain);
    red[i] *= factor;
    green[i] *= factor;
    blue[i] *= factor;
  }
}

void Surfaces::label(int row, Frame& frame) {
  constexpr Label kLabels[kSurfaces] = {Label::wall, Label::ceiling, Label::floor, Label::carpet};
  Label* labels = frame.labels.data() + frame.row(row);
  for (int i = 0; i < frame.width; ++i) {
    const bool line = hits_.surface[i] == kCarpet && hits_.coverage[i] > 0.5f;
    labels[i] = line ? Label::line : kLabels[hits_.surface[i]];
  }
}

}  // namespace reorient
