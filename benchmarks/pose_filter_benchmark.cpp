// SPDX-License-Identifier: MIT
// Time of self-localization: of the classic filter step for each particle, and of the real update in one frame.
#include <cmath>

#include <benchmark/benchmark.h>

#include "localization/measurement/field_map.h"
#include "localization/pose_filter.h"

namespace reorient {
namespace {

constexpr double kFrame = 1.0 / 30.0;  // s

GoalPost post_seen_from(const Pose2& robot, const Eigen::Vector2d& in_field) {
  return {robot.inverse() * in_field, true, Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};
}

/// Two goal posts and this many line points on the front line of the penalty area and on the goal line.
FieldPercept percept_from(const Pose2& robot, int line_points) {
  FieldPercept percept;
  percept.goal_posts = {post_seen_from(robot, {4.5, 0.8}), post_seen_from(robot, {4.5, -0.8})};
  Random random(1);
  for (int i = 0; i < line_points; ++i) {
    const Eigen::Vector2d in_field(i % 2 == 0 ? 2.85 : 4.5, random.uniform(-2.0, 2.0));
    const Eigen::Vector2d seen = robot.inverse() * in_field + 0.05 * Eigen::Vector2d(random.normal(), random.normal());
    percept.line_points.push_back({seen, -robot.rotation, Eigen::Vector2f::Zero()});
  }
  return percept;
}

void report_per_particle(benchmark::State& state, std::size_t particles) {
  state.counters["per_particle"] = benchmark::Counter(
      static_cast<double>(particles), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Predicts, reweights by two landmarks and resamples in each step.
void predict_reweight_resample(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Pose2 robot(1.5, 0.3, 0.1);
  ParticleSet particles(count);
  ParticleSet scratch(count);
  Random random(1);
  for (std::size_t i = 0; i < count; ++i) {
    particles.set_pose(i, robot * Pose2(0.1 * random.normal(), 0.1 * random.normal(), 0.05 * random.normal()));
  }
  MeasurementModel measurement{FieldDimensions(), MeasurementModelParameters()};
  measurement.observe(percept_from(robot, 0));
  std::vector<float> costs(count);
  const Eigen::Vector2d half_size = believable_half_size(FieldDimensions());
  for ([[maybe_unused]] auto _ : state) {
    predict(particles, Pose2(), kFrame, MotionModelParameters(), half_size, random);
    measurement.costs(particles, costs);
    weigh(particles, costs, 1.0f);
    resample_systematic(particles, scratch, random.uniform());
    std::swap(particles, scratch);
    benchmark::DoNotOptimize(particles.x.data());
  }
  report_per_particle(state, count);
}
BENCHMARK(predict_reweight_resample)->Arg(200)->Arg(500)->Arg(2000);

/// Each part of this step alone.
void predict_only(benchmark::State& state) {
  ParticleSet particles(200);
  Random random(1);
  const Eigen::Vector2d half_size = believable_half_size(FieldDimensions());
  for ([[maybe_unused]] auto _ : state) {
    predict(particles, Pose2(), kFrame, MotionModelParameters(), half_size, random);
    benchmark::DoNotOptimize(particles.x.data());
  }
  report_per_particle(state, particles.size());
}
BENCHMARK(predict_only);

void reweight_only(benchmark::State& state) {
  const ParticleSet particles(200);
  MeasurementModel measurement{FieldDimensions(), MeasurementModelParameters()};
  measurement.observe(percept_from(Pose2(), static_cast<int>(state.range(0))));
  std::vector<float> costs(200);
  for ([[maybe_unused]] auto _ : state) {
    measurement.costs(particles, costs);
    benchmark::DoNotOptimize(costs.data());
  }
  report_per_particle(state, particles.size());
}
BENCHMARK(reweight_only)->ArgName("line_points")->Arg(0)->Arg(40);

void resample_only(benchmark::State& state) {
  const ParticleSet particles(200);
  ParticleSet scratch(200);
  Random random(1);
  for ([[maybe_unused]] auto _ : state) {
    resample_systematic(particles, scratch, random.uniform());
    benchmark::DoNotOptimize(scratch.x.data());
  }
  report_per_particle(state, particles.size());
}
BENCHMARK(resample_only);

/// One frame as in the engine: predict and update, with 40 line points and two posts.
void pose_filter_frame(benchmark::State& state, SeenGoal seen_goal) {
  PoseFilterParameters parameters;
  parameters.particles = static_cast<int>(state.range(0));
  PoseFilter filter(parameters, FieldDimensions(), 1);
  const Pose2 robot(1.5, 0.3, 0.1);
  filter.set_initial_pose(robot, 0.1, 0.05);
  const FieldPercept percept = percept_from(robot, 40);
  for ([[maybe_unused]] auto _ : state) {
    filter.predict(Pose2(), kFrame);
    filter.update(percept, seen_goal);
    benchmark::DoNotOptimize(filter.belief().cluster_weight);
  }
  report_per_particle(state, filter.particles().size());
}
BENCHMARK_CAPTURE(pose_filter_frame, unknown_goal, SeenGoal::unknown)->Arg(100)->Arg(200)->Arg(500);
BENCHMARK_CAPTURE(pose_filter_frame, known_goal, SeenGoal::opponent)->Arg(200);

/// The same while the pose is unknown, which takes longest.
void pose_filter_lost_frame(benchmark::State& state) {
  PoseFilter filter(PoseFilterParameters(), FieldDimensions(), 1);
  const FieldPercept percept = percept_from({1.5, 0.3, 0.1}, 40);
  for ([[maybe_unused]] auto _ : state) {
    filter.initialize_globally();
    filter.predict(Pose2(), kFrame);
    filter.update(percept, SeenGoal::unknown);
    benchmark::DoNotOptimize(filter.belief().cluster_weight);
  }
}
BENCHMARK(pose_filter_lost_frame);

void field_map(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const FieldMap map{FieldDimensions()};
    benchmark::DoNotOptimize(&map);
  }
}
BENCHMARK(field_map)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace reorient
