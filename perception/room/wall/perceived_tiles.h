// SPDX-License-Identifier: MIT
// The tiles of the wall in one frame, and their color histograms (the paper's Section 3.2).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "geometry/transform.h"
#include "perception/room/color/color_counting.h"
#include "perception/room/color/color_histogram.h"
#include "perception/room/room_observation.h"
#include "perception/room/wall/light_adaptation.h"
#include "perception/room/wall/wall.h"
#include "perception/room/wall/wall_sketch.h"

namespace reorient {

struct PerceptionParameters {
  int sampled_rows = 240;
  int bands = 60;
  int min_samples = 20;
  double min_coverage = 0.2;
  double min_learned_coverage = 0.6;
  double min_distance = 1.5;
  double min_incidence = 0.45;
};
template <typename Visit>
void describe(PerceptionParameters& p, Visit&& visit) {
  visit("sampled_rows", p.sampled_rows, 8, 4096, "", "number of evenly spread image rows in which pixels are counted");
  visit("bands", p.bands, 8, 480, "",
        "number of bands of image rows; within a band, borders between tiles are assumed to be vertical");
  visit("min_samples", p.min_samples, 1, 100000, "", "smallest number of counted pixels at which a tile counts");
  visit("min_coverage", p.min_coverage, 0.0, 1.0, "",
        "smallest visible fraction of a tile's area at which the tile is compared with the model");
  visit("min_learned_coverage", p.min_learned_coverage, 0.0, 1.0, "",
        "smallest visible fraction of a tile's area at which the tile is learned and its light is measured");
  visit("min_distance", p.min_distance, 0.0, 20.0, "m", "smallest distance from the camera at which a tile counts");
  visit("min_incidence", p.min_incidence, 0.0, 1.0, "",
        "smallest cosine between line of sight and wall normal at which a tile counts");
}

struct PerceivedTile {
  int tile = 0;
  int samples = 0;                       ///< number of counted pixels
  double area = 0.0;                     ///< pixels in view and not covered
  double expected_area = 0.0;            ///< pixels of the whole tile, in view or not; 0: unknown
  double distance = 0.0;                 ///< m from the camera to the tile's center
  double incidence = 0.0;                ///< cosine at the center
  bool counts = false;                   ///< whether the tile satisfies all limits
  ColorHistogram histogram{};            ///< in the light that the believed pose implies
  ColorHistogram reflected_histogram{};  ///< in the light that its reflection implies

  double coverage() const { return expected_area > 0.0 ? area / expected_area : 0.0; }
};

template <typename Visit, ConstOr<PerceivedTile> T>
void fields(Visit&& visit, T& tile) {
  visit(tile.tile, tile.samples, tile.area, tile.expected_area, tile.distance, tile.incidence, tile.counts,
        tile.histogram, tile.reflected_histogram);
}

/// A rectangle of pixels that shows one tile.
struct TileBlock {
  int tile = 0;
  PixelBlock pixels;
};

/// Finds the tiles in the image. Reuses its memory from frame to frame.
class PerceivedTiles {
 public:
  /// Finds the tiles from the believed pose. There are no tiles if the camera is outside of the wall, or if any value
  /// is not finite.
  void find(const RoomObservation& view, const Wall& wall, const PerceptionParameters& parameters);

  /// The light on each tile that is sufficiently in view. Call it after find() with the same image. Valid until the
  /// next call.
  std::span<const TileLight> light(const ImageView& image, const LightParameters& parameters,
                                   const PerceptionParameters& perception);

  /// The result of light() in this frame.
  std::span<const TileLight> lights() const { return lights_; }

  /// Counts the colors of each tile, once for each of the two lights, and decides which tiles count. Call it after
  /// find() with the same image.
  void count(const ImageView& image, const ColorThresholds& if_believed, const ColorThresholds& if_reflected,
             const PerceptionParameters& parameters);

  /// Blurs all histograms.
  void blur(double share);

  /// Sorted by the tile's number.
  std::span<const PerceivedTile> tiles() const { return tiles_; }
  std::span<const TileBlock> blocks() const { return blocks_; }
  void clear();

 private:
  void prepare_rays(const CameraModel& camera, int bands);
  void find_in_band(int band, const Isometry3& field_from_camera, const Wall& wall,
                    std::span<const CoveredArea> covered);
  void cut_exactly(int ray, const Isometry3& field_from_camera, const Wall& wall);
  /// From x on (pixels), the band shows another tile, or no tile (-1).
  void enter(int tile, double x);
  void add_block(const TileBlock& block);
  const std::optional<Eigen::Vector2d>& outline_point(int half_column, int row, const CameraModel& camera,
                                                      const Isometry3& camera_from_field, const Wall& wall);
  double projected_area(int tile, const CameraModel& camera, const Isometry3& camera_from_field, const Wall& wall);
  void measure(const Isometry3& field_from_camera, const CameraModel& camera, const Wall& wall);

  struct OutlinePoint {
    bool known = false;
    std::optional<Eigen::Vector2d> pixel;
  };

  struct TileCount {
    ColorCounts colors{};
    ColorCounts reflected_colors{};
    LightSums light;
    double area = 0.0;
  };

  CameraModel camera_;  // for which rays_ was computed
  int bands_ = 0;
  std::vector<Eigen::Vector3d> rays_;  // camera frame; at the borders of evenly spaced cells, band by band
  std::vector<std::optional<BandRays>> rough_rays_;  // the same for the sketch, band by band
  WallSketch sketch_;
  TileBlock run_;                      // of the current band, so far
  std::vector<std::uint8_t> covered_;  // for each pair of pixels of the current band
  bool any_covered_ = false;
  std::vector<TileBlock> blocks_;
  std::vector<OutlinePoint> outline_;  // of this frame: rows by half columns
  std::vector<TileCount> counts_;      // for each tile of the wall
  std::vector<PerceivedTile> tiles_;
  std::vector<TileLight> lights_;
};

}  // namespace reorient
