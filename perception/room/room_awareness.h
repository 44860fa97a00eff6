// SPDX-License-Identifier: MIT
// Room awareness (the paper's Section 3): computes confidences in the believed pose and in its reflection from images
// and the believed pose. It has no clock and no random device: time and seed are arguments.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "perception/room/background_model.h"
#include "perception/room/color/color_histogram.h"
#include "perception/room/color/histogram_distance.h"
#include "perception/room/compared_model.h"
#include "perception/room/evidence/evidence.h"
#include "perception/room/evidence/informative_views.h"
#include "perception/room/evidence/pose_lights.h"
#include "perception/room/room_observation.h"
#include "perception/room/saved_model.h"
#include "perception/room/separability.h"
#include "perception/room/view/confidences.h"
#include "perception/room/view/view_filter.h"
#include "perception/room/view/viewpoint_scores.h"
#include "perception/room/wall/light_adaptation.h"
#include "perception/room/wall/perceived_tiles.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// Each part has its own describe(). The defaults adapt to the light and start from true means. The published method is
/// another set of values (assets/parameters/paper.toml).
struct RoomParameters {
  WallParameters wall;
  ColorParameters color;
  LightParameters light;
  PoseLightParameters pose_light;
  PerceptionParameters perception;
  BackgroundParameters background;
  DistanceParameters distance;
  ViewFilterParameters view_filter;
  ConfidenceParameters confidence;
  EvidenceParameters evidence;
  ViewParameters views;
};

/// Calls visit(prefix, part) for each part that has a describe() of its own.
template <typename Visit>
void for_each_part(RoomParameters& p, Visit&& visit) {
  visit("wall", p.wall);
  visit("color", p.color);
  visit("light_adaptation", p.light);
  visit("pose_light", p.pose_light);
  visit("perceived_tiles", p.perception);
  visit("background_model", p.background);
  visit("histogram_distance", p.distance);
  visit("view_filter", p.view_filter);
  visit("confidence", p.confidence);
  visit("evidence", p.evidence);
  visit("views", p.views);
}

/// s between two images. A longer gap does not count as observation time.
inline constexpr double kLongestLook = 0.2;

/// How tiles are compared.
Comparison comparison_of(const RoomParameters& parameters);
/// The fraction of the log-odds that counts as evidence. It is 0 in a symmetric room, except if the parameters disable
/// this.
double evidence_weight(const RoomParameters& parameters, const Separability& separability);

class RoomAwareness {
 public:
  explicit RoomAwareness(const RoomParameters& parameters = {}, std::uint64_t seed = 0);

  /// Processes one frame in the paper's order: tiles, histograms, background model, view filter, confidences. Views
  /// with values that are not finite, or from outside of the wall, show no tiles and do not update the view filter.
  const Confidences& update(const RoomObservation& view);

  /// Handles a granted command. The confidences restart, after a purge only if the parameters require it. A flip
  /// changes the believed pose but not the robot, so the view filter's belief is unchanged. Call on_flip() also if the
  /// belief changes to its reflection without a command, or if an external localization flips it.
  void on_flip();
  void on_purge();
  void on_reset();

  /// The robot may be at another position, or its pose was set from outside, so earlier observations have no evidence.
  /// The confidences restart, and the view filter's belief becomes uniform.
  void restart();

  /// The teams change sides: the axes rotate by 180 degrees, and the belief with them. All observations refer to the
  /// same positions under their new coordinates. The confidences are unchanged. Applying it twice is the identity. Also
  /// used if a room was learned with the axes mirrored; then restart() follows, since the belief does not rotate.
  void rotate_by_180_degrees();

  /// Forgets the model, the view filter's belief, the confidences and the light. The random number generator continues.
  void forget();

  /// Replaces the model with one that was learned before. Everything else restarts, as in forget(). Throws UnfitModel,
  /// with one line, if the model has another basis.
  void take_model(const SavedModel& saved);

  /// Takes effect with the next frame. Another wall, or another way to count colors, makes the model invalid. Then the
  /// room is forgotten and the result is true.
  bool set_parameters(const RoomParameters& parameters);
  const RoomParameters& parameters() const { return parameters_; }

  const Confidences& confidences() const { return confidences_; }
  const Wall& wall() const { return wall_; }
  const BackgroundModel& model() const { return model_; }
  /// The parameters that define the meaning of the model's numbers.
  ModelBasis basis() const;
  std::span<const PerceivedTile> perceived() const { return perceived_.tiles(); }
  const ViewFilter& view_filter() const { return filter_; }
  /// Of the last frame; empty if its view was not evaluated.
  const ViewpointScores& scores() const { return scores_; }
  /// Contribution of each tile of the wall to Confidences::evidence, in log-odds: positive for the mirrored pose,
  /// negative for the believed pose, 0 for a tile that was not in view recently. After a frame whose view was
  /// evaluated, the sum is Confidences::evidence. After another frame it may differ slightly, since the model may have
  /// been trained.
  void tile_evidence(std::vector<double>& log_odds) const;
  const Light& light() const { return light_.light(); }
  /// Azimuth of the wall at which the camera pointed in the last frame according to the belief, rad. Empty if it
  /// pointed nowhere.
  std::optional<double> center_of_view() const { return view_center_; }
  /// Direction of the camera in the last evaluated frame: rad, in the odometry frame.
  std::optional<double> last_direction() const { return last_direction_; }
  /// Informative directions for the camera, as of the last frame.
  const InformativeViews& informative_views() const { return views_.views(); }

  /// Everything that decides later frames: model, view filter's belief, confidences, light, random numbers. Does not
  /// contain the parameters. Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.light_, self.pose_lights_, self.model_, self.separability_, self.filter_, self.evidence_, self.views_,
            self.confidences_, self.last_time_, self.last_direction_, self.view_center_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  void complete();
  double seconds_since_last(double time);  // 0 if the time does not increase
  void perceive(const RoomObservation& view, double elapsed);
  void train(double step);
  void evaluate(const RoomObservation& view, double step);
  double turn_since_last(const RoomObservation& view);
  void restart_evidence();
  void reflect_evidence();
  void take_evidence();

  RoomParameters parameters_;
  Wall wall_;
  LightAdaptation light_;
  PoseLights pose_lights_;
  PerceivedTiles perceived_;
  BackgroundModel model_;
  ComparedModel compared_model_;
  Separability separability_;
  ViewpointScores scores_;
  ViewFilter filter_;
  Evidence evidence_;
  Confidences confidences_;
  ViewChooser views_;
  Light believed_light_;  // of this frame
  std::optional<double> last_time_;
  std::optional<double> last_direction_;  // camera yaw in the robot + odometry at the last evaluation, rad
  std::optional<double> view_center_;
};

}  // namespace reorient
