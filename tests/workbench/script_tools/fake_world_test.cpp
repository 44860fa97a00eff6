// SPDX-License-Identifier: MIT
// Compares the fake world of scripted tests with the engine: for the same inputs, behaviors see the same world.
#include "workbench/script_tools/testing/fake_world.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "engine/frame.h"
#include "engine/script/behaviors.h"
#include "geometry/random.h"
#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

/// Does what the teammates request.
constexpr std::string_view kObedient = R"(
local function hears(word)
  for i = 1, team.heard() do if team.text(i) == word then return true end end
  return false
end
behavior "tested" {
  initial = "idle",
  update = function()
    walk.velocity(0.1, 0, 0)
    if hears("flip") then command.flip_pose() end
    if hears("purge") then command.purge_reflection() end
    if hears("reset") then command.reset_orientation() end
  end,
  state "idle" {
    { "training_paused", when = function() return hears("pause training") end, because = "by request" },
    { "evaluation_paused", when = function() return hears("pause evaluation") end, because = "by request" },
  },
  state "training_paused" {
    enter = function() command.pause_training() end,
    { "idle", when = function() return hears("resume") end, because = "by request" },
  },
  state "evaluation_paused" {
    enter = function() command.pause_evaluation() end,
    { "idle", when = function() return hears("resume") end, because = "by request" },
  },
})";

/// Fields that are computed from the rest of the world. All other fields are sensed, also the measured speed: after a
/// reorientation this test gives the fake world another odometry.
const std::set<std::string_view> kDerived{"clock.time",        "clock.step",
                                          "clock.frame",       "robot.posture_before",
                                          "robot.posture_for", "robot.may_walk",
                                          "training.active",   "training.seconds",
                                          "evaluation.active", "robot.time_since_disturbance",
                                          "confidence.status", "pose.known",
                                          "confidence.age",    "confidence.can_tell",
                                          "robot.walking",     "robot.requested_speed",
                                          "robot.head_moving", "robot.head_speed"};

/// A mistake that is inserted into the rules of the fake world to prove that the comparison finds it.
enum class Fault {
  none,
  no_time_step,
  late_posture,
  posture_before_kept,
  undisturbed_in_a_fall,
  undisturbed_in_a_penalty,
  walks_when_penalized,
  no_referee,
  walks_when_stopped,
  gets_up_at_will,
  training_in_a_fall,
  training_of_an_unknown_pose,
  training_when_paused,
  training_of_a_set_pose,
  evaluation_in_a_fall,
  evaluation_when_paused,
  trained_without_images,
  age_kept_by_a_lift,
  age_kept_by_a_set_pose,
  age_kept_by_a_jump,
  known_after_a_reset,
  age_kept_by_a_flip,
  evidence_kept_by_a_flip,
  default_status,
  kFaults
};

class TwoWorlds {
 public:
  explicit TwoWorlds(std::uint64_t seed, Fault fault = Fault::none)
      : random_(seed),
        fault_(fault),
        is_external_(random_.below(4) == 0),
        loop_(std::string(kObedient), setup(seed)),
        fake_(parameters_, 0.0),
        behaviors_(texts(), parameters_) {
    parameters_.bind("arbiter", arbiter_parameters_);
    behaviors_.host().load("behaviors/tested.lua");
    if (random_.below(2) == 0) loop_.inputs.observation.upper.reset();
  }

  /// The first difference; empty: no difference.
  std::optional<std::string> run() {
    const std::uint64_t frames = 4 + random_.below(20);
    for (std::uint64_t i = 0; i < frames && !is_over_; ++i) {
      if (auto difference = frame()) return "frame " + std::to_string(i) + ": " + *difference;
    }
    return std::nullopt;
  }

 private:
  static FrameSetup setup(std::uint64_t seed) {
    FrameSetup setup;
    setup.seed = seed;
    return setup;
  }
  static ScriptTexts texts() {
    ScriptTexts texts("the scripts");
    texts.apply({"behaviors/tested.lua", ScriptText{std::string(kObedient), ""}});
    return texts;
  }
  bool seldom(std::uint64_t in = 8) { return random_.below(in) == 0; }
  Pose2 some_pose() {
    return Pose2({random_.uniform(-4.5, 4.5), random_.uniform(-3.0, 3.0)}, random_.uniform(-kPi, kPi));
  }

  void tell(ExternalInputs& external) {
    if (seldom()) {
      RefereeState& referee = external.referee.emplace();
      referee.penalized = seldom(3);
      referee.stopped = seldom(4);
      referee.state = static_cast<GameState>(random_.below(7));
      referee.kick_off = static_cast<KickOff>(random_.below(3));
    }
    if (seldom()) external.initial_pose = InitialPose{some_pose()};
    if (seldom(20)) external.half_time = true;
    if (seldom()) external.notes.emplace_back("a note");
    for (const char* word : {"flip", "purge", "reset", "pause training", "pause evaluation", "resume", "hello"})
      if (seldom()) external.messages.push_back({1, word});
  }

  void sense(Observation& observation) {
    if (seldom(4)) {  // another posture begins
      BodySample& body = observation.body;
      body = {};
      const std::uint64_t kind = random_.below(4);
      if (kind == 1) body.torso.pitch = 1.4;
      if (kind == 2) body.foot_load = 0.0;
      if (kind == 3) body.angular_velocity.y() = 3.0;
    }
    observation.reported_posture = static_cast<ReportedPosture>(random_.below(20) < 5 ? random_.below(5) : 0);
    const Pose2 step(Eigen::Vector2d(random_.uniform(-0.05, 0.05), 0.0), random_.uniform(-0.2, 0.2));
    observation.odometry = observation.odometry * (seldom(20) ? some_pose() : step);
    observation.belief.reset();
    if (is_external_) {
      ExternalBelief& belief = observation.belief.emplace();
      if (seldom(6)) external_ = seldom(2) ? reflect(external_) : some_pose();
      belief.pose = external_;
      belief.covariance = Eigen::Vector3d(0.01, 0.01, seldom(6) ? 9.0 : 0.01).asDiagonal();
    }
  }

  void change_parameters() {
    if (!seldom()) return;
    const std::vector<std::pair<const char*, std::string>> all{
        {"arbiter.flip_cooldown", "0.1"},       {"arbiter.reset_cooldown", "0.1"}, {"room_status.age", "0.02"},
        {"room_status.coverage", "0"},          {"room_status.separability", "0"}, {"room_status.distinctiveness", "0"},
        {"confidence.restart_on_purge", "true"}};
    const auto& [name, value] = all[random_.below(all.size())];
    const ParameterChange change{name, value, ParameterOrigin::live, ""};
    loop_.inputs.parameter_changes.push_back(change);
    if (fault_ == Fault::default_status && change.name.starts_with("room_status")) return;
    parameters_.change(change);
  }

  std::optional<std::string> frame() {
    FrameInputs& inputs = loop_.inputs;
    Observation& observation = inputs.observation;
    const Pose2 odometry_before = observation.odometry;
    if (has_begun_) observation.time += seldom(10) ? random_.uniform(0.0, 2.0) : HandFedLoop::kStep;
    sense(observation);
    observation.external = {};
    tell(seldom(2) ? observation.external : inputs.external);
    change_parameters();
    if (seldom(15)) {
      const std::string edited = std::string(kObedient) + (seldom(2) ? "-- edited" : "(");
      inputs.script_edits.push_back({"behaviors/tested.lua", ScriptText{edited, ""}});
      behaviors_.apply(inputs.script_edits, arbiter_, application_);
    }
    if (observation.upper) {
      observation.upper->time = observation.time;
      observation.upper->odometry = observation.odometry;
    }
    observation.body.time = observation.time;
    const double age_before = age_;
    const FrameRecord& record = loop_.engine->step(inputs);
    inputs.parameter_changes.clear();
    inputs.script_edits.clear();
    inputs.external = {};

    FakeSenses senses;
    if (has_begun_) senses.moved = odometry_before.inverse() * observation.odometry;
    // After a purge or a reset, the belief of the pose filter is not exactly that of the fake world.
    if (was_rearranged_) senses.moved = fake_.world().pose.pose.inverse() * believed_ * senses.moved;
    believed_ = record.world.pose.pose;
    has_begun_ = true;
    senses.is_pose_set = record.inputs.initial_pose.has_value() && fault_ != Fault::age_kept_by_a_set_pose;
    senses.sees = observation.upper || fault_ == Fault::trained_without_images;
    age_ = record.world.confidence.age;
    // Detected from the age only, so a restart that reaches the same value is missed.
    const bool may_restart = record.posture_change || record.inputs.initial_pose || was_rearranged_ ||
                             record.world.referee.penalized != was_penalized_;
    senses.knows_tiles = age_ != 0.0 && (age_ != age_before || may_restart);
    was_rearranged_ = record.reorientation.has_value();
    was_penalized_ = record.world.referee.penalized;
    if (record.reorientation && is_external_) is_over_ = true;  // carried out elsewhere
    show(record.world, is_over_ || record.reorientation.has_value());
    Arbitration last = arbiter_.last();
    if (fault_ == Fault::training_when_paused) last.train = true;
    if (fault_ == Fault::evaluation_when_paused) last.evaluate = true;
    World world = fake_.begin_frame(observation.time, last, senses);
    spoil(world, record);
    behaviors_.tick(world, record.inputs.messages);
    arbiter_.set_parameters(arbiter_parameters_);
    const Arbitration& arbitration = arbiter_.arbitrate(behaviors_.wanted().commands, behaviors_.leases(), world);
    if (!record.reorientation) {
      if (auto difference = compare(record, world)) return difference;
    }
    Request request = permitted(behaviors_.wanted().request, world);
    if (fault_ == Fault::walks_when_stopped) request = behaviors_.wanted().request;
    if (request.walk.forward != record.answer.request.walk.forward) return "the request to walk";
    if (arbitration.commands.size() != record.commands.size()) return "the commands";
    for (std::size_t i = 0; i < arbitration.commands.size(); ++i) {
      if (arbitration.commands[i].verdict != record.commands[i].verdict) return "a verdict";
    }
    if (arbitration.train == record.answer.training_paused) return "the lease on training";
    if (arbitration.evaluate == record.answer.evaluation_paused) return "the lease on evaluation";
    fake_.end_frame(arbitration, permitted(behaviors_.wanted().request, world));
    if (is_over_ || !record.reorientation) return std::nullopt;
    world = fake_.world();
    if (fault_ == Fault::known_after_a_reset) world.pose_known = true;
    if (fault_ == Fault::age_kept_by_a_flip) world.confidence.age = 1.0;
    if (fault_ == Fault::evidence_kept_by_a_flip) world.confidence.evidence = 3.0;
    if (record.reorientation->reorientation == Reorientation::flip_pose &&
        !are_near(world.pose.pose, record.world.pose.pose, 1e-6, 1e-6))
      return "the flipped pose";
    return compare(record, world);
  }

  /// Sets what the engine has sensed. The record contains belief and evidence at the end of the frame, after a granted
  /// command has changed them.
  void show(const World& world, bool is_rearranged) {
    std::vector<double> values;
    append_world(world, values);
    const std::span<const WorldField> all = world_fields();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string name = all[i].full_name();
      const bool is_known_elsewhere = name == "pose.known" && is_external_;
      if (kDerived.contains(name) && !is_known_elsewhere) continue;
      if (!all[i].replacement.empty()) continue;
      if (fault_ == Fault::no_referee && all[i].table == "game" && name != "game.sides_changed") continue;
      WorldValue value{all[i].type, values[i], {}};
      if (value.type == WorldField::Type::name) value.name = all[i].names[static_cast<std::size_t>(values[i])];
      fake_.set(all[i].table, all[i].name, value);
    }
    if (!is_rearranged) return;
    const ReorientationRecord& reorientation = *loop_.record().reorientation;
    if (reorientation.reorientation == Reorientation::flip_pose)
      fake_.set("confidence", "evidence", {WorldField::Type::number, -world.confidence.evidence, {}});
    const PoseBelief& before = reorientation.belief_before;
    fake_.set("pose", "x", {WorldField::Type::number, before.pose.position.x(), {}});
    fake_.set("pose", "y", {WorldField::Type::number, before.pose.position.y(), {}});
    fake_.set("pose", "rotation", {WorldField::Type::number, before.pose.rotation, {}});
    fake_.set("pose", "cluster_weight", {WorldField::Type::number, before.cluster_weight, {}});
    fake_.set("pose", "reflected_weight", {WorldField::Type::number, before.reflected_weight, {}});
  }

  void spoil(World& world, const FrameRecord& record) {
    switch (fault_) {
      case Fault::no_time_step:
        world.time_step = HandFedLoop::kStep;
        break;
      case Fault::late_posture:
        if (record.posture_change) world.posture_for = HandFedLoop::kStep;
        break;
      case Fault::posture_before_kept:
        world.posture_before = Posture::upright;
        break;
      case Fault::undisturbed_in_a_fall:
        if (!world.upright()) world.time_since_disturbance = HandFedLoop::kStep;
        break;
      case Fault::undisturbed_in_a_penalty:
        if (world.referee.penalized) world.time_since_disturbance += HandFedLoop::kStep;
        break;
      case Fault::walks_when_penalized:
        if (world.referee.penalized) world.may_walk = true;
        break;
      case Fault::gets_up_at_will:
        world.can_get_up = false;
        break;
      case Fault::training_in_a_fall:
        if (!world.upright()) world.training = world.pose_known;
        break;
      case Fault::training_of_an_unknown_pose:
        world.training = world.upright() && arbiter_.last().train;
        break;
      case Fault::training_of_a_set_pose:
        if (record.inputs.initial_pose) world.training = world.upright();
        break;
      case Fault::evaluation_in_a_fall:
        world.evaluating = arbiter_.last().evaluate;
        break;
      case Fault::age_kept_by_a_lift:
        if (world.time_since_disturbance == 0.0) world.confidence.age = 1.0;
        break;
      case Fault::age_kept_by_a_jump:
        if (seldom(4) && world.confidence.age == 0.0) world.confidence.age = age_ + 1.0;
        break;
      default:
        break;
    }
  }

  std::optional<std::string> compare(const FrameRecord& record, const World& fake) {
    std::vector<double> expected, actual;
    append_world(record.world, expected);
    append_world(fake, actual);
    const std::span<const WorldField> all = world_fields();
    for (std::size_t i = 0; i < all.size(); ++i) {
      // The belief of a pose filter after a command depends on its particles.
      if (record.reorientation && all[i].table == "pose" && all[i].name != "known") continue;
      const double tolerance = all[i].table == "clock" || all[i].unit == "s" ? 1e-9 : 0.0;
      if (std::abs(expected[i] - actual[i]) <= tolerance || expected[i] == actual[i]) continue;
      return all[i].full_name() + " is " + std::to_string(actual[i]) + ", of the engine " + std::to_string(expected[i]);
    }
    return std::nullopt;
  }

  Random random_;
  Fault fault_;
  bool is_external_;
  HandFedLoop loop_;
  ParameterRegistry parameters_;
  ArbiterParameters arbiter_parameters_;
  FakeWorld fake_;
  Behaviors behaviors_;
  Arbiter arbiter_;
  ApplicationState application_;
  Pose2 external_;
  Pose2 believed_;  // by the engine, at the end of the previous frame
  bool has_begun_ = false;
  bool is_over_ = false;
  bool was_rearranged_ = false;  // in the previous frame
  bool was_penalized_ = false;
  double age_ = 0.0;
};

constexpr std::uint64_t kSequences = 250;

void expect_equal_worlds(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const auto difference = TwoWorlds(seed).run();
    ASSERT_FALSE(difference) << "seed " << seed << ", " << *difference;
  }
}

TEST(FakeWorld, EqualsTheWorldOfTheEngineForTheSameInputs) { expect_equal_worlds(1, kSequences); }

/// Runs 10^4 sequences in parts, so that each part ends within the time limit of a test on a slow machine.
class FakeWorldForLong : public testing::TestWithParam<std::uint64_t> {};

constexpr std::uint64_t kParts = 10, kSequencesOfAPart = 1'000;

TEST_P(FakeWorldForLong, EqualsTheWorldOfTheEngineForTheSameInputs) {
  const std::uint64_t last = GetParam() * kSequencesOfAPart;
  expect_equal_worlds(std::max(last - kSequencesOfAPart, kSequences) + 1, last);
}

INSTANTIATE_TEST_SUITE_P(Parts, FakeWorldForLong, testing::Range(std::uint64_t{1}, kParts + 1));

TEST(FakeWorld, FollowsTheRulesOfTheEngineOnly) {
  for (int fault = static_cast<int>(Fault::none) + 1; fault < static_cast<int>(Fault::kFaults); ++fault) {
    bool is_found = false;
    for (std::uint64_t seed = 1; seed <= kSequences && !is_found; ++seed)
      is_found = TwoWorlds(seed, static_cast<Fault>(fault)).run().has_value();
    EXPECT_TRUE(is_found) << "fault " << fault << " was not noticed";
  }
}

}  // namespace
}  // namespace reorient
