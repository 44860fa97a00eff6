// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/camera_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/workbench/pictures/pixels.h"
#include "workbench/views/pictures/canvas/ycbcr.h"
#include "workbench/views/scene/camera_overlay.h"
#include "workbench/views/scene/field_scene.h"
#include "workbench/views/scene/histogram.h"

namespace reorient::pictures {
namespace {

// Uniform, so that only the drawn objects differ from it.
Image plain_image(int width, int height, Ycbcr color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width / 2; ++x) {
      std::uint8_t* pair = image.row(y) + 4 * static_cast<std::ptrdiff_t>(x);
      pair[0] = pair[2] = color.y;
      pair[1] = color.cb;
      pair[3] = color.cr;
    }
  }
  return image;
}

constexpr Ycbcr kSkin{150, 110, 150};

/// The camera of a robot at the origin that looks horizontally along x, 0.5 m above the ground.
CameraModel camera_of(const Image& image) {
  return CameraModel::from_fields_of_view(image.width(), image.height(), 1.0, 0.8);
}
const Isometry3 kRobotFromCamera = Isometry3(Eigen::Translation3d(0.0, 0.0, 0.5));

/// The view of a frame with this overlay.
CameraView view_of(const Image& image, scene::Overlay overlay) { return {image.view(), 0.0, std::move(overlay)}; }

/// A frame that looks through the upper camera at the wall.
FrameRecord frame_with(const Image& image) {
  FrameRecord frame;
  frame.inputs.upper.emplace();
  frame.inputs.upper->camera = camera_of(image);
  frame.inputs.upper->robot_from_camera = kRobotFromCamera;
  frame.room.model.resize(static_cast<std::size_t>(Wall(frame.room.basis.wall).tiles()));
  return frame;
}

TEST(CameraView, ShowsTheImageInItsColorsAtAnyResolution) {
  for (const int width : {160, 320, 640, 1280}) {
    const Image image = plain_image(width, width * 3 / 4, kSkin);
    CameraView camera;
    camera.image = image.view();
    const Picture picture = draw_camera_view(camera);
    EXPECT_EQ(picture.width, 1280);
    EXPECT_GE(picture.height, 960);
    EXPECT_EQ(count(picture, to_color(kSkin), 0, 0, 1280, 960), 1280 * 960);
  }
}

TEST(CameraView, DrawsMarksAtTheirPixels) {
  const Image image = plain_image(320, 240, kSkin);
  FieldPercept percept;
  // A point on the ground ahead of the robot.
  percept.line_points.resize(1);
  percept.line_points[0].position = {1.5, 0.0};
  percept.line_points[0].normal = kPi / 2.0;
  const CameraModel camera = camera_of(image);
  percept.line_points[0].pixel =
      camera.project(kRobotFromCamera.inverse() * Eigen::Vector3d(1.5, 0.0, 0.0))->cast<float>();
  percept.goal_posts = {{{3.0, 1.0}, true, {50.0F, 200.0F}, {50.0F, 100.0F}}};
  const Picture picture = draw_camera_view(view_of(image, scene::percept_overlay(percept, camera, kRobotFromCamera)));
  // Pixel (0, 0) of the image is the center of a square of 4 x 4 here.
  const Eigen::Vector2i point =
      (4.0 * percept.line_points[0].pixel.cast<double>() + Eigen::Vector2d(2.0, 2.0)).cast<int>();
  EXPECT_TRUE(is_similar(picture.at(point.x(), point.y()), palette::percept));
  EXPECT_TRUE(is_similar(picture.at(point.x() - 9, point.y()), palette::percept, 90));  // along the normal
  EXPECT_TRUE(is_similar(picture.at(point.x(), point.y() + 9), to_color(kSkin)));
  EXPECT_TRUE(is_similar(picture.at(202, 802), palette::goal_area));
  EXPECT_TRUE(is_similar(picture.at(202, 600), palette::goal_area));
  EXPECT_TRUE(is_similar(picture.at(202, 380), to_color(kSkin)));
}

TEST(CameraView, DrawsViewParticlesWhereTheirAzimuthIsSeen) {
  const Image image = plain_image(320, 240, kSkin);
  FrameRecord frame = frame_with(image);
  frame.room.particles = {{0.0, 1.0}, {0.3, 1.0}};
  const Picture picture = draw_camera_view(view_of(image, scene::room_overlay(frame, HeadCamera::upper)));
  EXPECT_GT(count(picture, palette::view_particle, 620, 460, 660, 500), 20);
  EXPECT_GT(count(picture, palette::view_particle, 0, 460, 600, 500), 20);  // to the left
  EXPECT_EQ(count(picture, palette::view_particle, 680, 0, 1280, 960), 0);
}

TEST(CameraView, DrawsCellsOfAGridByTheirFraction) {
  const Image image = plain_image(320, 240, kSkin);
  FrameRecord frame = frame_with(image);
  frame.room.cells = {{0.3, 0.4}, {-0.3, 0.1}, {0.0, 0.001}};
  const Picture picture = draw_camera_view(view_of(image, scene::room_overlay(frame, HeadCamera::upper)));
  const int greatest = count(picture, palette::view_particle, 0, 0, 620, 960);
  EXPECT_GT(greatest, 300);
  EXPECT_NEAR(count(picture, palette::view_particle, 660, 0, 1280, 960), 0.25 * greatest, 0.125 * greatest);
  EXPECT_EQ(count(picture, palette::view_particle, 620, 0, 660, 960), 0);
}

TEST(CameraView, DrawsAChartOnlyInTilesThatCount) {
  const Image image = plain_image(640, 480, kSkin);
  const Wall wall;
  PerceivedTile tile;
  tile.tile = wall.tile(0, 0);
  tile.counts = true;
  tile.histogram[9] = 0.6F;
  const auto drawn = [&] {
    return draw_camera_view(
        view_of(image, {scene::perceived_tiles({&tile, 1}, wall, camera_of(image), kRobotFromCamera)}));
  };
  EXPECT_GT(count(drawn(), scene::bin_color(9), 0, 0, 1280, 960), 50);
  tile.counts = false;
  const Picture uncounted = drawn();
  EXPECT_EQ(count(uncounted, scene::bin_color(9), 0, 0, 1280, 960), 0);
  EXPECT_LT(count(uncounted, to_color(kSkin), 0, 0, 1280, 960), 1280 * 960 - 100);  // its outline
}

TEST(CameraView, ProjectsTheLinesOfTheField) {
  const Image image = plain_image(320, 240, kSkin);
  const FieldDimensions field;
  const CameraModel camera = camera_of(image);
  const scene::OverlayLayer lines = scene::expected_lines(field, camera, kRobotFromCamera);
  const Picture picture = draw_camera_view(view_of(image, {lines}));
  for (const double x : {field.length / 2.0, field.length / 2.0 - field.penalty_area_depth}) {
    const auto pixel = camera.project(kRobotFromCamera.inverse() * Eigen::Vector3d(x, 0.5, 0.0));
    ASSERT_TRUE(pixel);
    const Eigen::Vector2i at = (4.0 * *pixel + Eigen::Vector2d(2.0, 2.0)).cast<int>();
    EXPECT_TRUE(is_similar(picture.at(at.x(), at.y()), palette::expected, 40)) << x;
  }
  // A pinhole camera keeps lines straight, so their ends are enough, with some points where they leave the image.
  std::size_t points = 0;
  for (const auto& line : lines.shapes) points += line.points.size();
  EXPECT_LT(points, 150U);
}

TEST(CameraView, LeavesAGapInTheBoundaryIfNoFieldIsInView) {
  const Image image = plain_image(320, 240, kSkin);
  FieldPercept percept;
  percept.boundary.assign(40, 100.0F);
  for (std::size_t i = 10; i < 30; ++i) percept.boundary[i] = 240.0F;
  const Picture picture =
      draw_camera_view(view_of(image, scene::percept_overlay(percept, camera_of(image), kRobotFromCamera)));
  EXPECT_GT(count(picture, palette::boundary, 100, 396, 200, 410), 100);
  EXPECT_GT(count(picture, palette::boundary, 1080, 396, 1180, 410), 100);
  EXPECT_EQ(count(picture, palette::boundary, 400, 0, 880, 960), 0);
}

TEST(CameraView, NeverDrawsOverTheLegend) {
  const Image image = plain_image(640, 480, kSkin);
  const CameraModel camera = camera_of(image);
  FieldPercept percept;
  percept.obstacles = {{{2.0, 0.0}, 100, 500, 400, 10000}};
  scene::Overlay overlay = scene::percept_overlay(percept, camera, kRobotFromCamera);
  overlay.push_back(scene::polylines("lines", {{{320.0, 100.0}, {321.0, 1e7}}, {{-1e9, 300.0}, {1e9, 300.0}}},
                                     palette::expected, 1.5, camera));
  const Picture picture = draw_camera_view(view_of(image, overlay));
  EXPECT_GT(count(picture, palette::page, 600, 961, 1280, picture.height), 680 * 70);
  EXPECT_GT(count(picture, palette::page, 640, 962, 660, picture.height), 20 * 70);
  EXPECT_LT(count(picture, to_color(kSkin), 0, 600, 1280, 602), 600);  // the endless line is drawn
}

TEST(CameraView, DrawsWithoutAnImage) {
  const Picture picture = draw_camera_view({});
  EXPECT_EQ(count(picture, palette::plate, 0, 0, 1280, 960), 1280 * 960);
}

TEST(CameraView, OmitsValuesThatAreNotFinite) {
  const Image image = plain_image(320, 240, kSkin);
  const CameraModel camera = camera_of(image);
  const Eigen::Vector2d bad(kNaN, 10.0);
  const Eigen::Vector2f bad_pixel = bad.cast<float>();
  FrameRecord frame = frame_with(image);
  frame.world.pose.pose = Pose2(kNaN, kNaN, kNaN);
  frame.room.particles = {{kNaN, 1.0}};
  frame.room.cells = {{kNaN, 1.0}, {0.0, kNaN}};
  frame.room.perceived.resize(1);
  frame.percepts[0].line_points = {{bad, kNaN, bad_pixel}};
  frame.percepts[0].goal_posts = {{bad, true, bad_pixel, bad_pixel}};
  frame.percepts[0].boundary.assign(4, std::numeric_limits<float>::quiet_NaN());
  frame.percepts[0].ball.emplace();
  frame.percepts[0].ball->pixel = bad_pixel;
  frame.percepts[0].ball->radius = 3.0F;
  scene::Overlay overlay = scene::room_overlay(frame, HeadCamera::upper);
  for (const scene::OverlayLayer& layer : scene::field_overlay(frame, HeadCamera::upper)) overlay.push_back(layer);
  overlay.push_back(
      scene::polylines("lines", {{bad, bad}, {}, {bad, {1.0, 1.0}, {50.0, 60.0}}}, palette::expected, 1.5, camera));
  scene::OverlayLayer shapes{"shapes"};
  shapes.shapes.push_back({{bad, bad, bad}, palette::obstacle, 2.0, true, palette::obstacle});
  shapes.shapes.push_back({{bad, {1.0, 1.0}, {50.0, 60.0}}, palette::tile_outline, 2.0, true, {0, 0, 0, 0.0}, true});
  shapes.circles = {{bad, 4.0, palette::percept}, {{10.0, 10.0}, kNaN, palette::percept}};
  overlay.push_back(shapes);
  const Picture picture = draw_camera_view(view_of(image, overlay));
  // Everything except the one side of two shapes that has two valid ends.
  EXPECT_GT(count(picture, to_color(kSkin), 0, 0, 1280, 960), 1280 * 960 - 3000);
  EXPECT_EQ(count(picture, to_color(kSkin), 240, 0, 1280, 960), 1040 * 960);
}

}  // namespace
}  // namespace reorient::pictures
