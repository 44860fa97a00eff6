#include "perception/room/wall/wall_sketch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#ifdef __SSE4_1__
#include <smmintrin.h>
#endif

namespace reorient {

void WallSketch::prepare(const Wall& wall, const Isometry3& field_from_camera) {
  // Near the wall, and where the camera looks up or down, small errors of a ray are large ones on the wall.
  constexpr double kFarthest = 0.9;     // of the radius
  constexpr double kSteepest = 0.3;     // horizontal share of the camera's axis
  constexpr double kAngleError = 1e-5;  // rad, of a place on the wall; a few times the greatest that was found
  constexpr double kRowError = 2e-6;    // of the greatest height that takes part
  const Eigen::Vector3d eye = field_from_camera.translation();
  const Eigen::Vector2d axis = field_from_camera.linear().col(0).head<2>();
  leave_blank();
  holds_ = eye.head<2>().norm() < kFarthest * wall.radius() && axis.norm() > kSteepest;
  if (!holds_) return;
  const auto azimuth = wall.azimuth_seen(eye.head<2>(), direction_of(axis));
  holds_ = azimuth.has_value();
  if (!holds_) return;
  const Eigen::Matrix3d turn = rotation_about_z(-*azimuth);
  const Eigen::Matrix3d rotation = turn * field_from_camera.linear();
  const Eigen::Vector3d turned_eye = turn * eye;
  for (int i = 0; i < 9; ++i) rotation_[static_cast<std::size_t>(i)] = static_cast<float>(rotation(i / 3, i % 3));
  eye_ = {static_cast<float>(turned_eye.x()), static_cast<float>(turned_eye.y()),
          static_cast<float>(eye.z() - wall.bottom())};
  wall_columns_ = wall.columns();
  wall_rows_ = wall.rows();
  radius_ = static_cast<float>(wall.radius());
  first_column_ = static_cast<float>(wall.column_at(*azimuth));
  row_height_ = static_cast<float>(wall.row_height());
  rows_per_metre_ = 1.0f / row_height_;
  column_error_ = static_cast<float>(kAngleError / wall.column_width());
  const double highest = 4.0 * wall.radius() + std::abs(eye.z()) + std::abs(wall.bottom());
  row_error_ = static_cast<float>(kRowError * highest / wall.row_height());
}

#ifdef __SSE4_1__

namespace {

/// Neighbouring rays, which go through everything side by side.
using Four = __m128;

Four all(float value) { return _mm_set1_ps(value); }
Four absolute(Four x) { return _mm_andnot_ps(all(-0.0f), x); }
Four load(const BandRays& rays, std::size_t first) { return _mm_loadu_ps(&rays[first]); }
void store(Four values, BandRays& rays, std::size_t first) { _mm_storeu_ps(&rays[first], values); }
/// b where the mask says so.
Four choose(Four a, Four b, Four mask) { return _mm_blendv_ps(a, b, mask); }

/// Within 2e-8 of the arc tangent of -1...1 (Abramowitz and Stegun, 4.4.49).
Four arc_tangent(Four x) {
  constexpr float kCoefficients[] = {0.0028662257f, -0.0161657367f, 0.0429096138f, -0.0752896400f,
                                     0.1065626393f, -0.1420889944f, 0.1999355085f, -0.3333314528f};
  const Four square = x * x;
  Four sum = _mm_setzero_ps();
  for (const float coefficient : kCoefficients) sum = (sum + all(coefficient)) * square;
  return x + x * sum;
}

}  // namespace

bool WallSketch::draw(const BandRays& y, const BandRays& z) {
  if (!holds_) return true;
  const Four zero = _mm_setzero_ps();
  BandRays ups;
  int rising = 0;
  for (std::size_t i = 0; i < y.size(); i += 4) {
    const Four up = all(rotation_[6]) + all(rotation_[7]) * load(y, i) + all(rotation_[8]) * load(z, i);
    store(up, ups, i);
    rising |= _mm_movemask_ps(_mm_cmpge_ps(up, zero));
  }
  if (rising == 0 && eye_[2] < -row_error_ * row_height_) return false;

  // In two loops, each so short that the processor works on several of its rounds at a time.
  BandRays half_tangents, level;
  const float outside = eye_[0] * eye_[0] + eye_[1] * eye_[1] - radius_ * radius_;
  for (std::size_t i = 0; i < y.size(); i += 4) {
    const Four ray_y = load(y, i);
    const Four ray_z = load(z, i);
    const Four up = load(ups, i);
    const Four forward = all(rotation_[0]) + all(rotation_[1]) * ray_y + all(rotation_[2]) * ray_z;
    const Four left = all(rotation_[3]) + all(rotation_[4]) * ray_y + all(rotation_[5]) * ray_z;
    const Four a = _mm_max_ps(forward * forward + left * left, all(1e-6f));
    const Four b = all(eye_[0]) * forward + all(eye_[1]) * left;
    const Four steps = (_mm_sqrt_ps(b * b - all(outside) * a) - b) / a;
    // On a circle the tangent of half the azimuth needs no more than this.
    const Four before = _mm_max_ps(all(radius_ + eye_[0]) + steps * forward, all(1e-6f));
    store((all(eye_[1]) + steps * left) / before, half_tangents, i);
    store((all(eye_[2]) + steps * up) * all(rows_per_metre_), rows_, i);
    // The bounds hold up to twice as far up or down as ahead.
    store(_mm_cmpgt_ps(all(4.0f) * a, up * up), level, i);
  }

  const auto columns = static_cast<float>(wall_columns_);
  const auto rows = static_cast<float>(wall_rows_);
  const float columns_per_radian = columns * static_cast<float>(1.0 / kPi);
  const float turns_per_column = 1.0f / columns;
  const Four unsure = all(kUnsure);
  for (std::size_t i = 0; i < y.size(); i += 4) {
    const Four half_tangent = load(half_tangents, i);
    const Four beyond = all(first_column_) + arc_tangent(half_tangent) * all(columns_per_radian);
    const Four column = beyond - all(columns) * _mm_floor_ps(beyond * all(turns_per_column));
    const Four column_floor = _mm_floor_ps(column);
    const Four row = load(rows_, i);
    const Four row_floor = _mm_floor_ps(row);
    const Four from_row = absolute(row - row_floor - all(0.5f));
    const Four from_column = absolute(column - column_floor - all(0.5f));
    const Four row_sure = _mm_and_ps(load(level, i), _mm_cmplt_ps(from_row, all(0.5f - row_error_)));
    // They hold a quarter turn to either side.
    const Four column_sure =
        _mm_and_ps(_mm_and_ps(load(level, i), _mm_cmplt_ps(from_column, all(0.5f - column_error_))),
                   _mm_cmplt_ps(absolute(half_tangent), all(1.0f)));
    Four place = choose(unsure, row_floor * all(columns) + column_floor, column_sure);
    place = choose(place, all(kAbove), _mm_cmpge_ps(row, all(rows)));
    place = choose(place, all(kBelow), _mm_cmplt_ps(row, zero));
    place = choose(unsure, place, row_sure);
    const Four clamped_row = _mm_min_ps(_mm_max_ps(row_floor, all(-1.0f)), all(rows));
    store(column, columns_, i);
    store(choose(unsure, column_floor, column_sure), column_floors_, i);
    store(choose(unsure, clamped_row, row_sure), row_floors_, i);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(&places_[i]), _mm_cvttps_epi32(place));
  }
  return true;
}

#else

// Nothing is sure: all is computed exactly.
bool WallSketch::draw(const BandRays&, const BandRays&) { return true; }

#endif

void WallSketch::leave_blank() {
  places_.fill(kUnsure);
  column_floors_.fill(kUnsure);
  row_floors_.fill(kUnsure);
}

std::optional<double> WallSketch::border(int ray, double width) const {
  const auto left = static_cast<std::size_t>(ray);
  const std::size_t right = left + 1;
  const auto column_step = static_cast<int>(column_floors_[right] - column_floors_[left]);
  const auto row_step = static_cast<int>(row_floors_[right] - row_floors_[left]);
  if (column_floors_[left] == kUnsure || column_floors_[right] == kUnsure) return std::nullopt;
  if (row_floors_[left] == kUnsure || row_floors_[right] == kUnsure) return std::nullopt;
  double to_border = 0.0;
  double across = 0.0;
  double error = 0.0;
  if (row_step == 0 && column_step != 0) {
    across = static_cast<double>(columns_[right]) - columns_[left];
    if (2.0 * std::abs(across) > wall_columns_) across -= std::copysign(wall_columns_, across);
    const int step = across > 0.0 ? 1 : -1;
    if (column_step != step && column_step != step - step * wall_columns_) return std::nullopt;
    to_border = column_floors_[left] + (step > 0 ? 1 : 0) - columns_[left];
    error = column_error_;
  } else if (column_step == 0 && std::abs(row_step) == 1) {
    across = static_cast<double>(rows_[right]) - rows_[left];
    to_border = std::max(row_floors_[left], row_floors_[right]) - rows_[left];
    error = row_error_;
  }
  constexpr double kFarthest = 32.0;  // rows; far more are a view along the wall, which is not interpolated
  if (std::abs(across) < 16.0 * error || std::abs(across) > kFarthest || across == 0.0) return std::nullopt;
  const double place = to_border / across;
  const double pairs = 0.5 * (ray + place) * width;
  const double pairs_error = 0.5 * width * 4.0 * error / std::abs(across);
  if (std::abs(pairs - std::floor(pairs) - 0.5) <= pairs_error + 1e-9) return std::nullopt;
  return place;
}

}  // namespace reorient
