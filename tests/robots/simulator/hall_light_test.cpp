// SPDX-License-Identifier: MIT
#include "robots/simulator/render/light/hall_light.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "geometry/transform.h"
#include "robots/simulator/render/renderer.h"
#include "robots/simulator/simulator.h"
#include "tests/robots/simulator/mean_luma.h"
#include "tests/robots/simulator/shared_hall.h"

namespace reorient {
namespace {

HallLightParameters hard_light() {
  HallLightParameters light;
  light.exposure_spread = 0.5;
  light.white_balance_spread = 0.18;
  light.white_balance_drift = 0.06;
  light.daylight = 1.0;
  light.daylight_wander = 0.8;
  light.lamps_off = 0.5;
  light.wall_changed = 0.2;
  light.people_exchanged = 0.5;
  light.people_turnover = 0.5;
  return light;
}

SimulatorParameters hard_simulator() {
  SimulatorParameters parameters;
  parameters.width = 160;
  parameters.light = hard_light();
  return parameters;
}

std::vector<std::uint8_t> upper_bytes(const Observation& observation) {
  const ImageView& image = observation.upper->image;
  return {image.data, image.data + static_cast<std::ptrdiff_t>(image.stride) * image.height};
}

TEST(HallLight, IsAsUsualUntilItIsChanged) {
  HallLight light(hard_light(), 7.0, 1);
  light.advance(1.0);
  EXPECT_FALSE(light.changed());
  EXPECT_TRUE(light.illumination().as_usual());
  EXPECT_TRUE((light.gains() == 1.0).all());
}

TEST(HallLight, StaysAsUsualIfAllChangesAreZero) {
  HallLight light(HallLightParameters{}, 7.0, 1);
  light.change();
  light.advance(1.0);
  EXPECT_TRUE(light.illumination().as_usual());
  EXPECT_TRUE((light.gains() == 1.0).all());
  EXPECT_TRUE(light.draw_patches(shared_hall()).empty());
}

TEST(HallLight, DrawsExposureAndWhiteBalanceFromTheirWholeRange) {
  double least = 1e9;
  double most = -1e9;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    HallLight light(hard_light(), 7.0, seed);
    light.change();
    const Eigen::Array3d gains = light.gains().log();
    EXPECT_LE(std::abs(gains.y()), 0.5 + 1e-9);
    EXPECT_LE(std::abs(gains.x() - gains.y()), 0.18 + 1e-9);
    EXPECT_LE(std::abs(gains.z() - gains.y()), 0.18 + 1e-9);
    least = std::min(least, gains.y());
    most = std::max(most, gains.y());
  }
  EXPECT_LT(least, -0.45);
  EXPECT_GT(most, 0.45);
}

TEST(HallLight, LetsTheWhiteBalanceDriftWithItsStandardDeviationAndTimeConstant) {
  HallLightParameters parameters;
  parameters.white_balance_drift = 0.06;
  parameters.white_balance_time = 15.0;
  double early = 0.0;
  double late = 0.0;
  constexpr int kHalls = 400;
  for (std::uint64_t seed = 0; seed < kHalls; ++seed) {
    HallLight light(parameters, 7.0, seed);
    light.change();
    light.advance(1.5);
    early += std::pow(std::log(light.gains().x()), 2) / kHalls;
    for (int i = 0; i < 100; ++i) light.advance(1.0);
    late += std::pow(std::log(light.gains().x()), 2) / kHalls;
  }
  EXPECT_NEAR(std::sqrt(late), 0.06, 0.006);
  EXPECT_NEAR(std::sqrt(early), 0.06 * std::sqrt(1.0 - std::exp(-0.2)), 0.006);
}

TEST(HallLight, TurnsOffHalfOfTheLampsInAThirdOfTheHalls) {
  HallLightParameters parameters;
  parameters.lamps_off = 1.0 / 3.0;
  int off = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    HallLight light(parameters, 7.0, seed);
    light.change();
    off += light.illumination().fraction_off > 0.0f ? 1 : 0;
  }
  EXPECT_NEAR(off / 600.0, 1.0 / 3.0, 0.06);
}

TEST(HallLight, LetsDaylightWanderToAndFro) {
  HallLightParameters parameters;
  parameters.daylight = 1.0;
  parameters.daylight_wander = 0.8;
  parameters.daylight_period = 100.0;
  HallLight light(parameters, 7.0, 3);
  light.change();
  const Eigen::Vector2f from = light.illumination().daylight;
  light.advance(25.0);
  EXPECT_NEAR(std::acos(from.dot(light.illumination().daylight)), 0.8f, 1e-3f);
  light.advance(25.0);
  EXPECT_NEAR((from - light.illumination().daylight).norm(), 0.0f, 1e-3f);
}

TEST(Illumination, AddsAllStopsInTheMiddleOfAQuarterAndHalfOfThemAtItsEnds) {
  Illumination illumination;
  illumination.daylight_stops = 1.0f;
  EXPECT_NEAR(illumination.gain(8.0f, 0.0f), 2.0f, 1e-4f);
  EXPECT_NEAR(illumination.gain(6.0f, 6.0f), std::sqrt(2.0f), 1e-4f);
  EXPECT_FLOAT_EQ(illumination.gain(0.0f, 7.0f), 1.0f);
  EXPECT_FLOAT_EQ(illumination.gain(-8.0f, 1.0f), 1.0f);
  EXPECT_FLOAT_EQ(illumination.gain(0.0f, 0.0f), 1.0f);
}

TEST(Illumination, IsDarkerWhereTheLampsAreOff) {
  Illumination illumination;
  illumination.fraction_off = 0.65f;
  illumination.toward_dark = Eigen::Vector2f::UnitY();
  illumination.lamp_height = 4.0f;
  EXPECT_NEAR(illumination.gain(0.0f, 1e4f), 0.35f, 1e-3f);
  EXPECT_NEAR(illumination.gain(0.0f, -1e4f), 1.0f, 1e-3f);
  EXPECT_NEAR(illumination.gain(3.0f, 0.0f), 1.0f - 0.325f, 1e-4f);
  EXPECT_NEAR(illumination.gain(3.0f, 3.0f), 1.0f - 0.325f * 1.6f, 1e-4f)
      << "3 m into the dark half, 4 m below the lamps";
}

TEST(WallPatches, CoverTheRequestedFractionOfTheWallForEachSeed) {
  RoomShape round;
  round.form = RoomForm::cylinder;
  for (const RoomShape& shape : {RoomShape{}, round}) {
    Room room;
    room.shape = shape;
    for (const double fraction : {0.1, 0.2, 0.4}) {
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const WallPatches patches(fraction, 3.5, room, random);
        EXPECT_NEAR(patches.area() / (3.5 * wall_perimeter(shape)), fraction, 0.002);
      }
    }
  }
}

TEST(Illumination, IsTheSameAfterARotationBy180DegreesIfItIsRepeated) {
  Illumination illumination;
  illumination.daylight_stops = 1.0f;
  illumination.daylight = unit_vector(0.4).cast<float>();
  illumination.fraction_off = 0.65f;
  illumination.toward_dark = Eigen::Vector2f::UnitY();
  illumination.repeated = true;
  for (const Eigen::Vector2f& place : {Eigen::Vector2f(8.0f, 2.0f), Eigen::Vector2f(-3.0f, 6.0f), {0.5f, -6.0f}})
    EXPECT_EQ(illumination.gain(place.x(), place.y()), illumination.gain(-place.x(), -place.y()));
  EXPECT_NE(illumination.gain(8.0f, 0.0f), illumination.gain(0.0f, 6.0f));
}

TEST(WallPatches, AreSymmetricInASymmetricRoom) {
  for (const RoomSymmetry symmetry : {RoomSymmetry::two_fold, RoomSymmetry::four_fold}) {
    Room room;
    room.shape.symmetry = symmetry;
    Random random(3);
    const WallPatches patches(0.2, 3.5, room, random);
    const double perimeter = wall_perimeter(room.shape);
    EXPECT_NEAR(patches.area() / (3.5 * perimeter), 0.2, 0.002);
    int painted = 0;
    for (int i = 0; i < 400; ++i) {
      const auto here = static_cast<float>((i + 0.5) * 0.5 * perimeter / 400);
      const float u[] = {here, here + static_cast<float>(0.5 * perimeter)};
      const float v[] = {1.5f, 1.5f};
      const float footprint[] = {0.1f, 0.1f};
      const float on_wall[] = {1.0f, 1.0f};
      float red[] = {-1.0f, -1.0f}, green[] = {-1.0f, -1.0f}, blue[] = {-1.0f, -1.0f};
      patches.paint({u, v, footprint, on_wall, 2}, red, green, blue);
      EXPECT_NEAR(red[0], red[1], 1e-3f) << here;
      painted += red[0] > -0.5f ? 1 : 0;
    }
    EXPECT_GT(painted, 40);
  }
}

TEST(WallPatches, PaintTheAreaThatTheyReport) {
  Room room;
  Random random(5);
  const WallPatches patches(0.2, 3.5, room, random);
  const double perimeter = wall_perimeter(room.shape);
  constexpr int kColumns = 3000;
  constexpr int kRows = 175;
  const std::vector<float> footprint(kColumns, 0.02f);
  const std::vector<float> on_wall(kColumns, 1.0f);
  std::vector<float> u(kColumns), v(kColumns), red(kColumns), green(kColumns), blue(kColumns);
  double painted = 0.0;
  for (int j = 0; j < kRows; ++j) {
    for (std::size_t i = 0; i < kColumns; ++i) {
      u[i] = static_cast<float>((static_cast<double>(i) + 0.5) * perimeter / kColumns);
      v[i] = static_cast<float>((j + 0.5) * 3.5 / kRows);
      red[i] = green[i] = blue[i] = -1.0f;
    }
    patches.paint({u.data(), v.data(), footprint.data(), on_wall.data(), kColumns}, red.data(), green.data(),
                  blue.data());
    for (const float value : red) painted += value > -0.5f ? 1.0 : 0.0;
  }
  EXPECT_NEAR(painted / (kColumns * kRows), 0.2, 0.01);
}

TEST(WallPatches, ChangeOnlyTheWall) {
  Room room;
  Random random(5);
  const WallPatches patches(0.5, 3.5, room, random);
  const float u[] = {1.0f, 20.0f};
  const float v[] = {1.0f, 1.0f};
  const float footprint[] = {0.1f, 0.1f};
  const float on_wall[] = {0.0f, 0.0f};
  float red[] = {0.3f, 0.4f}, green[] = {0.3f, 0.4f}, blue[] = {0.3f, 0.4f};
  patches.paint({u, v, footprint, on_wall, 2}, red, green, blue);
  EXPECT_EQ(red[0], 0.3f);
  EXPECT_EQ(blue[1], 0.4f);
}

TEST(ChangedLight, DoesNotAffectThePicturesBeforeTheChange) {
  SimulatorParameters usual = hard_simulator();
  usual.light = {};
  Simulator one(usual, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, 0.5 * kPi), 5);
  Simulator two(hard_simulator(), RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, 0.5 * kPi), 5);
  Observation a;
  Observation b;
  for (int frame = 0; frame < 20; ++frame) {
    one.observe(a);
    two.observe(b);
    ASSERT_EQ(upper_bytes(a), upper_bytes(b)) << "frame " << frame;
  }
  one.change_light();
  two.change_light();
  for (int frame = 0; frame < 5; ++frame) {
    one.observe(a);
    two.observe(b);
    ASSERT_NE(upper_bytes(a), upper_bytes(b)) << "frame " << frame;
  }
}

TEST(ChangedLight, ChangesNoPixelIfAllChangesAreZero) {
  SimulatorParameters usual = hard_simulator();
  usual.light = {};
  Simulator one(usual, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, 0.5 * kPi), 5);
  Simulator two(usual, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, 0.5 * kPi), 5);
  Observation a;
  Observation b;
  one.change_light();
  for (int frame = 0; frame < 5; ++frame) {
    one.observe(a);
    two.observe(b);
    ASSERT_EQ(upper_bytes(a), upper_bytes(b)) << "frame " << frame;
  }
}

TEST(ChangedLight, DependsOnlyOnTheSeed) {
  Observation a;
  Observation b;
  for (const std::uint64_t other : {5u, 6u}) {
    Simulator one(hard_simulator(), RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, 0.5 * kPi), 5);
    Simulator two(hard_simulator(), RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, 0.5 * kPi), other);
    one.change_light();
    two.change_light();
    for (int frame = 0; frame < 20; ++frame) {
      one.observe(a);
      two.observe(b);
    }
    EXPECT_EQ(upper_bytes(a) == upper_bytes(b), other == 5u);
  }
}

TEST(ChangedLight, IsNotCompensatedByTheAutomaticExposure) {
  SimulatorParameters parameters = hard_simulator();
  parameters.light = {};
  parameters.light.exposure_spread = 0.5;
  const auto settled = [&](bool change, std::uint64_t seed) {
    Simulator simulator(parameters, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, 0.5 * kPi), seed);
    Observation observation;
    if (change) simulator.change_light();
    for (int frame = 0; frame < 90; ++frame) simulator.observe(observation);
    return mean_luma(observation.upper->image);
  };
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    HallLight light(parameters.light, 7.0, seed);
    light.change();
    const double gain = light.gains().y();
    EXPECT_EQ(settled(true, seed) > settled(false, seed), gain > 1.0) << "seed " << seed;
  }
}

TEST(ChangedLight, ReplacesSomeOfThePeople) {
  const auto people = [](double exchanged) {
    Spectators spectators(36, RoomShape{}, FieldDimensions{}, LinearColor::Ones(), 4);
    spectators.exchange(exchanged);
    Scene scene;
    spectators.add_to(scene, 0.0);
    std::set<std::pair<float, float>> places;
    for (const Shadow& shadow : scene.shadows) places.insert({shadow.center.x(), shadow.center.y()});
    return places;
  };
  const auto before = people(0.0);
  const auto after = people(0.5);
  std::vector<std::pair<float, float>> stayed;
  std::set_intersection(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(stayed));
  EXPECT_EQ(before.size(), after.size());
  EXPECT_NEAR(static_cast<double>(stayed.size()) / static_cast<double>(before.size()), 0.5, 0.25);
}

TEST(Spectators, StandOnBothSidesOfASymmetricRoom) {
  for (const RoomSymmetry symmetry : {RoomSymmetry::two_fold, RoomSymmetry::four_fold}) {
    RoomShape shape;
    shape.symmetry = symmetry;
    Spectators spectators(36, shape, FieldDimensions{}, LinearColor::Ones(), 4);
    spectators.exchange(0.5);
    Scene scene;
    spectators.add_to(scene, 12.3);
    ASSERT_GT(scene.capsules.size(), 100u);
    const auto has = [&](const Capsule& wanted) {
      return std::any_of(scene.capsules.begin(), scene.capsules.end(), [&](const Capsule& capsule) {
        const auto reflected = [](const Eigen::Vector3f& point) {
          return Eigen::Vector3f(-point.x(), -point.y(), point.z());
        };
        return (reflected(capsule.from) - wanted.from).norm() < 1e-4f &&
               (reflected(capsule.to) - wanted.to).norm() < 1e-4f && (capsule.color == wanted.color).all();
      });
    };
    for (const Capsule& capsule : scene.capsules) EXPECT_TRUE(has(capsule));
  }
}

}  // namespace
}  // namespace reorient
