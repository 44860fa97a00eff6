// SPDX-License-Identifier: MIT
// A compass on features of the horizon, after Anderson and Hengst, "Fast monocular visual compass for a computationally
// limited robot" (RoboCup 2013), and their landmarks of 2012. docs/peers.md lists what is known of them.
#pragma once

#include <vector>

#include "workbench/experiments/peers/horizon.h"
#include "workbench/experiments/peers/horizon_features.h"
#include "workbench/experiments/peers/orientation_compass.h"

namespace reorient {

struct HorizonCompassParameters {
  double band = 0.047;
  double contrast = 0.01;
  double radius = 8.0;
  double tolerance = 0.06;
  double same = 0.3;
  double cap = 0.6;
  int least_seen = 1;
  int landmarks = 4;
};
template <typename Visit>
void describe(HorizonCompassParameters& p, Visit&& visit) {
  visit("band", p.band, 0.002, 0.3, "rad", "height of the strip around the horizon whose mean brightness is the row");
  visit("contrast", p.contrast, 0.0, 1.0, "",
        "smallest contrast of a feature, as a fraction of the mean brightness of the row");
  visit("radius", p.radius, 6.0, 100.0, "m",
        "radius of the wall to which azimuths refer; 100 m is practically infinite");
  visit("tolerance", p.tolerance, 0.001, 0.5, "rad",
        "largest difference between the azimuths of a feature and its landmark");
  visit("same", p.same, 0.0, 2.0, "", "largest distance between two descriptors of the same landmark");
  visit("cap", p.cap, 0.0, 2.0, "",
        "upper limit of the distance between descriptors, also used if no landmark is near");
  visit("landmarks", p.landmarks, 1, 1000, "",
        "largest number of landmarks in a sector of 2.5 degrees; a new one replaces the one seen least often");
  visit("least_seen", p.least_seen, 1, 1000, "", "smallest number of observations at which a landmark counts");
}

/// It learns a map of landmarks by azimuth. It compares how well each feature fits the nearest landmark at its azimuth,
/// and at the azimuth rotated by 180 degrees.
class HorizonCompass : public OrientationCompass {
 public:
  explicit HorizonCompass(const HorizonCompassParameters& parameters = {});

  void learn(const RoomObservation& view) override;
  void begin() override { score_ = 0.0; }
  double compare(const RoomObservation& view) override;
  std::unique_ptr<OrientationCompass> clone() const override { return std::make_unique<HorizonCompass>(*this); }

 private:
  struct Landmark {
    double azimuth = 0.0;  // rad
    bool bright = false;
    HorizonDescriptor descriptor{};
    int seen = 0;
  };
  struct Sector {
    std::vector<Landmark> landmarks;
    int looked_at = 0;  // frames
  };
  struct Match {
    Landmark* landmark = nullptr;
    double distance = 0.0;
  };

  bool look(const RoomObservation& view);
  Match nearest(double azimuth, const HorizonFeature& feature, int least_seen);
  void add(double azimuth, const HorizonFeature& feature);
  Sector& sector_at(double azimuth);

  HorizonCompassParameters parameters_;
  Wall wall_;
  std::vector<Sector> sectors_;

  // Of this frame.
  HorizonFeatureFinder finder_;
  std::vector<HorizonColumn> columns_;
  std::vector<float> row_;
  std::span<const HorizonFeature> features_;
  double score_ = 0.0;
};

}  // namespace reorient
