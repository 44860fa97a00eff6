// SPDX-License-Identifier: MIT
// A static visual compass on transitions between color classes, after Sturm and Visser, "An appearance-based visual
// compass for mobile robots" (Robotics and Autonomous Systems 57, 2009). docs/peers.md lists what is known of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "workbench/experiments/peers/color_classes.h"
#include "workbench/experiments/peers/horizon.h"
#include "workbench/experiments/peers/orientation_compass.h"

namespace reorient {

struct TransitionCompassParameters {
  int classes = 16;
  double chroma = 2.0;
  double light_memory = 0.0;
  double palette = 10.0;
  int sectors = 80;
  int columns = 80;
  double elevation = 0.3;
  int bands = 3;
  double radius = 8.0;
  double prior = 200.0;
  double cap = 4.0;
};
template <typename Visit>
void describe(TransitionCompassParameters& p, Visit&& visit) {
  visit("classes", p.classes, 2, 24, "", "number of color classes");
  visit("chroma", p.chroma, 0.0, 10.0, "", "weight of chroma relative to luma when color classes are found");
  visit("light_memory", p.light_memory, 0.0, 600.0, "s",
        "time constant of the mean color of the room, which is subtracted; 0: colors as the camera measures them");
  visit("palette", p.palette, 0.0, 600.0, "s", "time at the start of learning in which the color classes are found");
  visit("sectors", p.sectors, 4, 720, "", "number of sectors of the circle, rounded to an even number");
  visit("columns", p.columns, 4, 640, "", "number of scan lines in an image");
  visit("elevation", p.elevation, 0.02, 1.0, "rad", "height of the scan lines above the horizon");
  visit("bands", p.bands, 1, 8, "",
        "number of parts of that height with separate scan lines, so that a camera that looks down sees some of them");
  visit("radius", p.radius, 6.0, 100.0, "m",
        "radius of the wall to which azimuths refer; 100 m is practically infinite");
  visit("prior", p.prior, 0.01, 1000.0, "", "number of scan lines of the whole room that each sector starts with");
  visit("cap", p.cap, 0.01, 100.0, "", "largest log-likelihood of one scan line");
}

/// Scan lines go up from the horizon, band by band. For each sector of the circle, each band and each ordered pair of
/// color classes it is learned how often a line has none, one, or several transitions from the first to the second. A
/// line's log-likelihood in a sector is the sum over the pairs.
class TransitionCompass : public OrientationCompass {
 public:
  explicit TransitionCompass(const TransitionCompassParameters& parameters = {}, std::uint64_t seed = 0);

  void learn(const RoomObservation& view) override;
  void begin() override { score_ = 0.0; }
  double compare(const RoomObservation& view) override;
  std::unique_ptr<OrientationCompass> clone() const override { return std::make_unique<TransitionCompass>(*this); }

 private:
  /// Upwards in a column of the image.
  struct ScanLine {
    int x = 0;  // pixels
    double bottom = 0.0;
    double top = 0.0;
    int band = 0;
    double azimuth = 0.0;  // rad
  };

  bool look(const RoomObservation& view);
  void sample_colors(const RoomObservation& view);
  void scan(const RoomObservation& view, const ScanLine& line);
  static Ycbcr pixel_of(const ImageView& image, const ScanLine& line, int k);
  void prepare();
  void prepare(std::size_t here, int pair, const std::array<double, 2>& usual);
  /// Index of a sector's band, and of a pair of classes in it.
  std::size_t place(int sector, int band) const { return static_cast<std::size_t>(sector * parameters_.bands + band); }
  std::size_t cell(std::size_t place, int pair) const {
    return place * static_cast<std::size_t>(pairs_) + static_cast<std::size_t>(pair);
  }
  std::size_t places() const { return place(parameters_.sectors, 0); }

  TransitionCompassParameters parameters_;
  std::uint64_t seed_;
  Wall wall_;
  std::vector<double> slopes_;  // upper end of each band
  RunningLight light_;
  std::vector<Ycbcr> palette_;  // colors at the start
  double first_time_ = 0.0;
  bool any_time_ = false;
  ColorClasses classes_;
  int pairs_ = 0;  // classes^2

  std::vector<int> lines_;                         // learned, for each place
  std::vector<std::array<float, 2>> transitions_;  // lines with one and with several, for each place and pair
  bool is_prepared_ = false;
  std::vector<double> nothing_;              // log-likelihood of a line without any transition, by place
  std::vector<std::array<float, 2>> gains_;  // by which one or several transitions change it

  // Of this frame.
  std::vector<HorizonColumn> columns_;
  std::vector<ScanLine> scan_lines_;
  std::vector<int> counts_;   // of each pair on the current scan line
  std::vector<int> present_;  // pairs with a count
  double score_ = 0.0;
};

}  // namespace reorient
