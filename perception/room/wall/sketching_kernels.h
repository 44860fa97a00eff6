// SPDX-License-Identifier: MIT
// The versions of WallSketch::draw() that need more than every processor has. Each is a source that is compiled for its
// instructions. To keep code of a newer processor out of everything else, such a source calls no inline function that
// another source may call, too: the linker keeps just one copy of it.
#pragma once

namespace reorient {

/// The camera and the wall, in a frame that is turned until the camera's axis leads to the wall's azimuth 0; heights
/// are above the lowest tiles.
struct SketchedCamera {
  float rotation[9] = {};  ///< row by row
  float eye[3] = {};       ///< m
  float outside = 0.0f;    ///< eye_x^2 + eye_y^2 - radius^2
  float radius = 0.0f;     ///< m
  float rows_per_metre = 1.0f;
  float first_column = 0.0f;  ///< at the axis
  float columns = 0.0f;       ///< of the wall
  float rows = 0.0f;
  float column_error = 0.0f;  ///< how far they may be wrong
  float row_error = 0.0f;
};

/// What is known of the rays of one band, by ray; places are those of WallSketch.
struct SketchedBand {
  float* columns;
  float* rows;
  float* column_floors;
  float* row_floors;
  int* places;
};

/// Fills a band from rays (1, y, z). All arrays hold kSketchedRays numbers, `rays` of which count.
using SketchingKernel = void(const SketchedCamera& camera, const float* y, const float* z, int rays,
                             const SketchedBand& band);
inline constexpr int kSketchedRays = 48;  // whole registers

inline constexpr int kNowhereSure = -3;
inline constexpr int kBelowTheTiles = -1;
inline constexpr int kAboveTheTiles = -2;

/// Null where the program is compiled for another kind of processor.
SketchingKernel* sse4_sketching();
SketchingKernel* avx2_sketching();
SketchingKernel* neon_sketching();

}  // namespace reorient
