// SPDX-License-Identifier: MIT
// A simulated client whose detector sees the truth with noise: what its percepts improve.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/covered_areas.h"
#include "engine/frame.h"
#include "geometry/random.h"
#include "geometry/transform.h"
#include "robots/simulator/simulator.h"
#include "tests/paths.h"
#include "workbench/files/script_files.h"
#include "workbench/simulated_images/in_view.h"

namespace reorient {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

enum class Detector { none, robots, field };

/// Finds 80 % of the things that are clearly in view, with an error of 1 pixel along each axis.
class SimulatedDetector {
 public:
  SimulatedDetector(const Simulator& simulator, const FieldDimensions& field) : simulator_(simulator), field_(field) {}

  void look(const CameraFrame& frame, Detector detector) {
    found_.clear();
    camera_ = &frame.camera;
    camera_from_robot_ = simulator_.field_from_camera().inverse() * to_isometry(simulator_.ground_truth().pose);
    const FieldInView view = field_in_view(simulator_, frame, field_);
    if (detector == Detector::robots) {
      for (const Player& player : simulator_.other_robots()) add_robot(view.robot.inverse() * player.pose.position);
    } else if (detector == Detector::field) {
      for (std::size_t i = 0; i < view.line_places.size(); i += 4) add_line_point(view.line_places[i].position, view);
      for (const Thing& post : view.goal_posts) {
        if (post.clearly) add_post(post.position);
      }
      for (const IntersectionInView& one : view.intersections) {
        if (one.clearly) add_intersection(one);
      }
      for (const Thing& mark : view.penalty_marks) {
        if (mark.clearly) add(PerceptType::penalty_mark, {pixel(mark.position, 0.0)});
      }
    }
  }
  const std::vector<ExternalPercept>& found() const { return found_; }

 private:
  std::optional<Vector2d> pixel(const Vector2d& place, double height) const {
    return camera_->project(camera_from_robot_ * Vector3d(place.x(), place.y(), height));
  }
  void add(PerceptType type, const std::vector<std::optional<Vector2d>>& points,
           std::optional<double> direction = std::nullopt) {
    constexpr double kFound = 0.8, kNoise = 1.0;  // pixels
    ExternalPercept percept{.type = type, .space = PerceptSpace::upper_image, .direction = direction};
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i]) return;
      percept.at[2 * i] = points[i]->x() + kNoise * random_.normal();
      percept.at[2 * i + 1] = points[i]->y() + kNoise * random_.normal();
    }
    if (random_.uniform() < kFound) found_.push_back(percept);
  }
  void add_line_point(const Vector2d& place, const FieldInView& view) {
    const double along = nearest_line_of(field_, view.robot * place).normal + 0.5 * kPi - view.robot.rotation;
    const auto from = pixel(place, 0.0), to = pixel(place + 0.02 * unit_vector(along), 0.0);
    if (from && to) add(PerceptType::line_point, {from}, direction_of(*to - *from));
  }
  void add_post(const Vector2d& place) {
    add(PerceptType::goal_post, {pixel(place, 0.0), pixel(place, field_.goal_height)});
  }
  void add_intersection(const IntersectionInView& one) {
    constexpr PerceptType kTypes[] = {PerceptType::l_intersection, PerceptType::t_intersection,
                                      PerceptType::x_intersection};
    add(kTypes[static_cast<std::size_t>(one.kind)], {pixel(one.position, 0.0)});
  }
  /// The box of a walking NAO.
  void add_robot(const Vector2d& place) {
    constexpr double kHalf = 0.2, kTall = 0.6;  // m
    if (!(place.norm() > 0.3)) return;
    const Vector2d beside = kHalf * Vector2d(-place.y(), place.x()).normalized();
    Vector2d least(1e4, 1e4), most(-1e4, -1e4);
    for (const double height : {0.0, kTall}) {
      for (const Vector2d& side : {beside, Vector2d(-beside)}) {
        const auto seen = pixel(place + side, height);
        if (!seen) return;
        least = least.cwiseMin(*seen);
        most = most.cwiseMax(*seen);
      }
    }
    add(PerceptType::robot, {least, most});
    if (!found_.empty() && !mistake_in(found_.back()).empty()) found_.pop_back();
  }

  const Simulator& simulator_;
  const FieldDimensions& field_;
  Random random_{7};
  const CameraModel* camera_ = nullptr;
  Isometry3 camera_from_robot_ = Isometry3::Identity();
  std::vector<ExternalPercept> found_;
};

struct DetectorFigures {
  double position_rmse = 0.0;     ///< m, also of the mirrored pose
  double located = 0.0;           ///< fraction of the frames within 0.3 m
  double uncovered_robots = 0.0;  ///< fraction of the pixels of robots above the horizon that count as room
};

/// A robot walks between the penalty marks for `seconds`.
DetectorFigures figures_of(Detector detector, bool replaces, const SimulatorParameters& parameters, double seconds,
                           std::uint64_t seed) {
  FrameSetup setup;
  setup.scripts = read_scripts(std::filesystem::path(kSourceFolder) / "scripts");
  setup.behaviors = {"background_training", "head_scan", "penalty_marks"};
  setup.seed = seed;
  const Pose2 start(-2.0, 1.0, 0.5);
  const FieldDimensions field;
  Simulator simulator(parameters, RobotBody(), field, procedural_hall(1, {}), start, seed);
  SimulatedDetector client(simulator, field);
  FrameLoop engine(std::move(setup));
  FrameInputs inputs;
  inputs.external.initial_pose = InitialPose{start, 0.3, 0.2};
  double squares = 0.0, robot_pixels = 0.0, uncovered = 0.0;
  int frames = 0, located = 0;
  std::vector<CoveredArea> covered;
  for (int i = 0; i < static_cast<int>(30.0 * seconds); ++i) {
    simulator.observe(inputs.observation);
    const CameraFrame& upper = *inputs.observation.upper;
    inputs.observation.percepts.reset();
    if (detector != Detector::none) {
      client.look(upper, detector);
      inputs.observation.percepts = {replaces, client.found()};
    }
    const FrameRecord& record = engine.step(inputs);
    inputs.external = {};
    simulator.answer(record.answer);
    const Pose2 truth = simulator.ground_truth().pose, believed = record.world.pose.pose;
    const double error =
        std::min((truth.position - believed.position).norm(), (truth.position + believed.position).norm());
    squares += error * error;
    located += error < 0.3 ? 1 : 0;
    ++frames;
    collect_covered(record.percepts[0], covered);
    const Isometry3 camera = simulator.field_from_camera();
    for (int y = 0; y < upper.image.height; ++y) {
      for (int x = 0; x < upper.image.width; ++x) {
        if (simulator.labels()[static_cast<std::size_t>(y * upper.image.width + x)] != Label::robot) continue;
        if ((camera.linear() * upper.camera.ray({x, y})).z() <= 0.0) continue;
        robot_pixels += 1.0;
        uncovered += std::none_of(covered.begin(), covered.end(),
                                  [&](const CoveredArea& area) {
                                    return x >= area.left && x <= area.right && y >= area.top && y <= area.bottom;
                                  })
                         ? 1.0
                         : 0.0;
      }
    }
  }
  return {std::sqrt(squares / frames), static_cast<double>(located) / frames,
          robot_pixels > 0.0 ? uncovered / robot_pixels : 0.0};
}

/// `REORIENT_SEEDS` replaces `seeds`, for docs/evidence/companion.md.
DetectorFigures mean_figures(const std::string& name, Detector detector, bool replaces,
                             const SimulatorParameters& parameters, double seconds, int seeds = 1) {
  if (const char* const wanted = std::getenv("REORIENT_SEEDS")) seeds = std::max(1, std::atoi(wanted));
  DetectorFigures sum;
  for (int seed = 1; seed <= seeds; ++seed) {
    const DetectorFigures one = figures_of(detector, replaces, parameters, seconds, static_cast<std::uint64_t>(seed));
    sum.position_rmse += one.position_rmse / seeds;
    sum.located += one.located / seeds;
    sum.uncovered_robots += one.uncovered_robots / seeds;
  }
  std::cout << name << ": position " << sum.position_rmse << " m, located " << 100.0 * sum.located
            << " %, robots that count as room " << 100.0 * sum.uncovered_robots << " %\n";
  return sum;
}

SimulatorParameters detector_images() {
  SimulatorParameters parameters;
  parameters.width = 160;
  parameters.labels = true;
  return parameters;
}

TEST(SimulatedDetector, OfRobotsKeepsThemOutOfTheLearnedRoom) {
  SimulatorParameters parameters = detector_images();
  parameters.other_robots = 9;
  const DetectorFigures without = mean_figures("9 robots, without", Detector::none, false, parameters, 25.0);
  const DetectorFigures with = mean_figures("9 robots, with", Detector::robots, false, parameters, 25.0);
  EXPECT_GT(without.uncovered_robots, 0.1);
  EXPECT_LT(with.uncovered_robots, 0.6 * without.uncovered_robots);
}

TEST(SimulatedDetector, OfLinesLocatesTheRobotOnAWornField) {
  SimulatorParameters parameters = detector_images();
  parameters.other_robots = 9;
  parameters.worn_lines = 0.6;
  constexpr int kSeeds = 2;  // one robot alone may be as exact without the detector
  const auto figures = [&](const std::string& name, Detector detector, bool replaces) {
    return mean_figures("worn lines, " + name, detector, replaces, parameters, 40.0, kSeeds);
  };
  const DetectorFigures without = figures("without", Detector::none, false);
  const DetectorFigures with = figures("with", Detector::field, false);
  const DetectorFigures instead = figures("instead", Detector::field, true);
  EXPECT_LT(with.position_rmse, without.position_rmse);
  EXPECT_LT(instead.position_rmse, without.position_rmse);
}

}  // namespace
}  // namespace reorient
