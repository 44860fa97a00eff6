// SPDX-License-Identifier: MIT
// Landmarks beyond the carpet: corners, each with an assumed position at a fixed distance from the camera that first
// saw it, because a single camera measures only bearings.
#pragma once

#include <cstddef>
#include <vector>

#include "workbench/experiments/peers/corner_view.h"

namespace reorient {

struct CornerMapParameters {
  int landmarks = 500;    // published
  double distance = 6.0;  // published, m
  double gate_angle = 0.15;
  int gate_bits = 80;
  double angle_deviation = 0.08;
  double bits_deviation = 40.0;
  double gain = 2.0;
  int least_seen = 5;
  double least_share = 0.1;
};
template <typename Visit>
void describe(CornerMapParameters& p, Visit&& visit) {
  visit("landmarks", p.landmarks, 20, 10000, "", "largest number of landmarks in the map");
  visit("distance", p.distance, 1.0, 100.0, "m", "assumed distance of a landmark from where it is first seen");
  visit("gate_angle", p.gate_angle, 0.001, 0.5, "rad", "largest angle between a corner and its landmark");
  visit("gate_bits", p.gate_bits, 0, 256, "", "largest number of bits in which their descriptors differ");
  visit("angle_deviation", p.angle_deviation, 0.001, 0.5, "rad",
        "standard deviation of the angle between a corner and its landmark");
  visit("bits_deviation", p.bits_deviation, 1.0, 256.0, "",
        "standard deviation of the number of bits in which their descriptors differ");
  visit("gain", p.gain, 0.0, 20.0, "", "log-likelihood ratio of a perfect match against a corner without a landmark");
  visit("least_seen", p.least_seen, 1, 1000, "",
        "smallest number of frames in which a landmark was seen before it counts as evidence");
  visit("least_share", p.least_share, 0.0, 1.0, "",
        "smallest fraction of the frames that should show a landmark in which it must be found");
}

struct CornerLandmark {
  Eigen::Vector3d position;  ///< field frame, m
  CornerDescriptor descriptor{};
  int seen = 0;    ///< number of frames in which a corner matched it
  int missed = 0;  ///< number of frames that should have shown it, but did not
};

/// How well the corners of one frame fit the map.
struct CornerFit {
  int matches = 0;
  double log_likelihood = 0.0;  ///< against corners that no landmark explains
};

class CornerMap {
 public:
  explicit CornerMap(const CornerMapParameters& parameters);

  /// Learns one frame whose believed pose is right.
  void learn(const CornerView& view);
  /// The fit of the believed pose or of the mirrored pose. Each landmark explains at most one corner.
  CornerFit fit(const CornerView& view, bool mirrored) const;
  /// Fraction of the sectors around the field's center that contain a landmark that counts.
  double coverage() const;
  /// Number of landmarks.
  int size() const;

 private:
  using Sector = std::vector<CornerLandmark>;
  /// A landmark, seen from the camera.
  struct Candidate {
    Eigen::Vector3d direction;  // field frame, of length 1
    std::size_t sector = 0, place = 0;
    CornerDescriptor descriptor{};
    bool is_used = false;
  };
  struct Match {
    Candidate* candidate = nullptr;  // null: no landmark is within the gates
    double log_likelihood = 0.0;
  };

  std::vector<Candidate> candidates(const Eigen::Vector3d& eye, int least_seen) const;
  Match nearest(const SeenCorner& corner, std::vector<Candidate>& candidates) const;
  void add(const Eigen::Vector3d& eye, const SeenCorner& corner);
  bool is_lost(const CornerLandmark& landmark) const;

  CornerMapParameters parameters_;
  std::vector<Sector> sectors_;
};

}  // namespace reorient
