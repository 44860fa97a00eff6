// SPDX-License-Identifier: MIT
// The color of the carpet, and its border.
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "perception/field/field_features.h"
#include "tests/perception/field/stand.h"

namespace reorient {
namespace {

const int kPatience = FieldFeatureParameters().carpet_patience;

TEST(FieldFeatures, DoNotMistakeAnythingBeyondTheBorderForCarpetWhateverItsColor) {
  FlatField scene;
  const Stand here(640, 480, {0.0, 0.0, 0.0}, {0.0, 0.0});
  const FieldPercept bare = percept_of(scene, here);
  scene.boxes = {{{6.0, 2.2}, 1.2, 0.4, scene.colors.carpet}};  // a low banner
  const FieldPercept percept = percept_of(scene, here);
  ASSERT_EQ(percept.boundary.size(), bare.boundary.size());
  for (std::size_t i = 0; i < bare.boundary.size(); ++i) EXPECT_NEAR(percept.boundary[i], bare.boundary[i], 8.0) << i;
}

TEST(FieldFeatures, DistinguishCarpetFromAGrayWallInTintedLight) {
  FlatField scene;
  scene.colors = {{60, 116, 106}, {200, 128, 88}, {60, 128, 116}, {200, 128, 88}};  // cyan: white is -40, gray -12
  const Stand here(640, 480, {0.0, 0.0, 0.0}, {0.0, 0.1});
  const FieldPercept percept = percept_after(scene, here, 5);
  const auto border = here.camera.project(here.robot_from_camera.inverse() * Eigen::Vector3d(5.2, 0.0, 0.0));
  ASSERT_TRUE(border);
  EXPECT_NEAR(percept.boundary[CarpetMap::kColumns / 2], border->y(), 4.0);
  EXPECT_GE(percept.line_points.size(), 30u);
}

TEST(FieldFeatures, KeepTheCarpetsColorWhileNoCarpetIsInView) {
  const FlatField scene = FlatField::with_goals();
  const Stand down(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  const Stand up(320, 240, {-2.0, 0.0, 0.0}, {0.0, -0.6});
  FieldFeatures features({}, scene.field);
  const Image carpet = down.see(scene);
  const Image room = up.see(scene);
  percept_in(features, carpet.view(), down.camera, down.robot_from_camera);
  percept_in(features, room.view(), up.camera, up.robot_from_camera);
  EXPECT_EQ(features.carpet_color().surface(160, 200, {75, 105, 108}), Surface::carpet);
  EXPECT_EQ(features.carpet_color().surface(160, 200, {190, 126, 130}), Surface::other);
}

TEST(FieldFeatures, DoNotMistakeAGrayHallForCarpet) {
  const FlatField scene = FlatField::with_goals();
  const Stand down(160, 120, {3.0, 0.8, 0.0}, {0.0, 0.25});
  const Stand close(160, 120, {3.6, 0.8, 0.0}, {0.0, -0.05});
  FieldFeatures features({}, scene.field);
  const Image carpet = down.see(scene);
  const Image hall = close.see(scene);
  percept_in(features, carpet.view(), down.camera, down.robot_from_camera);
  for (int i = 0; i < 20; ++i) percept_in(features, hall.view(), close.camera, close.robot_from_camera);
  EXPECT_NEAR(features.carpet_color().luma(), 75.0, 15.0);
  EXPECT_EQ(features.carpet_color().surface(80, 100, {95, 132, 134}), Surface::other);
}

TEST(FieldFeatures, SeeTheSameLinesOnACarpetOfAnyColor) {
  const Stand here(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  const std::size_t on_green = percept_after(scene, here, 5).line_points.size();
  ASSERT_GE(on_green, 20u);
  // Yellowish, cyan, blue, red, gray; then green whose lines are as red, as blue, or as green as it.
  for (const auto& [carpet, line] : {std::pair{Ycbcr{75, 100, 126}, Ycbcr{190, 126, 130}},
                                     {{75, 134, 108}, {190, 126, 130}},
                                     {{75, 150, 118}, {190, 126, 130}},
                                     {{75, 118, 160}, {190, 126, 130}},
                                     {{75, 128, 128}, {190, 128, 128}},
                                     {{75, 110, 116}, {190, 115, 165}},
                                     {{75, 110, 116}, {190, 165, 115}},
                                     {{75, 105, 108}, {190, 105, 108}}}) {
    scene.colors.carpet = carpet;
    scene.colors.line = line;
    const FieldPercept percept = percept_after(scene, here, kPatience + 5);
    EXPECT_GE(percept.line_points.size(), on_green * 9 / 10)
        << int{carpet.cb} << " " << int{carpet.cr} << ", lines " << int{line.cb} << " " << int{line.cr};
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST(FieldFeatures, DoNotMistakeBrightCarpetForALineAfterLearningWhite) {
  const Stand here(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  FieldFeatures features({}, scene.field);
  const Image lines = here.see(scene);
  percept_in(features, lines.view(), here.camera, here.robot_from_camera);
  scene.colors.line = {150, 84, 90};  // sunlit carpet
  const Image sunlit = here.see(scene);
  EXPECT_TRUE(percept_in(features, sunlit.view(), here.camera, here.robot_from_camera).line_points.empty());
}

TEST(FieldFeatures, AcceptAFloorAsCarpetOnlyAfterSomeImagesWithoutCarpet) {
  const Stand here(160, 120, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  scene.colors.carpet = {110, 108, 150};  // wood
  EXPECT_TRUE(is_empty(percept_after(scene, here, kPatience - 1)));
  EXPECT_FALSE(is_empty(percept_after(scene, here, kPatience)));
}

TEST(FieldFeatures, ReplaceTheirCarpetByAnotherGreenAtOnceAndByAFloorLater) {
  const Stand here(160, 120, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  FieldFeatures features({}, scene.field);
  const auto look = [&](const Ycbcr& carpet, int images) {
    scene.colors.carpet = carpet;
    const Image image = here.see(scene);
    for (int i = 0; i < images; ++i) percept_in(features, image.view(), here.camera, here.robot_from_camera);
    return features.carpet_color().surface(80, 100, carpet);
  };
  constexpr Ycbcr kGreen{75, 105, 108}, kDarkGreen{40, 118, 112}, kWood{110, 108, 150}, kOlive{70, 121, 126};
  look(kGreen, 1);
  EXPECT_EQ(look(kOlive, 20), Surface::other);
  EXPECT_EQ(look(kDarkGreen, 1), Surface::carpet);
  EXPECT_EQ(look(kWood, 250), Surface::other);
  EXPECT_EQ(look(kWood, 60), Surface::carpet);
  EXPECT_EQ(look(kGreen, 1), Surface::carpet);
}

TEST(FieldFeatures, ThatWereSavedContinueTheSameWithoutGroundInView) {
  const Stand here(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25}), up(320, 240, {-2.0, 0.0, 0.0}, {0.0, -0.6});
  FlatField scene;
  scene.colors.carpet = {75, 110, 116};
  scene.colors.line = {190, 115, 165};  // white is learned behind the carpet
  FieldFeatures one({}, scene.field), other({}, scene.field);
  const Image lines = here.see(scene), room = up.see(scene);
  percept_in(one, lines.view(), here.camera, here.robot_from_camera);
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(one);
  ByteReader reader(bytes);
  reader(other);
  for (FieldFeatures* each : {&one, &other}) percept_in(*each, room.view(), up.camera, up.robot_from_camera);
  for (int cb = 64; cb < 192; cb += 2) {
    for (int cr = 64; cr < 192; cr += 2) {
      const Ycbcr color{70, static_cast<std::uint8_t>(cb), static_cast<std::uint8_t>(cr)};
      ASSERT_EQ(one.carpet_color().surface(160, 200, color), other.carpet_color().surface(160, 200, color));
    }
  }
}

}  // namespace
}  // namespace reorient
