// SPDX-License-Identifier: MIT
// Computes the sketch of a band many rays at a time, for registers of any width. Only the sources of
// sketching_kernels.h include it. Each defines its Lanes: a register of numbers and its operations. All names here are
// local to the including source.
#pragma once

#include "perception/room/wall/sketching_kernels.h"

namespace reorient {
namespace {

/// Error below 2e-8 for the arc tangent of -1...1 (Abramowitz and Stegun, 4.4.49).
template <typename Lanes>
typename Lanes::Register arc_tangent(typename Lanes::Register x) {
  constexpr float kCoefficients[] = {0.0028662257f, -0.0161657367f, 0.0429096138f, -0.0752896400f,
                                     0.1065626393f, -0.1420889944f, 0.1999355085f, -0.3333314528f};
  const auto square = x * x;
  auto sum = Lanes::all(0.0f);
  for (const float coefficient : kCoefficients) sum = (sum + Lanes::all(coefficient)) * square;
  return x + x * sum;
}

template <typename Lanes>
void sketch_wide(const SketchedCamera& camera, const float* ray_ys, const float* ray_zs, int rays,
                 const SketchedBand& band) {
  using Register = typename Lanes::Register;
  constexpr float kInverseOfPi = 0.318309886f;
  const auto all = [](float value) { return Lanes::all(value); };
  const float* rotation = camera.rotation;
  const float* eye = camera.eye;

  // Two loops, each short enough for the processor to execute several iterations in parallel.
  float half_tangents[kSketchedRays], level[kSketchedRays];
  for (int i = 0; i < rays; i += Lanes::kRays) {
    const Register y = Lanes::load(ray_ys + i);
    const Register z = Lanes::load(ray_zs + i);
    const Register forward = all(rotation[0]) + all(rotation[1]) * y + all(rotation[2]) * z;
    const Register left = all(rotation[3]) + all(rotation[4]) * y + all(rotation[5]) * z;
    const Register up = all(rotation[6]) + all(rotation[7]) * y + all(rotation[8]) * z;
    const Register a = Lanes::greater_of(forward * forward + left * left, all(1e-6f));
    const Register b = all(eye[0]) * forward + all(eye[1]) * left;
    const Register steps = (Lanes::root(b * b - all(camera.outside) * a) - b) / a;
    // On a circle, the tangent of half of the azimuth is sufficient.
    const Register before = Lanes::greater_of(all(camera.radius + eye[0]) + steps * forward, all(1e-6f));
    Lanes::store((all(eye[1]) + steps * left) / before, half_tangents + i);
    Lanes::store((all(eye[2]) + steps * up) * all(camera.rows_per_meter), band.rows + i);
    // The bounds hold for slopes up to 2.
    Lanes::store(Lanes::less(up * up, all(4.0f) * a), level + i);
  }

  const Register columns = all(camera.columns);
  const Register rows = all(camera.rows);
  const Register columns_per_radian = all(camera.columns * kInverseOfPi);
  const Register turns_per_column = all(1.0f / camera.columns);
  const Register unsure = all(kNowhereSure);
  for (int i = 0; i < rays; i += Lanes::kRays) {
    const Register half_tangent = Lanes::load(half_tangents + i);
    const Register beyond = all(camera.first_column) + arc_tangent<Lanes>(half_tangent) * columns_per_radian;
    const Register column = beyond - columns * Lanes::floor(beyond * turns_per_column);
    const Register column_floor = Lanes::floor(column);
    const Register row = Lanes::load(band.rows + i);
    const Register row_floor = Lanes::floor(row);
    const Register from_row = Lanes::absolute(row - row_floor - all(0.5f));
    const Register from_column = Lanes::absolute(column - column_floor - all(0.5f));
    const Register is_level = Lanes::load(level + i);
    const Register row_sure = Lanes::both(is_level, Lanes::less(from_row, all(0.5f - camera.row_error)));
    // The bounds hold up to 90 degrees to each side.
    const Register column_sure =
        Lanes::both(Lanes::both(is_level, Lanes::less(from_column, all(0.5f - camera.column_error))),
                    Lanes::less(Lanes::absolute(half_tangent), all(1.0f)));
    Register place = Lanes::choose(unsure, row_floor * columns + column_floor, column_sure);
    place = Lanes::choose(all(kAboveTheTiles), place, Lanes::less(row, rows));
    place = Lanes::choose(place, all(kBelowTheTiles), Lanes::less(row, all(0.0f)));
    place = Lanes::choose(unsure, place, row_sure);
    const Register clamped_row = Lanes::lesser_of(Lanes::greater_of(row_floor, all(-1.0f)), rows);
    Lanes::store(column, band.columns + i);
    Lanes::store(Lanes::choose(unsure, column_floor, column_sure), band.column_floors + i);
    Lanes::store(Lanes::choose(unsure, clamped_row, row_sure), band.row_floors + i);
    Lanes::store_whole(place, band.places + i);
  }
}

}  // namespace
}  // namespace reorient
