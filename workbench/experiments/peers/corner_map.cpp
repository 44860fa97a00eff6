// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/corner_map.h"

#include <algorithm>

#include "geometry/pinned_math.h"
#include "workbench/experiments/peers/horizon.h"

namespace reorient {
namespace {

// An even number, so that each sector has a mirrored one. Each has the same share of the landmarks: otherwise the first
// views would fill the map.
constexpr int kSectors = 20;
constexpr int kLeastChances = 30;  // frames that should show a landmark before it may be removed

Eigen::Vector3d mirrored_about_center(const Eigen::Vector3d& vector) { return {-vector.x(), -vector.y(), vector.z()}; }

}  // namespace

CornerMap::CornerMap(const CornerMapParameters& parameters) : parameters_(parameters), sectors_(kSectors) {}

/// The landmarks that were seen in at least `least_seen` frames.
std::vector<CornerMap::Candidate> CornerMap::candidates(const Eigen::Vector3d& eye, int least_seen) const {
  std::vector<Candidate> candidates;
  for (std::size_t sector = 0; sector < sectors_.size(); ++sector) {
    for (std::size_t place = 0; place < sectors_[sector].size(); ++place) {
      const CornerLandmark& landmark = sectors_[sector][place];
      if (landmark.seen < least_seen) continue;
      candidates.push_back({(landmark.position - eye).normalized(), sector, place, landmark.descriptor, false});
    }
  }
  return candidates;
}

/// The landmark that explains a corner best, of those within the gates that no other corner uses.
CornerMap::Match CornerMap::nearest(const SeenCorner& corner, std::vector<Candidate>& candidates) const {
  // The chord between two directions instead of their angle needs no arc cosine: within 0.1 % of it up to 0.15 rad.
  const double gate = parameters_.gate_angle * parameters_.gate_angle;
  const double angle_scale = 0.5 / (parameters_.angle_deviation * parameters_.angle_deviation);
  const double bits_scale = 0.5 / (parameters_.bits_deviation * parameters_.bits_deviation);
  Match best;
  for (Candidate& candidate : candidates) {
    if (candidate.is_used) continue;
    const double angle_squared = (candidate.direction - corner.ray).squaredNorm();
    if (!(angle_squared <= gate)) continue;
    const int bits = distance(candidate.descriptor, corner.descriptor);
    if (bits > parameters_.gate_bits) continue;
    const double log_likelihood =
        std::max(0.0, parameters_.gain - angle_scale * angle_squared - bits_scale * bits * bits);
    if (best.candidate != nullptr && log_likelihood <= best.log_likelihood) continue;
    best = {&candidate, log_likelihood};
  }
  return best;
}

void CornerMap::learn(const CornerView& view) {
  std::vector<Candidate> known = candidates(view.eye(), 1);
  std::vector<const SeenCorner*> unexplained;
  for (const SeenCorner& corner : view.corners()) {
    const Match match = nearest(corner, known);
    if (match.candidate == nullptr) {
      unexplained.push_back(&corner);
      continue;
    }
    match.candidate->is_used = true;
    CornerLandmark& landmark = sectors_[match.candidate->sector][match.candidate->place];
    constexpr int kLongest = 100;  // frames in the running mean
    const double share = 1.0 / std::min(++landmark.seen, kLongest);
    const Eigen::Vector3d seen_at = view.eye() + (landmark.position - view.eye()).norm() * corner.ray;
    landmark.position += share * (seen_at - landmark.position);
  }
  for (const Candidate& candidate : known) {
    CornerLandmark& landmark = sectors_[candidate.sector][candidate.place];
    if (!candidate.is_used && view.shows(landmark.position)) ++landmark.missed;
  }
  for (Sector& sector : sectors_)
    std::erase_if(sector, [this](const CornerLandmark& landmark) { return is_lost(landmark); });
  for (const SeenCorner* corner : unexplained) add(view.eye(), *corner);
}

bool CornerMap::is_lost(const CornerLandmark& landmark) const {
  const int chances = landmark.seen + landmark.missed;
  return chances >= kLeastChances && landmark.seen < parameters_.least_share * chances;
}

/// In a full sector a new landmark replaces the one that was seen least, but never one that is seen often enough to
/// count.
void CornerMap::add(const Eigen::Vector3d& eye, const SeenCorner& corner) {
  const CornerLandmark landmark{eye + parameters_.distance * corner.ray, corner.descriptor, 1, 0};
  const int sector = sector_of(direction_of(landmark.position.head<2>()), kSectors);
  Sector& landmarks = sectors_[static_cast<std::size_t>(sector)];
  if (landmarks.size() < static_cast<std::size_t>(parameters_.landmarks / kSectors)) {
    landmarks.push_back(landmark);
    return;
  }
  const auto least = std::min_element(landmarks.begin(), landmarks.end(),
                                      [](const auto& a, const auto& b) { return a.seen < b.seen; });
  if (least->seen < parameters_.least_seen) *least = landmark;
}

CornerFit CornerMap::fit(const CornerView& view, bool mirrored) const {
  const Eigen::Vector3d eye = mirrored ? mirrored_about_center(view.eye()) : view.eye();
  std::vector<Candidate> known = candidates(eye, parameters_.least_seen);
  CornerFit fit;
  for (SeenCorner corner : view.corners()) {
    if (mirrored) corner.ray = mirrored_about_center(corner.ray);
    const Match match = nearest(corner, known);
    if (match.candidate == nullptr || match.log_likelihood <= 0.0) continue;
    match.candidate->is_used = true;
    ++fit.matches;
    fit.log_likelihood += match.log_likelihood;
  }
  return fit;
}

double CornerMap::coverage() const {
  const auto counts = [this](const CornerLandmark& landmark) { return landmark.seen >= parameters_.least_seen; };
  const auto covered = std::count_if(sectors_.begin(), sectors_.end(), [&](const Sector& sector) {
    return std::any_of(sector.begin(), sector.end(), counts);
  });
  return static_cast<double>(covered) / kSectors;
}

int CornerMap::size() const {
  std::size_t count = 0;
  for (const Sector& sector : sectors_) count += sector.size();
  return static_cast<int>(count);
}

}  // namespace reorient
