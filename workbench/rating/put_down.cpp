// SPDX-License-Identifier: MIT
#include "workbench/rating/put_down.h"

#include <algorithm>
#include <cmath>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/behaviors.h"
#include "engine/world/arbiter.h"
#include "engine/world/room_status.h"
#include "engine/world/world_tracker.h"
#include "geometry/pinned_math.h"
#include "perception/room/evidence/evidence.h"
#include "perception/room/evidence/informative_views.h"
#include "perception/room/separability.h"
#include "perception/room/view/viewpoint_scores.h"

namespace reorient {
namespace {

constexpr double kStep = 1.0 / 30.0;  // s

void take_overrides(ParameterRegistry& registry, const RatedRobot& robot) {
  for (const ParameterChange& change : robot.parameters) registry.set_early(change);
}

/// RoomAwareness without images.
class SyntheticAwareness {
 public:
  SyntheticAwareness(const RatedModel& model, const CoreParameters& core)
      : model_(model), core_(core), confidences_(model.confidences()) {
    evidence_.restart(model.wall.tiles());
    views_.restart(model.wall.columns());
  }

  void observe(const std::vector<PerceivedTile>& visible, const Looks& looks, bool is_mirrored) {
    perceived_ = visible;
    for (PerceivedTile& tile : perceived_) {
      const int real = is_mirrored ? model_.wall.reflected(tile.tile) : tile.tile;
      tile.histogram = tile.reflected_histogram = looks[static_cast<std::size_t>(real)];
    }
    scores_.compute(perceived_, model_.compared, model_.wall, model_.comparison,
                    tolerated_columns(core_.room.evidence, model_.wall));
    evidence_.observe(scores_.places(), model_.compared, kStep, core_.room.evidence);
    confidences_.evidence = model_.separability_weight * evidence_.log_odds();
    if (!scores_.places().empty()) confidences_.age += kStep;
    confidences_.visible_tiles = static_cast<int>(perceived_.size());
  }

  const InformativeViews& choose_view(const Pose2& belief, const Isometry3& robot_from_camera) {
    return views_.choose(model_.wall, model_.compared, belief, robot_from_camera, kStep,
                         core_.room.perception.min_incidence, core_.room.views);
  }

  const Confidences& confidences() const { return confidences_; }

 private:
  const RatedModel& model_;
  const CoreParameters& core_;
  Evidence evidence_;
  ViewChooser views_;
  ViewpointScores scores_;
  Confidences confidences_;
  std::vector<PerceivedTile> perceived_;
};

/// Parameters and scripts of one robot.
class Brain {
 public:
  explicit Brain(const RatedRobot& robot)
      : core_(core_parameters_for(robot.field, robot.body)), behaviors_(robot.scripts, registry_, limits_) {
    take_overrides(registry_, robot);
    declare(core_, registry_);
    registry_.bind("script", limits_);
    arbiter_.set_parameters(core_.arbiter);
    for (const std::string& behavior : robot.behaviors) behaviors_.host().load(behavior);
  }

  const CoreParameters& core() const { return core_; }
  std::optional<double> parameter(const char* name) const {
    const Parameter* const found = registry_.find(name);
    if (found == nullptr || !std::holds_alternative<double>(found->value)) return std::nullopt;
    return std::get<double>(found->value);
  }
  const BehaviorOutput& wanted() const { return behaviors_.wanted(); }

  /// Commands of the behaviors, and those that are granted. Valid until the next call.
  const Arbitration& decide(const World& world) {
    behaviors_.tick(world);
    return arbiter_.arbitrate(behaviors_.wanted().commands, behaviors_.leases(), world);
  }
  const Arbitration& decided() const { return arbiter_.last(); }

 private:
  ParameterRegistry registry_;
  CoreParameters core_;
  ScriptLimits limits_;
  Behaviors behaviors_;
  Arbiter arbiter_;
};

void turn_head(HeadAngles& head, const Request& request, const RobotBody& body) {
  if (!request.head) return;
  const HeadAngles wanted = body.neck.clamp(request.head->angles);
  const double most = std::min(request.head->speed, body.head_speed) * kStep;
  head.yaw += std::clamp(wanted.yaw - head.yaw, -most, most);
  head.pitch += std::clamp(wanted.pitch - head.pitch, -most, most);
}

bool is_flip(const Arbitration& decided) {
  return decided.granted && decided.granted->request.reorientation == Reorientation::flip_pose;
}

/// The training time in s is that of the model, because nothing is learned during the trial.
World world_in_the_hands(const RatedRobot& robot, const RatedModel& model, const Pose2& belief) {
  World world = world_of(robot.field, robot.body);
  world.pose.pose = belief;
  world.pose.cluster_weight = 1.0;
  world.pose_known = true;
  world.trained_seconds = model.learned_for;
  return world;
}

}  // namespace

CoreParameters core_parameters_of(const RatedRobot& robot) {
  CoreParameters core = core_parameters_for(robot.field, robot.body);
  ParameterRegistry registry;
  take_overrides(registry, robot);
  declare(core, registry);
  return core;
}

/// The same formulas as in scripts/lib/decision.lua.
std::optional<DecisionLimits> decision_limits_of(const RatedRobot& robot) {
  const Brain brain(robot);
  const auto false_flips = brain.parameter("decision.false_flips"), looks = brain.parameter("decision.looks"),
             disturbances = brain.parameter("decision.disturbances"), least = brain.parameter("decision.least");
  if (!false_flips || !looks || !disturbances || !least) return std::nullopt;
  const auto limit = [&](double chances) { return std::max(*least, pinned::log(chances / *false_flips)); };
  return DecisionLimits{limit(*disturbances), limit(*looks), *disturbances, *looks};
}

RatedModel::RatedModel(const SavedModel& model, const CoreParameters& core)
    : learned(model.model), learned_for(model.learned), wall(model.basis.wall), comparison(comparison_of(core.room)) {
  compared.prepare(learned, wall, comparison);
  Separability test;
  test.restart(wall.columns());
  for (int column = 0; column < wall.columns(); ++column) test.observe(compared, wall);
  separability = test.probability();
  separability_weight = evidence_weight(core.room, test);
}

Confidences RatedModel::confidences() const {
  Confidences confidences;
  confidences.coverage = compared.coverage();
  confidences.paired = compared.paired();
  confidences.distinctiveness = compared.distinctiveness();
  confidences.separability = separability;
  return confidences;
}

RoomStatus RatedModel::status(const RoomStatusParameters& parameters) const {
  World world;
  world.evaluating = true;
  world.confidence = confidences();
  world.confidence.age = parameters.age;
  return room_status(world, parameters);
}

PutDownResult put_down(const PutDown& how, const RatedRobot& robot, const RatedModel& model, const Looks& looks,
                       VisibleTiles& visible) {
  Brain brain(robot);
  SyntheticAwareness room(model, brain.core());
  WorldTracker tracker(world_in_the_hands(robot, model, visible.pose()));
  HeadAngles head = robot.body.neck.clamp({how.head_yaw, 0.0});
  PutDownResult result;
  const int last = static_cast<int>(std::lround(how.limit / kStep));
  const int landing = static_cast<int>(std::lround((how.lowering + brain.core().posture.lifted_time) / kStep));
  for (int frame = 0; frame <= last; ++frame) {
    tracker.begin_frame(frame * kStep);
    // No comparison runs before the landing, so the landing restarts nothing.
    tracker.take_posture(frame < landing ? SensedPosture{Posture::lifted, Posture::upright, 0.0}
                                         : SensedPosture{Posture::upright, Posture::lifted, landing * kStep});
    tracker.permit_views(brain.decided(), true);
    if (tracker.world().evaluating) {
      result.has_evaluated = true;
      room.observe(visible.at(head), looks, how.is_mirrored);
      result.most_evidence = std::max(result.most_evidence, room.confidences().evidence);
    }
    const InformativeViews& views = room.choose_view(
        visible.pose(), robot_from_camera(robot.body.dimensions, head, {}, robot.body.dimensions.torso_height));
    tracker.take_room(room.confidences(), views);
    tracker.take_field({.head = head});
    tracker.judge_room(brain.core().room_status);
    if (is_flip(brain.decide(tracker.world()))) {
      result.flipped_after = tracker.world().time;
      return result;
    }
    turn_head(head, brain.wanted().request, robot.body);
  }
  return result;
}

}  // namespace reorient
