// SPDX-License-Identifier: MIT
// The versions of WallSketch::draw() that need optional instructions of processors. Each is a source file that is
// compiled for its instructions. Such a file must not call inline functions that other files may also call. The linker
// keeps only one copy of each, and instructions of newer processors would reach the rest of the program.
#pragma once

namespace reorient {

/// The camera and the wall, in a frame that is rotated so that the camera's axis points to azimuth 0 of the wall.
/// Heights are relative to the lower edge of the lowest tiles.
struct SketchedCamera {
  float rotation[9] = {};  ///< row by row
  float eye[3] = {};       ///< m
  float outside = 0.0f;    ///< eye_x^2 + eye_y^2 - radius^2
  float radius = 0.0f;     ///< m
  float rows_per_meter = 1.0f;
  float first_column = 0.0f;  ///< at the axis
  float columns = 0.0f;       ///< of the wall
  float rows = 0.0f;
  float column_error = 0.0f;  ///< bound of the error of a column
  float row_error = 0.0f;
};

/// Values of the rays of one band, by ray. Positions are those of WallSketch.
struct SketchedBand {
  float* columns;
  float* rows;
  float* column_floors;
  float* row_floors;
  int* places;
};

/// Computes a band from rays (1, y, z). All arrays have kSketchedRays numbers, of which `rays` count.
using SketchingKernel = void(const SketchedCamera& camera, const float* y, const float* z, int rays,
                             const SketchedBand& band);
inline constexpr int kSketchedRays = 48;  // whole registers

inline constexpr int kNowhereSure = -3;
inline constexpr int kBelowTheTiles = -1;
inline constexpr int kAboveTheTiles = -2;

/// Null if the program is compiled for another type of processor.
SketchingKernel* sse4_sketching();
SketchingKernel* avx2_sketching();
SketchingKernel* neon_sketching();

}  // namespace reorient
