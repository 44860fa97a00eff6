// SPDX-License-Identifier: MIT
// Room awareness (the paper's Section 3): from images and the believed pose to confidences in that pose and in its
// reflection. Pure: time and seed are arguments.
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

/// Each part has its own describe(). The defaults adapt to the light and start from true means; the recipe as it was
/// published is another set of values (assets/parameters/paper.toml).
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

/// s between two images; a longer gap is not time in which anything was seen.
inline constexpr double kLongestLook = 0.2;

/// How tiles are compared.
Comparison comparison_of(const RoomParameters& parameters);
/// The fraction of the log-odds that counts as evidence: none in a symmetric room, unless the parameters say otherwise.
double evidence_weight(const RoomParameters& parameters, const Separability& separability);

class RoomAwareness {
 public:
  explicit RoomAwareness(const RoomParameters& parameters = {}, std::uint64_t seed = 0);

  /// One frame, in the paper's order: tiles, histograms, background model, view filter, confidences. Views with
  /// anything that is not finite, or from outside of the wall, show no tiles; then the filter rests too.
  const Confidences& update(const RoomObservation& view);

  /// What a granted command means here: the confidences restart, after a purge only if the parameters say so. A flip
  /// turns the belief and not the robot: the belief of the view stays. It is a flip, too, if the belief goes over to
  /// its reflection by itself, or another localization turns it.
  void on_flip();
  void on_purge();
  void on_reset();

  /// The robot may stand elsewhere now, or was told where it stands: what was seen before says nothing any more. The
  /// confidences begin anew, the belief of the view is all around.
  void restart();

  /// The teams change sides: the axes turn by half a turn, and with them the belief. Everything is known of the same
  /// places as before, under their new coordinates; the confidences stay. Done twice, it is the identity. Also for a
  /// room that was learned mirrored; restart() follows then, since the belief does not turn with it.
  void turn_half();

  /// Forgets the model, the belief of the view, the confidences and the light; the random numbers go on.
  void forget();

  /// Goes on with what was learned before, instead of what there is; all else begins anew, as in forget(). Throws
  /// UnfitModel, with one line, where it was learned on another basis.
  void take_model(const SavedModel& saved);

  /// From the next frame on. Another wall (or another way of counting colours) makes the model void: then true, and the
  /// room is forgotten.
  bool set_parameters(const RoomParameters& parameters);
  const RoomParameters& parameters() const { return parameters_; }

  const Confidences& confidences() const { return confidences_; }
  const Wall& wall() const { return wall_; }
  const BackgroundModel& model() const { return model_; }
  /// What the model's numbers mean.
  ModelBasis basis() const;
  std::span<const PerceivedTile> perceived() const { return perceived_.tiles(); }
  const ViewFilter& view_filter() const { return filter_; }
  const ViewpointScores& scores() const { return scores_; }
  const Light& light() const { return light_.light(); }
  /// Where on the wall the belief says that the camera looked in the last frame, rad; nothing if nowhere.
  std::optional<double> center_of_view() const { return view_center_; }
  /// In which direction the camera looked in the last frame that was evaluated: rad, in the frame of the odometry.
  std::optional<double> last_direction() const { return last_direction_; }
  /// Which way to turn the camera, as of the last frame.
  const InformativeViews& informative_views() const { return views_.views(); }

  /// All that decides what comes next: model, belief of the view, confidences, light, random numbers; parameters are as
  /// they are. Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.light_, self.pose_lights_, self.model_, self.separability_, self.filter_, self.evidence_, self.views_,
            self.confidences_, self.last_time_, self.last_direction_, self.view_center_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  void complete();
  double seconds_since_last(double time);  // 0 where time does not go on
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
