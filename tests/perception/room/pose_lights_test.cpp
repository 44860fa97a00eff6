// SPDX-License-Identifier: MIT
#include "perception/room/evidence/pose_lights.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

/// A wall of twelve tiles. Its front half is bright and reddish, its back half dark and bluish.
struct TwoHalves {
  TwoHalves() {
    WallParameters shape;
    shape.rows = 1;
    shape.columns = 12;
    wall = Wall(shape);
    model.forget(12);
    lights.restart(12);
    for (int tile = 0; tile < 12; ++tile) model.train_light(tile, own(tile), {(1.0 / 30.0), 100.0, true, 0.0});
  }
  static RelativeLight own(int tile) {
    return tile < 6 ? RelativeLight{1.4, -4.0, 6.0} : RelativeLight{0.6, 4.0, -6.0};
  }
  /// The tiles first...last as seen in a light. With a wrong belief, each of them is its reflection.
  std::vector<TileLight> view(int first, int last, const Light& room, bool belief_is_right) const {
    std::vector<TileLight> frame;
    for (int tile = first; tile <= last; ++tile) {
      const RelativeLight light = own(belief_is_right ? tile : wall.reflected(tile));
      constexpr int kPixels = 50;
      frame.push_back({tile,
                       {kPixels * room.luma * light.luma, kPixels * (room.cb + light.cb),
                        kPixels * (room.cr + light.cr), kPixels}});
    }
    return frame;
  }
  void look(int first, int last, const Light& room, bool belief_is_right) {
    for (int frame = 0; frame < 30; ++frame)
      lights.observe(view(first, last, room, belief_is_right), mean, model, wall, (1.0 / 30.0), parameters);
  }

  Wall wall;
  BackgroundModel model;
  PoseLights lights;
  PoseLightParameters parameters;
  Light mean;
};

TEST(PoseLights, AreTheMeanLightWithoutKnownTiles) {
  TwoHalves room;
  room.model.forget(12);
  room.mean = {90.0, 131.0, 122.0};
  room.look(0, 3, {150.0, 120.0, 140.0}, true);
  EXPECT_EQ(room.lights.if_believed().luma, 90.0);
  EXPECT_EQ(room.lights.if_reflected().cr, 122.0);
}

TEST(PoseLights, AreTheLightThatThePoseImplies) {
  TwoHalves room;
  room.parameters.caution = 0.0;
  const Light now{92.0, 131.0, 124.0};
  room.look(0, 5, now, true);
  EXPECT_NEAR(room.lights.if_believed().luma, now.luma, 1e-6);
  EXPECT_NEAR(room.lights.if_believed().cb, now.cb, 1e-6);
  EXPECT_NEAR(room.lights.if_believed().cr, now.cr, 1e-6);
  EXPECT_GT(room.lights.if_reflected().luma, 1.5 * now.luma) << "the dark half implies a bright light";
}

TEST(PoseLights, WeightTheMeanLightAsSomeTiles) {
  TwoHalves room;
  room.parameters.caution = 6.0;
  room.look(0, 5, {230.0 / std::exp(0.5), 128.0, 128.0}, true);
  EXPECT_NEAR(std::log(room.lights.if_believed().luma / 115.0), 0.5 * (std::log(2.0) - 0.5), 1e-6);
}

TEST(PoseLights, StayWithinTheLimitsAroundTheMeanLight) {
  TwoHalves room;
  room.parameters.caution = 0.0;
  room.look(0, 5, {10.0, 20.0, 240.0}, true);
  EXPECT_GE(room.lights.if_believed().luma, 115.0 * std::exp(-room.parameters.most_luma) - 1e-9);
  EXPECT_GE(room.lights.if_believed().cb, 128.0 - room.parameters.most_chroma);
  EXPECT_LE(room.lights.if_believed().cr, 128.0 + room.parameters.most_chroma);
}

TEST(PoseLights, AreExchangedWhenTheBeliefIsReflected) {
  TwoHalves room;
  room.look(0, 5, {100.0, 130.0, 126.0}, false);
  const Light believed = room.lights.if_believed();
  const Light reflected = room.lights.if_reflected();
  room.lights.reflect(room.wall);
  EXPECT_EQ(room.lights.if_believed().luma, reflected.luma);
  EXPECT_EQ(room.lights.if_reflected().cb, believed.cb);
  room.look(6, 11, {100.0, 130.0, 126.0}, true);
  EXPECT_NEAR(room.lights.if_believed().luma, reflected.luma, 1e-6) << "the same tiles with their new numbers";
}

TEST(PoseLights, ForgetTilesThatWereNotInViewForLong) {
  TwoHalves room;
  room.parameters.caution = 0.0;
  room.look(0, 5, {150.0, 128.0, 128.0}, true);
  for (int frame = 0; frame < 300; ++frame)
    room.lights.observe({}, room.mean, room.model, room.wall, (1.0 / 30.0), room.parameters);
  EXPECT_EQ(room.lights.if_believed().luma, room.mean.luma);
}

}  // namespace
}  // namespace reorient
